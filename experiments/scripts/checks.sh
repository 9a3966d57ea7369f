# Sourced by check_disks, check_meshes and check_spheres: their command line, programs and files.
# shellcheck shell=bash disable=SC2034

bin=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/build/release/bin

# The comment at the head of the script is its help.
explain() { sed -n '2,/^[^#]/s/^# //p' "$0"; }

misused() {
  explain >&2
  exit 2
}

# read_command_line [-k FOLDER] [-t TABLE] MESH... [-- FLAG...]: sets table, meshes, flags, and out, where maps go.
read_command_line() {
  local keep=
  table='' meshes=() flags=()
  while (($# > 0)); do
    case $1 in
      --help | -h)
        explain
        exit 0
        ;;
      -k | -t)
        (($# > 1)) || misused
        if [[ $1 == -k ]]; then keep=$2; else table=$2; fi
        shift
        ;;
      --)
        shift
        flags=("$@")
        break
        ;;
      -*) misused ;;
      *) meshes+=("$1") ;;
    esac
    shift
  done
  ((${#meshes[@]} > 0)) || misused
  if [[ ! -x $bin/circle_patterns || ! -x $bin/verify_map ]]; then
    echo "$0: the programs are not built; experiments/run builds them" >&2
    exit 2
  fi
  out=${keep:-$(mktemp -d)}
  mkdir -p "$out"
  if [[ -z $keep ]]; then trap 'rm -rf "$out"' EXIT; fi
}

# field JSON NAME: a number of a certificate or report
field() { sed -n "s/^ *\"$2\": \([^,]*\),\{0,1\}$/\1/p" "$1" | head -1; }
