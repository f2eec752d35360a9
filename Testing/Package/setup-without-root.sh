#!/usr/bin/env bash
# With neither root nor sudo the scripts print the exact apt command and stop with status 1.
set -u
output=$(
  exec 2>&1 </dev/null
  source "$(dirname "${BASH_SOURCE[0]}")/../Support/setup.sh"
  id() { echo 1000; }
  sudo() { return 1; }
  dpkg-query() { [ "${*: -1}" = present ] && echo installed; }
  install_packages present first second
)
status=$?
echo "$output"
[ "$status" -eq 1 ] &&
  grep -qx '  apt-get update && apt-get install -y --no-install-recommends first second' <<<"$output"
