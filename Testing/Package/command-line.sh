#!/usr/bin/env bash
# FlatBlockView at a terminal: every mistake gives one line and status 1, and writes nothing.
# command-line.sh FLATBLOCKVIEW WITH_DISPLAY
set -u
view=$1
with_display=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

refused() { # WORDS ARGUMENT...
  local words=$1 output status
  shift
  output=$("$with_display" "$view" --output "$work/picture.png" "$@" 2>&1)
  status=$?
  if [ "$status" -ne 1 ] || ! grep -qF -- "$words" <<<"$output" || [ -e picture.png ] ||
    [ "$(grep -c '^FlatBlockView: ' <<<"$output")" -ne 1 ]; then
    printf 'FAILED (status %d): %s\n%s\n' "$status" "$*" "$output"
    failures=$((failures + 1))
    rm -f picture.png
  fi
}

head -c 1000 /dev/zero >ten.raw
printf 'not a volume' >broken.nii
printf 'not a volume' >broken.nrrd
printf 'not a volume' >picture.jpeg
mkdir empty
refused "No file was named"
refused "does not exist" nowhere.nii
refused "ends in none of" picture.jpeg
refused "could not be read" broken.nii
refused "could not be read" broken.nrrd
refused "could not be read" empty
refused "has no header" ten.raw
refused "1000 bytes, but --raw asks for 2000" ten.raw --raw 10 10 10 int16
refused "is none of uint8" ten.raw --raw 10 10 10 complex
refused "is not a number" ten.raw --raw 10 ten 10 uint8
refused "is not a number" ten.raw --raw 10 10 -10 uint8
refused "something is missing" ten.raw --raw 10 10
refused "is none of the presets" ten.raw --preset xray
refused "17, 33 or 65" ten.raw --block-size 32
refused "'--unknown' is unknown" ten.raw --unknown
refused "One file at a time" ten.raw broken.nii

accepted() { # ARGUMENT...
  if ! "$with_display" "$view" --output picture.png --size 64 64 "$@" >table 2>&1 ||
    [ ! -s picture.png ]; then
    printf 'FAILED: %s\n' "$*"
    cat table
    failures=$((failures + 1))
  fi
  for row in dimensions 'scalar type' volume blocks atlas 'seconds to first frame' \
    'seconds a frame' picture; do
    grep -q "^$row " table || { echo "no row '$row'"; failures=$((failures + 1)); }
  done
  rm -f picture.png
}
for preset in mri ct-bone ct-skin angio grey; do
  accepted ten.raw --raw 10 10 10 uint8 --preset "$preset"
done
accepted ten.raw --raw 10 10 5 int16 --spacing 1 2 0.5 --big-endian --block-size 17
mkdir 'a folder with spaces'
cp ten.raw 'a folder with spaces/zähne.raw'
accepted 'a folder with spaces/zähne.raw' --raw 10 10 10 uint8
exit $((failures > 0))
