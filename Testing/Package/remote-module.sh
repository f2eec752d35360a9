#!/usr/bin/env bash
# Builds the module as VTK builds its remote modules: by scanning the root's vtk.module.
# remote-module.sh PROJECT CMAKE_ARGUMENT...
set -euo pipefail
project=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/host/Remote"
cp "$project/CMakeLists.txt" "$work/host"
ln -s "$(cd "$project/../../.." && pwd)" "$work/host/Remote/FlatBlockVolume"
cmake -S "$work/host" -B "$work/build" "$@"
cmake --build "$work/build"
[ -n "$(find "$work/build" -name 'libvtkFlatBlockVolumeRendering*.so*')" ]
[ -z "$(find "$work/build" -name 'FlatBlock*Tests*')" ]
