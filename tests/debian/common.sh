# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What ./run and the scripts that it calls share; they source it.
# shellcheck disable=SC2034 # it is they who use these

# Debian's own Python, since it is the one that Debian's Blender embeds; another one may come first on PATH.
readonly python=/usr/bin/python3
readonly blender=${DIRICHLET_BLENDER:-/usr/bin/blender}
project=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
readonly project
readonly addon=$project/build/release/addon/dirichlet_isolines
# Blenders, and the releases of Debian that they and their Pythons come with; one of them is this machine's.
declare -rA releases=([3.4]=bookworm [4.3]=trixie [5.2]=sid)

readonly build_packages=(cmake ninja-build g++ python3-dev python3-numpy pybind11-dev libeigen3-dev libopenmesh-dev
  libgtest-dev)
readonly blender_packages=(blender libegl1 libgl1-mesa-dri python3-cattr python3-requests) # two for its extensions
readonly window_packages=(xvfb xdotool imagemagick)
readonly test_packages=(python3-pytest python3-hypothesis python3-scipy)
readonly fuzz_packages=(clang libclang-rt-dev)
readonly wheel_packages=(cmake ninja-build g++ python3-dev python3-venv libeigen3-dev libopenmesh-dev)

say() { if [[ -t 1 ]]; then printf "\n\033[1m%s\033[0m\n" "$*"; else printf "\n%s\n" "$*"; fi; }

die() {
  printf 'run: %s\n' "$*" >&2
  exit 1
}

asks_for_help() { [[ " $* " =~ \ (-h|--help|help)\  ]]; }

as_root() {
  if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

is_here() { # RELEASE
  grep -qx "VERSION_CODENAME=$1" /etc/os-release
}

missing_packages() {
  local package
  for package; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed* ]] || echo "$package"
  done
}

need() { # PACKAGE…
  local missing install
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  command -v apt-get >/dev/null || die "this needs Debian's packages, or their equal: ${missing[*]}"
  ((EUID == 0)) || command -v sudo >/dev/null || die "neither root nor sudo; have these installed: ${missing[*]}"
  say "Installing Debian packages: ${missing[*]}"
  install=(env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}")
  (
    flock 8 # what makes the Debians beside may install as well
    "${install[@]}" --simulate >/dev/null 2>&1 || as_root apt-get update -qq # no package lists, or too old ones
    as_root "${install[@]}" >/dev/null
  ) 8>>"${TMPDIR:-/tmp}/dirichlet-isolines.apt"
}

build_addon() {
  need "${build_packages[@]}"
  say "Building"
  cmake --preset release
  cmake --build --preset release --target dirichlet_addon
}

in_blender() { # ADDON SCRIPT ARG…: the script one of this project's
  local folder=$1 script=$2
  shift 2
  DIRICHLET_ADDON=$folder "$blender" --background --factory-startup -noaudio --python-exit-code 1 \
    --python "$project/$script" -- "$@"
}
