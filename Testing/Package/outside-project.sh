#!/usr/bin/env bash
# Installs the build, then configures, builds and runs an outside project against it.
# Also imports the installed Python package, and finds the package in the build tree.
# outside-project.sh BUILD PROJECT CMAKE_ARGUMENT...
set -euo pipefail
build=$1
outside=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >"$work/log" || { cat "$work/log"; exit 1; }
cp -r "$outside" "$work/outside"
arguments=()
for argument in "$@"; do
  arguments+=("${argument/#-DCMAKE_PREFIX_PATH=/-DCMAKE_PREFIX_PATH=$work/prefix;}")
done
cmake -S "$work/outside" -B "$work/build" "${arguments[@]}"
cmake --build "$work/build"

# A block of 20 x 20 x 20 samples, half of them bright.
{ head -c 4000 /dev/zero; head -c 4000 /dev/zero | tr '\0' '\310'; } >"$work/half.raw"
"$(dirname "$0")/../Support/with-display.sh" "$work/build/FlatBlockView" "$work/half.raw" \
  --raw 20 20 20 uint8 --output "$work/half.png" --size 64 64 | tee "$work/table"
grep -q '^dimensions  *20 x 20 x 20$' "$work/table"
[ -s "$work/half.png" ]

cmake -S "$work/outside" -B "$work/from-build-tree" "${@/#-DCMAKE_PREFIX_PATH=/-DCMAKE_PREFIX_PATH=$build;}"

packages=$(dirname "$(find "$work/prefix" -type d -name flatblock -path '*python*')" || true)
if [ "$packages" != . ]; then
  PYTHONPATH=$packages:${PYTHONPATH:-} "${PYTHON:-python3}" -c \
    'from flatblock import vtkFlatBlockVolumeMapper as m; assert m().GetBlockSize() == 33'
fi
