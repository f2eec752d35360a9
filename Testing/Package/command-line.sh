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
refused "has no header, and its name has no numbers" ten.raw
head -c 1000 /dev/zero >ten_10x10x10_uint16.raw
refused "is not what 1000 bytes hold" ten_10x10x10_uint16.raw
head -c 2000 /dev/zero >ten_10x10x10.raw
refused "has no type of so many samples in 2000 bytes" ten_10x10x10.raw
refused "1000 bytes, but --raw asks for 1010" ten.raw --raw 10 10 10 uint8 --header 10
printf 'PVM\n2 2 2\n1\n1234567' >short.pvm
refused "short.pvm': at byte 19: the file ends, but 20 bytes are expected" short.pvm
printf '\0\2\0\2' >short.df3
refused "short.df3': at byte 4: the file ends within the header" short.df3
mkdir one
printf 'no image' >one/a.png
refused "could not be read" one
printf 'NDims = 4\nElementDataFile = LOCAL\n' >four.mha
refused "NDims is '4', but 3 is expected" four.mha
printf 'NDims = 3\nDimSize = 9 9 9\nElementType = MET_SHORT\nElementDataFile = /no/where\n' >no.mhd
refused "its ElementDataFile '/no/where' is no file that can be read" no.mhd
printf 'NDims = 3\nDimSize = 999999999 999999999 9\nElementType = MET_SHORT\nElementDataFile = LOCAL\n' >big.mha
refused "bytes of samples, but holds less" big.mha
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
head -c 4096 /dev/urandom >cube.raw
accepted cube.raw
head -c 4096 /dev/urandom >foot_16x16x8_uint16_be.raw
accepted foot_16x16x8_uint16_be.raw
head -c 1010 /dev/urandom >header.raw
accepted header.raw --raw 10 10 10 uint8 --header 10
{ printf 'PVM\n8 8 8\n1\n'; head -c 512 /dev/urandom; } >eight.pvm
accepted eight.pvm
{ printf '\0\10\0\10\0\10'; head -c 1024 /dev/urandom; } >eight.df3
accepted eight.df3
mkdir 'a folder with spaces'
cp ten.raw 'a folder with spaces/zähne.raw'
accepted 'a folder with spaces/zähne.raw' --raw 10 10 10 uint8
exit $((failures > 0))
