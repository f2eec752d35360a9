#!/usr/bin/env bash
# Includes go one way: plugin -> mapper -> (OpenGL classes, builder) -> Core; builder -> Kernels.
set -eu
cd "$1"
failures=0

forbid() { # WHAT PATTERN FILES...
  local what=$1 pattern=$2 found
  shift 2
  if found=$(grep -nE "#include [\"<]($pattern)" "$@"); then
    printf '%s:\n%s\n' "$what" "$found"
    failures=$((failures + 1))
  fi
}
names() { ls "$@" | xargs -n1 basename | paste -sd '|'; }

core=$(names Module/Core/*.h)
kernels=$(names Kernels/*.h)
[ -n "$core" ] && [ -n "$kernels" ]

forbid "Kernels knows VTK, OpenGL or Core" "vtk|GL/|$core" Kernels/*.{h,cxx,cu}
forbid "Core knows VTK, OpenGL or Kernels" "vtk|GL/|$kernels" Module/Core/*.{h,cxx}
# How loops of threads end serves them all.
numbers=${kernels/Interruption.h|/}
forbid "An OpenGL class knows Kernels, the builder or the mapper" \
  "$numbers|vtkFlatBlock|FlatBlockVolumeInput" Module/vtkOpenGLFlatBlock*.{h,cxx} \
  Module/FlatBlockRayCasterProgram.*
forbid "The levels know the builder, the mapper or an OpenGL class" \
  "$kernels|vtkFlatBlock(Builder|VolumeMapper)|vtkOpenGL" Module/vtkFlatBlockLevels.*
forbid "The builder knows the mapper or an OpenGL class" \
  "vtkFlatBlockVolumeMapper|vtkOpenGL" Module/vtkFlatBlockBuilder.* \
  Module/vtkFlatBlockTransferFunction.* Module/FlatBlockVolumeInput.*
forbid "The plugin knows more than the mapper" \
  "$core|$kernels|vtkOpenGLFlatBlock|vtkFlatBlockBuilder|vtkFlatBlockLevels|vtkFlatBlockTransferFunction" \
  $(find Plugin -name '*.h' -o -name '*.cxx')
forbid "OpenGL's loader is included elsewhere" "vtk_glew" \
  $(find Module Plugin Kernels -name '*.h' -o -name 'vtkFlatBlock*.cxx')
exit $((failures > 0))
