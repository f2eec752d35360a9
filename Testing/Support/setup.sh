# Sourced by Examples/run.sh and Testing/run.sh: installs what is missing, configures, builds.

set -euo pipefail
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# ParaView with its VTK, and what find_package(ParaView) cannot do without.
build_packages=(
  g++ cmake ninja-build libboost-dev libgtest-dev
  paraview paraview-dev python3-paraview libpython3-dev mpi-default-dev
  libfreetype-dev libgl-dev libglew-dev libopengl-dev libx11-dev zlib1g-dev)
# The plugin's panel, and what ParaView's Qt libraries link to.
build_packages+=(
  qtbase5-dev qttools5-dev libqt5svg5-dev libqt5opengl5-dev libqt5x11extras5-dev
  libxml2-dev libhdf5-mpi-dev libnetcdf-dev)
# A display where there is none, OpenGL in software, and a real MRI.
run_packages=(xvfb xauth libgl1-mesa-dri locales mricron-data)

logged() { # NAME COMMAND...
  local log="$project/build/$1.log"
  shift
  mkdir -p "$project/build"
  "$@" >"$log" 2>&1 </dev/null || { cat "$log" >&2; exit 1; }
}

missing_packages() { # PACKAGE...
  local package
  for package in "$@"; do
    if ! dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed; then
      echo "$package"
    fi
  done
}

install_packages() { # PACKAGE...
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  local command="apt-get install -y --no-install-recommends ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    if sudo -n true 2>/dev/null || { [ -t 0 ] && command -v sudo >/dev/null; }; then
      as_root=(sudo)
    else
      printf '%s Run, as root:\n  apt-get update && %s\n' \
        "Packages are missing, and there is no root or sudo to install them." "$command" >&2
      exit 1
    fi
  fi
  echo "Installing ${#missing[@]} packages ..."
  logged packages "${as_root[@]}" apt-get update
  logged packages "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive $command
}

configure() { # PRESET [CMAKE OPTION...]
  local preset=$1
  shift
  if [ ! -f "$project/build/$preset/build.ninja" ]; then
    echo "Configuring and building $preset ..."
    logged configure env -C "$project" cmake --preset "$preset" "$@"
    grep -E '^-- (VTK|CUDA|OpenMP)' "$project/build/configure.log"
  fi
}

build() { # PRESET [CMAKE OPTION...]
  configure "$@"
  logged build cmake --build "$project/build/$1"
}
