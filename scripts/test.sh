#!/usr/bin/env bash
# Builds with warnings as errors and runs the tests. The last line is "N passed, N failed, N skipped".
# Usage: scripts/test.sh [--all]     --all adds the tests labelled slow and gpu
# FACET_DATA=DIR  folder with recorded frames; without it the tests that need some are skipped.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

labels='^(fast|data)$'
case "${1:-}" in
  "") ;;
  --all) labels='^(fast|data|slow|gpu)$' ;;
  *) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
esac

scripts/bootstrap.sh
cmake --preset release
cmake --build --preset release

junit=$PWD/build/release/tests.xml
rm -f "$junit"
status=0
ctest --test-dir build/release --label-regex "$labels" --no-tests=error --parallel "$(nproc)" \
  --output-on-failure --output-junit "$junit" || status=$?
[ -n "${FACET_DATA:-}" ] || echo "FACET_DATA is not set: the tests on recorded frames are skipped."
sed --quiet '/\.[hc]pp:[0-9]*: Skipped$/{n;s/^/skipped: /p}' "$junit" | sort | uniq --count

# A test whose program is missing is "notrun" in the file as well, but it has failed: only what asked to be skipped
# counts as skipped.
total=$(grep --count '<testcase ' "$junit" || true)
passed=$(grep --count '<testcase .*status="run"' "$junit" || true)
skipped=$(grep --count -e '<skipped message="SKIP_' -e '<testcase .*status="disabled"' "$junit" || true)
echo "$passed passed, $((total - passed - skipped)) failed, $skipped skipped"
exit "$status"
