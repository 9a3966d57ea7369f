# Sourced by .ci/bare_debian and .ci/packages_bare: a Debian 12 that holds nothing else, debootstrap's
# minimal one. Takes root and debootstrap. MIRROR names a Debian mirror other than debootstrap's
# own; apt's network settings are this machine's.
# shellcheck shell=bash

# Goes on in a namespace of its own, whose mounts go away with it whatever happens. "$@": the script's
# own arguments.
in_namespace() {
  if [[ ${IN_NAMESPACE:-} == 1 ]]; then return; fi
  IN_NAMESPACE=1 exec unshare --mount --propagation private "$(realpath "$0")" "$@"
}

# make_root FOLDER: the system, with an empty folder /srv/trial.
make_root() {
  if [[ -e $1 ]]; then
    echo "$1 exists: name a folder that does not" >&2
    exit 2
  fi
  debootstrap --variant=minbase bookworm "$1" ${MIRROR:+"$MIRROR"} > /dev/null
  apt-config dump | grep '^Acquire::' > "$1/etc/apt/apt.conf.d/99network" || true
  cp /etc/resolv.conf /etc/hosts "$1/etc/"
  mkdir "$1/srv/trial"
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
}

# in_root FOLDER START COMMAND...: a command in there, begun in the folder START.
in_root() {
  local root=$1 start=$2
  shift 2
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$root" \
    /bin/bash -c 'cd "$0" && "$@"' "$start" "$@"
}
