#!/usr/bin/env bash
# Draws a volume: Examples/run.sh [FILE] [OPTIONS]. Installs and builds what is missing first.
# --help lists the files and options. Without FILE: a real MRI from Debian's mricron-data.
source "$(dirname "${BASH_SOURCE[0]}")/../Testing/Support/setup.sh"

for word in "$@"; do
  if [ "$word" = --interactive ] && [ -z "${DISPLAY:-}" ]; then
    echo "--interactive needs a display, and DISPLAY is not set." >&2
    exit 1
  fi
done

install_packages "${build_packages[@]}" "${run_packages[@]}"
configure release
logged build cmake --build "$project/build/release" --target FlatBlockView
exec "$project/Testing/Support/with-display.sh" "$project/build/release/bin/FlatBlockView" \
  --default /usr/share/mricron/templates/ch2better.nii.gz "$@"
