#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a command in another release of Debian, for the Blender and the Python that come with it:
#
#   tests/debian/in_root.sh RELEASE COMMAND [ARG…]      RELEASE: trixie, sid, …
#
# A root of that release is made when it is missing: two minutes, and 2 GB once Blender is in it. It is kept between
# runs, shared by all clones, in ${XDG_CACHE_HOME:-~/.cache}/dirichlet-isolines/RELEASE. In it this project stands at
# /project. What the command writes there is gone when it ends, but for build/, which is this clone's build/RELEASE.
# With no COMMAND it says whether the root is there. Takes root, or sudo.
set -euo pipefail

readonly release=$1
shift
readonly root=${XDG_CACHE_HOME:-$HOME/.cache}/dirichlet-isolines/$release
# shellcheck source=tests/debian/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

# shellcheck disable=SC2016 # apt-get reads $(SITE), no shell
mirror() { # the one that this machine's own packages come from
  apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Origin: Debian' | grep -v security | head -n 1
}

make_root() { # beside its place, then renamed: a root that is there is whole
  local beside=$root.part
  need debootstrap
  echo "Making a Debian $release in $root"
  as_root rm -rf --one-file-system "$beside"
  as_root unshare --mount debootstrap --variant=minbase --include=ca-certificates "$release" "$beside" "$(mirror)" \
    >"$root.log" 2>&1 || die "no Debian $release could be made of the mirror: $(tail -n 1 "$root.log")"
  printf '#!/bin/sh\nexit 101\n' | as_root tee "$beside/usr/sbin/policy-rc.d" >/dev/null # no service starts
  as_root chmod +x "$beside/usr/sbin/policy-rc.d"
  echo 'Acquire::Check-Valid-Until "false";' | # a mirror may lag behind a release that has no end; signatures do count
    as_root tee "$beside/etc/apt/apt.conf.d/lagging-mirror" >/dev/null
  as_root ln -sfn /proc/self/mounts "$beside/etc/mtab"
  as_root mkdir -p "$beside/project"
  as_root mv "$beside" "$root"
}

# Mounts are made in a namespace of their own, so that nothing of them is left however this ends.
# shellcheck disable=SC2016 # it is the inner shell that reads these variables
readonly enter='
  set -eu
  root=$1 project=$2 release=$3
  shift 3
  mount -t proc proc "$root/proc"
  mount --rbind /sys "$root/sys"
  mount --rbind /dev "$root/dev"
  mount -t tmpfs tmpfs "$root/dev/shm"
  mount -t tmpfs tmpfs "$root/tmp"
  mount -t tmpfs tmpfs "$root/mnt"
  mkdir "$root/mnt/written" "$root/mnt/work"
  mount -t overlay overlay -o "lowerdir=$project,upperdir=$root/mnt/written,workdir=$root/mnt/work" "$root/project"
  mount --bind "$project/build/$release" "$root/project/build"
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  mount --bind /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/certs/ca-certificates.crt" # whom this machine trusts
  exec chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM="${TERM-dumb}" \
    sh -c "cd /project && exec \"\$@\"" sh "$@"
'

main() { # COMMAND ARG…
  if (($# == 0)); then
    [[ -d $root ]]
    exit
  fi
  mkdir -p "$(dirname "$root")"
  exec 9>"$root.lock"
  flock 9 # one command at a time: they install packages
  [[ -d $root ]] || make_root
  mkdir -p "$project/build/$release"
  as_root unshare --mount --pid --fork --kill-child sh -c "$enter" sh "$root" "$project" "$release" "$@"
}

main "$@"
exit # so that nothing is read from the file if it changed meanwhile
