#!/usr/bin/env bash
# Takes a picture of ParaView with the MRI and the panel: Examples/ParaView/screenshot.sh [FILE.png]
# On a display of its own, with settings of its own.
here=$(dirname "${BASH_SOURCE[0]}")
source "$here/../../Testing/Support/setup.sh"

if [ -z "${FLATBLOCK_SCREENSHOT:-}" ]; then
  install_packages "${build_packages[@]}" "${run_packages[@]}" imagemagick xdotool
  build release
  FLATBLOCK_SCREENSHOT=$(realpath "${1:-paraview.png}") exec xvfb-run -a \
    -s "-screen 0 1500x1250x24" "${BASH_SOURCE[0]}"
fi

drag() { # FROM_X FROM_Y TO_X TO_Y
  xdotool mousemove "$1" "$2" sleep 0.3 mousedown 1 sleep 0.3
  for i in 1 2 3; do # slowly, since the view is drawn each time
    xdotool mousemove $(($1 + ($3 - $1) * i / 3)) $(($2 + ($4 - $2) * i / 3))
    sleep 3
  done
  xdotool mouseup 1
  sleep 10
}

home=$(mktemp -d)
mkdir -p "$home/.config/ParaView"
printf '[General]\nGeneralSettings.ShowWelcomeDialog=false\n' \
  >"$home/.config/ParaView/ParaView5.11.0.ini"
PV_PLUGIN_PATH="$project/build/release/lib/paraview-5.11/plugins/FlatBlockVolumePlugin" \
  XDG_RUNTIME_DIR="$home" HOME="$home" paraview --script="$here/mri_state.py" &
sleep 30
window=$(xdotool search --name "ParaView 5" | tail -1)
xdotool windowmove "$window" 0 0 windowsize "$window" 1500 1250
sleep 25
drag 297 900 560 900 # the panel wider
drag 150 527 150 215 # and higher than the pipeline
xdotool mousemove 12 1100 click --repeat 8 --delay 200 5 # to the representation's own groups
sleep 20
import -window root -resize 1100x -colors 255 "png8:$FLATBLOCK_SCREENSHOT"
kill %1 2>/dev/null
rm -rf "$home"
