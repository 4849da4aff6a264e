#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ./run fuzz [SECONDS [TARGET…]]: from the seeds, and from what the runs before have found; each target has a core.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
# shellcheck source=tests/debian/common.sh
source tests/debian/common.sh

fuzz() { # TARGET SECONDS: what breaks it lands beside the log, from where it can be given to the program again
  local folder=build/fuzz/$1 words=tests/fuzz/$1.dict options said status=0
  mkdir -p "$folder/corpus"
  options=(-max_total_time="$2" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=256 -max_len=2048 -print_final_stats=1)
  [[ -f $words ]] && options+=(-dict="$words")
  build/fuzz/tests/fuzz/"fuzz_$1" "${options[@]}" -artifact_prefix="$folder/" "$folder/corpus" \
    "tests/fuzz/corpus/$1" >"$folder/log" 2>&1 || status=$?
  echo "$status" >"$folder/status"
  said=$(grep -v -E '^(#[0-9]+|NEW_FUNC)' "$folder/log" | tail -n $((status == 0 ? 8 : 60)) || true)
  say "Fuzzed: $1"$'\n'"$said" # at once: others fuzz beside it
}

fuzz_all() { # SECONDS TARGET…
  local seconds=$1 start=$SECONDS target failures=0
  shift
  export -f fuzz say
  rm -f build/fuzz/*/status # of the runs before
  printf '%s\n' "$@" | xargs -P "$(nproc)" -I '{}' bash -euo pipefail -c 'fuzz "$@"' fuzz '{}' "$seconds"
  for target; do
    [[ $(cat "build/fuzz/$target/status") == 0 ]] || failures=$((failures + 1))
  done
  say "$(($# - failures)) passed, $failures failed in $((SECONDS - start))s"
  ((failures == 0))
}

main() { # [SECONDS [TARGET…]]
  local seconds=60 known targets target
  mapfile -t known < <(basename -s _fuzz.cpp tests/fuzz/*_fuzz.cpp)
  if asks_for_help "$@"; then
    echo "./run fuzz [SECONDS [TARGET…]]: looks for inputs that break the library, SECONDS (60) for each TARGET of" \
      "${known[*]} (all); one that does is kept in build/fuzz/TARGET beside the log"
    return
  fi
  [[ ${1-} =~ ^[0-9]+$ ]] && seconds=$1 && shift
  targets=("${@:-${known[@]}}")
  for target in "${targets[@]}"; do
    [[ " ${known[*]} " == *" $target "* ]] || die "no fuzz target '$target'; there are ${known[*]}"
  done
  need "${build_packages[@]}" "${fuzz_packages[@]}"
  say "Building"
  cmake --preset fuzz
  cmake --build --preset fuzz
  fuzz_all "$seconds" "${targets[@]}"
}

main "$@"
exit # so that nothing is read from the file if it changed meanwhile
