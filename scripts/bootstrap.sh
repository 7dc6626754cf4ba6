#!/usr/bin/env bash
# Installs what Facet is built from. This is the one list of its packages (names of Debian 12).
# Usage: scripts/bootstrap.sh [--with-tools] [--with-pcl]     --with-tools adds what only developers need,
#        --with-pcl the Point Cloud Library, which the method pcl_planes needs (about 750 MB)
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache git
  libopencv-dev libopencv-contrib-dev libeigen3-dev libtbb-dev
  libcli11-dev libyaml-cpp-dev nlohmann-json3-dev libfmt-dev libspdlog-dev libssl-dev libtinyxml2-dev zlib1g-dev
  libavformat-dev libavcodec-dev
  libgtest-dev libgmock-dev libbenchmark-dev
)
developer_packages=(clang-format clang-tidy gcovr)

for option in "$@"; do
  case "$option" in
    --with-tools) packages+=("${developer_packages[@]}") ;;
    --with-pcl) packages+=(libpcl-dev) ;;
    *) sed -n '2,4s/^# //p' "$0" >&2; exit 2 ;;
  esac
done

if ! command -v apt-get >/dev/null; then
  echo "bootstrap: no apt-get here; install the equivalents of: ${packages[*]}" >&2
  exit 1
fi

installed=$(dpkg-query --show --showformat='${db:Status-Abbrev}${Package}\n' "${packages[@]}" 2>/dev/null |
  sed -n 's/^ii  *//p' || true)
missing=()
for package in "${packages[@]}"; do
  grep --quiet --line-regexp --fixed-strings -- "$package" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
  command -v sudo >/dev/null || { echo "bootstrap: run as root: apt-get install ${missing[*]}" >&2; exit 1; }
fi

echo "bootstrap: installing ${missing[*]}" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet --option Acquire::Retries=3)
if ! { "${apt[@]}" update && "${apt[@]}" install --yes --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
  cat "$log" >&2
  echo "bootstrap: apt-get failed, see above" >&2
  exit 1
fi
