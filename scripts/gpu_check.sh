#!/usr/bin/env bash
# Runs in the folder that bundle.sh has made, on a machine with an NVIDIA GPU: parity tests, compute-sanitizer where it
# starts, then times. Writes GPU.json and GPU.md to OUT, named after the device.
# Usage: ./gpu_check.sh [OUT]      default: the folder `results` beside it
# Exit code: 0 all measured and equal, 1 a test failed or results differ, 6 there is no device.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case "${1:-}" in -*) sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;; esac
out=${1:-$here/results}
device=$("$here/bin/facet_gpu_check" --device) || exit
name=$(tr -cs 'A-Za-z0-9\n' '_' <<<"${device%,*}" | tr 'A-Z' 'a-z' | sed 's/_*$//')
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
facts=(--fact "commit=$(cat "$here/COMMIT")")
status=0

tests=$here/bin/cuda_parity_test
FACET_REQUIRE_GPU=1 "$tests" >"$work/parity" 2>&1 || status=1
summary=$(sed -n 's/^\[ *\(PASSED\|FAILED\|SKIPPED\) *\] *\([0-9]* tests*\).*/\2 \1/p' "$work/parity" | paste -sd, -)
facts+=(--fact "parity tests=${summary:-did not run}")
[ "$status" -eq 0 ] || grep -A 5 'Failure$' "$work/parity" | head -n 60 >&2

# On small frames: a sanitizer is slow.
for tool in memcheck racecheck; do
  if ! command -v compute-sanitizer >/dev/null; then
    facts+=(--fact "$tool=not measured: no compute-sanitizer here")
  elif ! FACET_REQUIRE_GPU=1 compute-sanitizer --tool "$tool" --error-exitcode 9 "$tests" \
      --gtest_filter='*AwkwardFrames*default:*RunningSequence*default' >"$work/$tool" 2>&1; then
    if grep -q "ERROR SUMMARY\|RACECHECK SUMMARY" "$work/$tool"; then
      status=1
      facts+=(--fact "$tool=$(grep 'SUMMARY' "$work/$tool" | tail -n 1 | sed 's/^=* *//')")
    else
      facts+=(--fact "$tool=not measured: refused")
    fi
  else
    facts+=(--fact "$tool=$(grep 'SUMMARY' "$work/$tool" | tail -n 1 | sed 's/^=* *//')")
  fi
done

threads=$(nproc)
"$here/bin/facet_gpu_check" --frames "$here/frames" --threads "$((threads < 8 ? threads : 8))" \
  --json "$work/json" --markdown "$work/md" "${facts[@]}"
measured=$?
[ -s "$work/json" ] || exit "$measured"
cp "$work/json" "$out/$name.json"
cp "$work/md" "$out/$name.md"
echo "$out/$name.json"
[ "$measured" -eq 0 ] || exit "$measured"
exit "$status"
