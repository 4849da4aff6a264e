#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run test [STAGE [ARG…]] and ./run test --blender VERSION: see ./run
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
# shellcheck source=tests/debian/common.sh
source tests/debian/common.sh
readonly stages=(cpp sanitize threads fuzz python blender ui)
readonly parts=(ready saved installed ui_installed) # of what happens in another Debian
readonly saved=build/saved_in_3.4.blend

stage_cpp() { cmake --workflow --preset release; }

stage_sanitize() { cmake --workflow --preset sanitize; }

stage_threads() { cmake --workflow --preset threads; }

stage_fuzz() { tests/fuzz/fuzz.sh; }

stage_python() { # PYTEST-ARG…
  cmake --preset release >/dev/null
  cmake --build --preset release
  "$python" -m pytest tests/python "$@"
}

stage_blender() { # PYTEST-ARG…
  build_addon
  in_blender "$addon" tests/blender/run_pytest.py "$@"
}

stage_ui() { # PYTEST-ARG…: in a window on a screen that nobody sees
  build_addon
  "$python" -m pytest tests/ui "$@"
}

stage_ready() { need "${wheel_packages[@]}"; }

install_zip() { # prints the folder of what Blender itself makes of the zip of dist/ that is for it
  "$python" tests/blender/install_archive.py "$blender" dist "build/installed/${blender##*/}"
}

stage_saved() { # what Blenders to come have to open
  local folder
  folder=$(install_zip) # alone, so that its failure ends the stage
  in_blender "$folder" tests/blender/old_file.py "$PWD/$saved"
}

stage_installed() { # PYTEST-ARG…
  local folder
  export DIRICHLET_DIST=$PWD/dist DIRICHLET_SAVED=$PWD/$saved
  folder=$(install_zip)
  in_blender "$folder" tests/blender/run_pytest.py "$@"
}

stage_ui_installed() { # PYTEST-ARG…: as ui, but the zip of dist/; four million vertices take software drawing too long
  DIRICHLET_DIST=$PWD/dist "$python" -m pytest tests/ui "$@" \
    --deselect tests/ui/test_window.py::test_escape_ends_whatever_takes_long_on_four_million_vertices
}

stage_bpy() { # Blender as blender.org builds it, in PyPI's newest package that fits this machine's Python
  local venv=$PWD/build/bpy-venv
  need python3-venv
  "$python" -m venv "$venv"
  "$venv/bin/pip" install -q --disable-pip-version-check --upgrade bpy pytest hypothesis scipy
  # shellcheck disable=SC2016 # it is the script that has these arguments
  printf '#!/bin/sh\nexec "%s" "%s" "$0" "$@"\n' "$venv/bin/python" "$project/tests/blender/bpy_as_blender.py" \
    >"$venv/bin/bpy"
  chmod +x "$venv/bin/bpy"
  DIRICHLET_BLENDER=$venv/bin/bpy tests/stages.sh installed
}

in_release() { # RELEASE STAGE: in that Debian
  if is_here "$1"; then "stage_$2"; else tests/debian/in_root.sh "$1" ./run test "$2"; fi
}

