#!/usr/bin/env bash
# Makes a folder that checks and measures the CUDA back end on another machine: 64-bit Linux with a glibc no older than
# this one's and an NVIDIA driver; nothing else is needed there. Run gpu_check.sh in it.
# Usage: scripts/bundle.sh [FOLDER]      default build/facet-gpu-check, packed beside it as FOLDER.tar.xz
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
case "${1:-}" in -*) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2 ;; esac
folder=${1:-build/facet-gpu-check}
programs=(facet_gpu_check cuda_parity_test)

cmake --preset cuda
cmake --build --preset cuda --target "${programs[@]}"

rm -rf "$folder" "$folder.tar.xz"
mkdir -p "$folder/bin" "$folder/lib"
cp build/cuda/facet_gpu_check build/cuda/tests/cuda/cuda_parity_test "$folder/bin"
cp scripts/gpu_check.sh "$folder"
git describe --always --dirty >"$folder/COMMIT"
strip "$folder"/bin/*

# Every shared library but those of glibc, which belong to the machine's loader.
for program in "$folder"/bin/*; do
  ldd "$program" | awk '$2 == "=>" {print $3}'
done | sort --unique | while read -r library; do
  case $(basename "$library") in
    libc.so.* | libm.so.* | libpthread.so.* | libdl.so.* | librt.so.* | libresolv.so.* | ld-linux*) ;;
    *) cp --dereference "$library" "$folder/lib"; strip --strip-unneeded "$folder/lib/$(basename "$library")" ;;
  esac
done

"$folder/bin/facet_gpu_check" --make-frames "$folder/frames"
tar --create --directory "$(dirname "$folder")" "$(basename "$folder")" | xz --threads=0 -6 >"$folder.tar.xz"
bytes=$(stat --format=%s "$folder.tar.xz")
echo "$folder.tar.xz: $((bytes / 1000000)) MB"
[ "$bytes" -le 25000000 ] || { echo "bundle: larger than 25 MB" >&2; exit 1; }
