#!/usr/bin/env bash
# packages.sh PACKAGE... installs those of the named Debian packages that are missing.
# BRISANCE_NO_PACKAGES=1 leaves that to you (modules of a cluster, another distribution).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/.ci/common.sh"

[[ -z ${BRISANCE_NO_PACKAGES:-} ]] || exit 0
if ! { command -v dpkg-query && command -v apt-get; } >/dev/null; then
  die "this is neither Debian nor Ubuntu: install the counterparts of these Debian packages and" \
    "set BRISANCE_NO_PACKAGES=1: $*"
fi

present=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' "$@" 2>/dev/null || true)"
missing=()
for package in "$@"; do
  [[ $present == *" installed:$package "* ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

become_root=()
if ((EUID != 0)); then
  # Without a terminal nobody can type the password that sudo may want.
  if ! command -v sudo >/dev/null || { [[ ! -t 0 ]] && ! sudo -n true 2>/dev/null; }; then
    die "packages are missing and only root may install them; as root:" \
      "apt-get install ${missing[*]}"
  fi
  become_root=(sudo)
fi

find_cache "$root"
log=$cache/packages.log
exec 9>"$cache/packages.lock"
flock 9
: >"$log"
apt() {
  "${become_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    -o DPkg::Lock::Timeout=300 -o Acquire::Retries=2 "$@" >>"$log" 2>&1 </dev/null
}
say "installing ${missing[*]} ..."
# One broken source of the user's need not matter: only the installation decides.
apt update || true
apt install --no-install-recommends "${missing[@]}" ||
  die "apt-get could not install ${missing[*]}: $(reason "$log")"
