#!/usr/bin/env bash
# From a fresh clone to the first result: installs what is missing, builds, and runs the built-in scenes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/bootstrap.sh
cmake --preset release
cmake --build --preset release --target facet
build/release/facet run configs/quickstart.yaml

echo "open: file://$PWD/results/quickstart/latest/report/report.html"
