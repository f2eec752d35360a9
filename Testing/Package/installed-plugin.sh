#!/usr/bin/env bash
# Installs the build, and draws with the installed plugin, as README says:
# installed-plugin.sh BUILD PVPYTHON
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$1" --prefix "$work" >"$work/log" || { cat "$work/log"; exit 1; }

cat >"$work/draw.py" <<'SCRIPT'
import os
from paraview import simple
view = simple.CreateRenderView()
display = simple.Show(simple.Wavelet(), view)
display.SetRepresentationType("Flat-block Volume")
simple.Render(view)
display.UpdatePropertyInformation()
print(display.GetProperty("FlatBlockStatus")[0], flush=True)
os._exit(0)
SCRIPT
export PV_PLUGIN_PATH
PV_PLUGIN_PATH=$(dirname "$(find "$work" -name FlatBlockVolumePlugin.so)")
"$(dirname "$0")/../Support/with-display.sh" "$2" --force-offscreen-rendering "$work/draw.py" |
  tee "$work/status"
grep -q '^Visible blocks: 1$' "$work/status"
