#!/usr/bin/env bash
# Runs a command on the display at hand, or on a virtual one.
set -eu
if [ -n "${DISPLAY:-}" ]; then
  exec "$@"
fi
command -v xvfb-run >/dev/null || { echo "No display, and no xvfb-run to make one." >&2; exit 1; }
# -noreset: without it the server starts over whenever its last client leaves, and refuses the next.
exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
