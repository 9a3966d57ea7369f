# Sourced by experiments/run, tests/run and .ci/run: from a bare Debian 12 to a built preset.
# shellcheck shell=bash

project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
packages=$project/framework/cmake/packages.txt

say() { printf '%s\n' "$*" >&2; }

die() {
  say "$@"
  exit 1
}

# step NAME COMMAND...: shows the command's output on a terminal. In a pipe it prints NAME alone,
# and the output only if the command fails.
step() {
  local name=$1 log
  shift
  if [[ -t 2 ]]; then
    say "$name"
    "$@" >&2
    return
  fi
  log=$(mktemp)
  say "$name"
  local status=0
  "$@" > "$log" 2>&1 || status=$?
  if ((status)); then cat "$log" >&2; fi
  rm -f "$log"
  return "$status"
}

# The packages of the given lists that are not installed, one a line.
missing_packages() {
  local wanted installed
  wanted=$(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$@" | sort -u)
  # dpkg-query fails when it does not know a package; that one is missing, then.
  # shellcheck disable=SC2086
  installed=$({ dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2> /dev/null || true; } |
    sed -n 's/ installed$//p' | sort -u)
  comm -23 <(printf '%s\n' "$wanted") <(printf '%s\n' "$installed")
}

# Prints the prefix that makes a command run as root; fails when there is none.
root_prefix() {
  if ((EUID == 0)); then return; fi
  command -v sudo > /dev/null || return 1
  # Without a terminal sudo cannot ask for a password.
  if [[ -t 0 ]] || sudo -n true 2> /dev/null; then
    printf 'sudo'
    return
  fi
  return 1
}

apt_install() {
  local prefix=$1
  shift
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  # Without an update a fresh system knows no packages; without a network the lists at hand may do.
  $prefix "${apt[@]}" update || say "apt-get update failed; trying with the lists at hand"
  $prefix "${apt[@]}" install -y --no-install-recommends "$@"
}

# install_packages LIST...: installs what is missing from the lists.
install_packages() {
  if ! command -v dpkg-query > /dev/null; then
    say "not a Debian system: the libraries of $packages must be there already"
    return
  fi
  local missing prefix
  missing=$(missing_packages "$@")
  if [[ -z $missing ]]; then return; fi
  missing=${missing//$'\n'/ }
  prefix=$(root_prefix) || die "Packages are missing, and installing them takes root or sudo." \
    "Ask an administrator to run:"$'\n'"  apt-get install --no-install-recommends $missing"
  # shellcheck disable=SC2086
  step "installing with apt-get: $missing" apt_install "$prefix" $missing < /dev/null ||
    die "apt-get could not install: $missing"
  # What cmake looked for in vain is there now.
  rm -f "$project"/build/*/CMakeCache.txt
}

# The memory [MiB] that may be used, by the machine's and by the container's limit.
free_memory() {
  local limit used free
  free=$(awk '/^MemAvailable/ { print int($2 / 1024) }' /proc/meminfo)
  if read -r limit 2> /dev/null < /sys/fs/cgroup/memory.max && [[ $limit != max ]]; then
    read -r used < /sys/fs/cgroup/memory.current
    limit=$(((limit - used) / 1048576))
    if ((limit < free)); then free=$limit; fi
  fi
  printf '%s' "$free"
}

# Compilers to run side by side: as many as there are cores and, at 1500 MiB each, memory.
build_jobs() {
  local jobs limit
  jobs=$(nproc)
  limit=$(($(free_memory) / 1500))
  if ((limit < jobs)); then jobs=$limit; fi
  printf '%s' $((jobs > 1 ? jobs : 1))
}

# configure PRESET [cmake flags]: only when there is nothing yet, or what there is belongs to other
# presets or to another place; ninja sees to every other change.
configure() {
  local preset=$1
  shift
  local folder=$project/build/$preset
  local home
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$folder/CMakeCache.txt" 2> /dev/null) || true
  if [[ $home == "$project" && $folder/build.ninja -nt $project/CMakePresets.json && $# == 0 ]]; then
    return
  fi
  local fresh=
  if [[ $home != "$project" ]]; then fresh=--fresh; fi
  (cd "$project" && step "configuring build/$preset" cmake --preset "$preset" $fresh "$@") ||
    die "cmake could not configure build/$preset"
}

# build PRESET TARGET...
build() {
  local preset=$1
  shift
  export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(build_jobs)}
  # Paths relative to the project let ccache serve every checkout.
  export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$project} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR:-1}
  step "building build/$preset" cmake --build "$project/build/$preset" --target "$@" ||
    die "build/$preset could not be built"
}

# run_under_thread_sanitizer PROGRAM [gtest flags]: the fast tests of a program of build/tsan. GCC 12's
# sanitizer wants addresses that are not randomised by more than 28 bits, which containers may not
# be allowed to ask for.
run_under_thread_sanitizer() {
  local -a prefix=()
  if setarch -R true 2> /dev/null; then prefix=(setarch -R); fi
  OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 "${prefix[@]}" "$project/build/tsan/bin/$1" \
    --gtest_filter='-*Slow*' "${@:2}"
}

# run_ctest PRESET [ctest flags]: every test of a build. In a pipe the tests that pass go unnamed.
run_ctest() {
  local -a ctest=(ctest --test-dir "$project/build/$1" -j "$(nproc)" --output-on-failure "${@:2}")
  say "testing build/$1"
  if [[ -t 1 ]]; then
    "${ctest[@]}" --progress
  else
    "${ctest[@]}" | grep --line-buffered -vE '^ +Start +[0-9]+: |^ *[0-9]+/[0-9]+ Test .* Passed '
  fi
}

# run_shards PRESET SECONDS [gtest flags]: the fast tests of a build in as many processes as there are
# cores, each to be done within SECONDS: where a start of the program costs more than most tests do.
run_shards() {
  local preset=$1 seconds=$2 shards shard status=0
  shards=$(nproc)  # which OMP_NUM_THREADS would change
  local -a running=() logs=()
  shift 2
  say "testing build/$preset"
  for ((shard = 0; shard < shards; shard++)); do
    logs+=("$(mktemp)")
    (cd "$project/build/$preset/tests" && OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 \
      GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard timeout -k 10 "$seconds" \
      ../bin/cirque_tests --gtest_filter='-*Slow*' "$@") > "${logs[-1]}" 2>&1 &
    running+=($!)
  done
  for shard in "${!running[@]}"; do
    if wait "${running[$shard]}"; then
      grep -aE '^\[ +(PASSED|SKIPPED) +\] [0-9]' "${logs[$shard]}" >&2
    else
      status=1
      # All but the tests that pass, and the one that ran when time was over.
      awk '/^\[ RUN/ { run = $0; next }
           /^\[ +OK/ && run { run = ""; next }
           /^\[-/ || /^$/ { next }
           { if (run) print run; run = ""; print }
           END { if (run) print run }' "${logs[$shard]}" >&2
    fi
    rm -f "${logs[$shard]}"
  done
  return "$status"
}
