#!/usr/bin/env bash
# Prints the CMAKE_PREFIX_PATH of a Trilinos with Kokkos for OpenMP and Teuchos: the user's own
# (CMAKE_PREFIX_PATH, Trilinos_ROOT, Kokkos_ROOT), else one in the cache, else builds that from the
# source package of the distribution, whose binary package has no OpenMP.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/.ci/common.sh"

version=13.2
# Only what brisance uses; no Fortran, MPI or BLAS is needed for it.
options=(
  -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG"  # nothing here runs often; half the time to build
  -D CMAKE_CXX_STANDARD=17
  -D CMAKE_POSITION_INDEPENDENT_CODE=ON
  -D BUILD_SHARED_LIBS=OFF
  -D Trilinos_ENABLE_ALL_PACKAGES=OFF
  -D Trilinos_ENABLE_ALL_OPTIONAL_PACKAGES=OFF
  -D Trilinos_ENABLE_SECONDARY_TESTED_CODE=OFF
  -D Trilinos_ENABLE_Kokkos=ON
  -D Trilinos_ENABLE_TeuchosParameterList=ON
  -D Trilinos_ENABLE_OpenMP=ON
  -D Trilinos_ENABLE_Fortran=OFF
  -D Trilinos_ENABLE_TESTS=OFF
  -D Trilinos_ENABLE_EXAMPLES=OFF
  -D Kokkos_ENABLE_OPENMP=ON
  -D Kokkos_ENABLE_SERIAL=ON
  -D TPL_ENABLE_MPI=OFF
  -D TPL_ENABLE_BLAS=OFF
  -D TPL_ENABLE_LAPACK=OFF
  -D PYTHON_EXECUTABLE=
)

# ---- The user's own ----
IFS=':;' read -ra prefixes <<<"${CMAKE_PREFIX_PATH:-}:${Trilinos_ROOT:-}:${Kokkos_ROOT:-}"
# find_header NAME prints the first include folder below the user's prefixes that has it.
find_header() {
  local prefix folder
  for prefix in "${prefixes[@]}"; do
    for folder in "${prefix:-/nonexistent}"/include{,/*}; do
      if [[ -e $folder/$1 ]]; then
        echo "$folder/$1"
        return
      fi
    done
  done
}
kokkos=$(find_header KokkosCore_config.h)
refused=
if [[ -n $kokkos ]]; then
  number=$(sed -n 's/^#define KOKKOS_VERSION \([0-9]*\).*/\1/p' "$kokkos")
  if ! grep -q '^#define KOKKOS_ENABLE_OPENMP\b' "$kokkos"; then
    refused="the Kokkos of $kokkos has no OpenMP"
  elif ((${number:-0} < 30400)); then
    refused="the Kokkos of $kokkos is older than 3.4"
  elif [[ -z $(find_header Teuchos_ParameterList.hpp) ]]; then
    refused="there is no Teuchos beside the Kokkos of $kokkos"
  else
    printf '%s\n' "${prefixes[@]}" | sed '/^$/d' | paste -sd ';'
    exit 0
  fi
fi

# ---- In the cache ----
find_cache "$root"
compiler=$(${CXX:-c++} -dumpfullversion -dumpmachine 2>/dev/null) ||
  die "no C++ compiler ${CXX:-c++} was found: install g++, or set CXX to yours"
key=$(sha256sum <<<"$version ${CXX:-c++} $compiler ${options[*]}")
prefix=$cache/trilinos-$version-${key:0:12}
if [[ -e $prefix/complete ]]; then
  echo "$prefix"
  exit 0
fi
[[ -z $refused ]] || say "$refused: making one that fits"

exec 9>"$cache/lock"
if ! flock -n 9; then
  say "waiting for another run that builds Trilinos ..."
  flock 9
  if [[ -e $prefix/complete ]]; then
    echo "$prefix"
    exit 0
  fi
fi

# ---- Fetched through apt's chain of signatures: its sources and keys, but lists of our own ----
work=$cache/work
log=$cache/trilinos.log
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
rm -rf "$work"
free_space "$cache" 600
mkdir -p "$work"/{sources,lists/partial,archives/partial,source,stage}
: >"$log"
LIST='' PARTS=''
eval "$(apt-config shell LIST Dir::Etc::sourcelist/f PARTS Dir::Etc::sourceparts/d)"
for file in "$LIST" "$PARTS"/*.list "$PARTS"/*.sources; do
  [[ -r $file ]] || continue
  copy=$work/sources/${file##*/}
  case $file in
    *.sources) sed 's/^Types:.*/Types: deb-src/I' "$file" >"$copy" ;;
    *) sed -nE 's/^\s*deb(-src)?\s/deb-src /p' "$file" | sort -u >"$copy" ;;
  esac
done
apt=(-q -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/sources"
  -o Dir::State="$work" -o Dir::State::lists="$work/lists"
  -o Dir::State::status=/var/lib/dpkg/status -o Dir::Cache="$work" -o APT::Sandbox::User=
  -o Acquire::Retries=2 -o Acquire::Languages=none)
say "fetching the source of Trilinos $version (170 MB) ..."
cd "$work"
apt-get "${apt[@]}" update >>"$log" 2>&1 || true
package=$(apt-cache "${apt[@]}" showsrc trilinos 2>>"$log" |
  awk -v start="$version." '/^Version:/ && index($2, start) == 1 { found = $2 }
                            END { print found }' || true)
if [[ -z $package ]]; then
  grep -q 'Failed to fetch' "$log" || echo "E: this distribution does not have it" >"$log"
  die "no source of Trilinos $version: $(reason "$log"); or name a Trilinos of yours, with Kokkos" \
    "for OpenMP and Teuchos, in CMAKE_PREFIX_PATH"
fi
apt-get "${apt[@]}" --download-only --only-source source "trilinos=$package" >>"$log" 2>&1 ||
  die "the source of Trilinos could not be fetched: $(reason "$log")"

# ---- Built, installed beside its final place, then moved there in one step ----
say "building Trilinos $version, Kokkos and Teuchos only (about 2 minutes, once) ..."
{
  tar -xaf trilinos_*.orig.tar.* -C source --strip-components=1 --wildcards --exclude '*/test/*' \
    --exclude '*/doc/*' '*/cmake/*' '*.cmake' '*/CMakeLists.txt' '*/packages/kokkos/*' \
    '*/packages/teuchos/*' '*/README*' '*/LICENSE*' '*/Copyright.txt' &&
    env -u CMAKE_PREFIX_PATH cmake -G Ninja -S source -B build "${options[@]}" \
      -D CMAKE_INSTALL_PREFIX="$prefix" &&
    cmake --build build -j "$(compile_jobs)" &&
    DESTDIR=$work/stage cmake --install build
} >"$log" 2>&1 || die "Trilinos could not be built: $(reason "$log")"
echo "Trilinos $package, $compiler" >"$work/stage$prefix/complete"
rm -rf "$prefix"
mv "$work/stage$prefix" "$prefix"
echo "$prefix"
