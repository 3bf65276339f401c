# shellcheck shell=bash
# What run, test, bench and .ci/run share: packages, configuring, building. Sourced, by bash.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

say() { printf 'parti: %s\n' "$*" >&2; }
give_up() {
  printf 'parti: error: %s\n  hint: %s\n' "$1" "$2" >&2
  exit 1
}

# packages_for GROUP…: the names in .ci/packages of these groups.
packages_for() {
  local group
  for group in "$@"; do awk -v group="$group" '$1 !~ /^#/ && $2 == group { print $1 }' .ci/packages; done
}

# as_root COMMAND…: through sudo where we aren't root; never a question without a terminal.
as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; elif [ -t 0 ]; then sudo "$@"; else sudo -n "$@"; fi
}

# need_packages GROUP…: installs what is missing, saying what; asks only dpkg where nothing is.
need_packages() {
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: .ci/packages lists what has to be installed"
    return
  fi
  local wanted missing
  mapfile -t wanted < <(packages_for "$@")
  mapfile -t missing < <(comm -23 <(printf '%s\n' "${wanted[@]}" | sort) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null |
      sed -n 's/^installed //p' | sort -u))
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing Debian packages: ${missing[*]}"
  as_root true ||
    give_up "installing packages needs root, and sudo is not there or refuses" \
      "as root: apt-get install --no-install-recommends ${missing[*]}"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2 ||
    give_up "apt-get update failed" "read its messages above; is the network there?"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends \
    "${missing[@]}" >&2 ||
    give_up "apt-get could not install ${missing[*]}" "Parti is built on Debian 12 (bookworm)"
}

# How many compilers fit: one per core, and 1.5 GB of memory for each (CGAL's headers are large).
jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  echo $((cores < memory ? cores : memory))
}

# configure PRESET [PARTI_OPTION]…: a new build folder has tests and benchmarks off; the options
# named are switched on, once. Nothing is configured twice.
configure() {
  local preset=$1 option options=()
  shift
  [ -f "build/$preset/build.ninja" ] || options=(-DPARTI_TESTS=OFF -DPARTI_BENCH=OFF)
  for option in "$@"; do
    grep -qs "^$option:BOOL=ON$" "build/$preset/CMakeCache.txt" || options+=("-D$option=ON")
  done
  [ ${#options[@]} -gt 0 ] || return 0
  mkdir -p build
  cmake --preset "$preset" "${options[@]}" >build/configure.log 2>&1 && return
  cat build/configure.log >&2
  give_up "cmake could not configure build/$preset" "remove build/$preset and try again"
}

# build PRESET TARGET…: everything where no target is named. Compiler output goes to standard error.
build() {
  local preset=$1 targets=()
  shift
  [ $# = 0 ] || targets=(--target "$@")
  cmake --build "build/$preset" --parallel "$(jobs)" "${targets[@]}" >&2 ||
    give_up "the $preset preset does not build" "the compiler's messages stand above"
}
