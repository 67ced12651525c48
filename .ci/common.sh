# Sourced by the launcher and by the scripts beside it.
# shellcheck shell=bash disable=SC2034

say() { echo "brisance: $*" >&2; }
die() {
  say "$*"
  exit 1
}

# Nothing stops without a word.
trap 'say "stopped at line $LINENO of $0"' ERR

# Sets `cache`, the folder for what is made once and for logs: the user's own, else one in the
# checkout when that cannot be written.
find_cache() {
  cache=${XDG_CACHE_HOME:-${HOME:-/nonexistent}/.cache}/brisance
  if ! { mkdir -p "$cache" && [[ -w $cache ]]; } 2>/dev/null; then
    cache=$1/build/cache
    mkdir -p "$cache" 2>/dev/null ||
      die "neither ~/.cache nor $1 can be written: set XDG_CACHE_HOME to a folder that can"
  fi
}

# free_space FOLDER MEGABYTES
free_space() {
  local free
  free=$(df -Pm "$1" | awk 'NR == 2 { print $4 }')
  ((free >= $2)) || die "$1 has $free MB free and $2 MB are needed: free some, or set" \
    "XDG_CACHE_HOME to a folder on another disk"
}

# Why the commands that wrote LOG failed, and what to do, on one line.
reason() {
  case $(<"$1") in
    *"enough free space"* | *"No space left"*) echo "the disk is full: free some space ($1)" ;;
    *"Failed to fetch"* | *"Unable to fetch"*)
      echo "the package server cannot be reached: connect to the network ($1)" ;;
    *"Killed signal"*) echo "the memory is too small: close other programs ($1)" ;;
    *) echo "$(grep -E '^E:|rror: |undefined reference' "$1" | head -n 1 | cut -c1-200) ($1)" ;;
  esac
}

# One compiler takes up to 1.5 GB.
compile_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo)
  echo $((memory < 1 ? 1 : memory < cores ? memory : cores))
}