hand_over_saved() { # to each Blender, what 3.4 saves
  local release made=build/bookworm/${saved##*/}
  in_release bookworm saved
  is_here bookworm && made=$saved
  for release in "${releases[@]}"; do
    mkdir -p "build/$release"
    [[ build/$release/${saved##*/} == "$made" ]] || cp "$made" "build/$release"
  done
  [[ $made == "$saved" ]] || cp "$made" "$saved"
}

test_in_blender() { # VERSION
  if [[ $1 == bpy ]]; then stage_bpy; else in_release "${releases[$1]}" installed; fi
}

failed=()
summary=()

judge() { # STAGE STATUS SECONDS: what its log says last about its tests goes into the summary
  local verdict=passed words log=build/test/$1.log
  (($2)) && verdict=FAILED && failed+=("$1")
  words=$(grep -oE '[0-9]+% tests passed.*|[0-9]+ (passed|failed|error).* in [0-9.]+s' "$log" | tail -n 1 || true)
  summary+=("$(printf '  %-11s %-7s %4d s  %s' "$1" "$verdict" "$3" "$words")")
}

run_stage() { # STAGE FUNCTION ARG…
  local stage=$1 start=$SECONDS status
  shift
  say "Tests: $stage"
  set +e # not "if run_stage", which would let a stage go on after its first failing command
  (set -e; "$@") 2>&1 | tee "build/test/$stage.log"
  status=${PIPESTATUS[0]}
  set -e
  judge "$stage" "$status" $((SECONDS - start))
}

keep_stage() { # STAGE FUNCTION ARG…: for stages side by side; tell_stage tells how it went
  local stage=$1 start=$SECONDS status
  shift
  set +e
  (set -e; "$@") >"build/test/$stage.log" 2>&1
  status=$?
  set -e
  echo "$status $((SECONDS - start))" >"build/test/$stage.end"
}

tell_stage() { # STAGE
  local status seconds
  say "Tests: $1"
  cat "build/test/$1.log"
  read -r status seconds <"build/test/$1.end"
  judge "$1" "$status" "$seconds"
}

make_ready() { # VERSION: its Debian, and that of the Blender whose file it opens
  in_release bookworm ready
  [[ $1 == bpy ]] || in_release "${releases[$1]}" ready
}

make_what_is_installed() { # VERSION…: the zips, and a file of 3.4's
  local here=()
  if (($# < ${#releases[@]})); then # no Debian is made for a wheel that nobody takes
    run_stage ready make_ready "$1"
    here=(--here)
  fi
  run_stage package blender_scripts/package.sh package "${here[@]}"
  run_stage saved hand_over_saved
}

run_in_blenders() { # VERSION…: side by side
  local version
  make_what_is_installed "$@"
  say "Tests: blender, $*: side by side; build/test/ has their logs"
  for version; do keep_stage "blender $version" test_in_blender "$version" & done
  wait
  for version; do tell_stage "blender $version"; done
}

make_roots() { # side by side: they wait for the network. What fails here fails again, and is told, where it is needed
  local release
  for release in "${releases[@]}"; do
    is_here "$release" || tests/debian/in_root.sh "$release" ./run test ready >"build/test/$release.log" 2>&1 &
  done
  wait
}

run_everything() {
  local stage version making
  make_roots &
  making=$!
  for stage in cpp sanitize threads fuzz; do run_stage "$stage" "stage_$stage"; done
  wait $making
  make_what_is_installed 3.4 4.3 5.2
  say "Tests: the others, on one core those in windows; build/test/ has their logs"
  {
    keep_stage ui stage_ui
    keep_stage "ui 5.2" in_release sid ui_installed
  } &
  {
    for version in 5.2 4.3 3.4; do keep_stage "blender $version" test_in_blender "$version"; done
    keep_stage python stage_python
  } &
  wait
  for stage in python "blender 3.4" "blender 4.3" "blender 5.2" ui "ui 5.2"; do tell_stage "$stage"; done
}

main() { # [STAGE [PYTEST-ARG…]] or --blender VERSION
  local versions=("${2-all}")
  [[ ${1-} != --blender ]] || (($# <= 2)) || die "'--blender' takes one version, and no more words such as '$3'"
  trap 'trap - TERM; kill 0' INT # what runs in the background would go on
  [[ ${1-} == --ui ]] && set -- ui "${@:2}"
  if [[ ${1-} == --blender ]]; then
    [[ ${versions[0]} == all ]] && versions=(3.4 4.3 5.2)
    [[ ${versions[0]} == bpy || -v releases[${versions[0]}] ]] ||
      die "no Blender '$2' to test in; there are 3.4, 4.3, 5.2, bpy and all"
  elif (($#)); then
    [[ " ${stages[*]} ${parts[*]} " == *" $1 "* ]] || die "no test stage '$1'; there are ${stages[*]}"
  fi
  need "${build_packages[@]}" "${blender_packages[@]}" "${window_packages[@]}" "${test_packages[@]}"
  mkdir -p build/test
  rm -f build/test/*.end # of an earlier run
  case ${1-} in
  "") run_everything ;;
  --blender) run_in_blenders "${versions[@]}" ;;
  *) run_stage "$1" "stage_$1" "${@:2}" ;;
  esac
  say "Test summary"
  printf '%s\n' "${summary[@]}"
  printf '%d of %d stages passed\n' $((${#summary[@]} - ${#failed[@]})) ${#summary[@]}
  ((${#failed[@]} == 0))
}

main "$@"
exit # so that nothing is read from the file if it changed meanwhile
