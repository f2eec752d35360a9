#!/usr/bin/env bash
# Builds everything and runs every test, on a virtual display where there is none:
# Testing/run.sh [--coverage | --fuzz [SECONDS] | --sanitize]
#   --coverage   lines of Kernels and Module/Core that the unit tests run, and no more
#   --fuzz       each of libFuzzer's targets for so many seconds (60), and no more
#   --sanitize   the unit tests under the sanitizers of addresses, undefined behaviour and threads, some
#                render tests under the first two, and no more
# Installs what is missing first.
source "$(dirname "${BASH_SOURCE[0]}")/Support/setup.sh"

# VTK 9.1 cannot be installed beside ParaView, but unpacked beside it. Its libraries want these.
vtk91_packages=(libvtk9-dev libvtk9.1 vtk9 python3-vtk9)
vtk91_needs=(libgl2ps1.4 libhdf5-103-1 libnetcdf19 libogg0 libproj25 libsqlite3-0 libtbb-dev libtcl8.6
  libtheora0 libtk8.6)

unpack_vtk91() {
  local sdk="$project/build/vtk91-sdk" archives deb
  [ ! -f "$sdk/complete" ] || return 0
  echo "Unpacking VTK 9.1 ..."
  archives=$(mktemp -d)
  logged download env -C "$archives" apt-get download "${vtk91_packages[@]}"
  mkdir -p "$sdk"
  for deb in "$archives"/*.deb; do
    dpkg -x "$deb" "$sdk"
  done
  rm -r "$archives"
  touch "$sdk/complete"
}

check_format() {
  command -v clang-format >/dev/null || { echo "clang-format is not here: not checked"; return 0; }
  echo "Checking the format ..."
  (cd "$project" && find Examples Kernels Module Plugin Testing \
    -name '*.cxx' -o -name '*.h' -o -name '*.cu*' | xargs clang-format --dry-run --Werror)
}

check_tidy() {
  command -v clang-tidy >/dev/null || { echo "clang-tidy is not here: not checked"; return 0; }
  echo "Checking with clang-tidy ..."
  (cd "$project" && find Examples Kernels Module Plugin -name '*.cxx' -not -name CudaAbsent.cxx |
    xargs -P "$(nproc)" -n 2 clang-tidy -p build/release --quiet 2>/dev/null)
}

run_tests() { # PRESET
  echo "Testing $1 ..."
  (cd "$project" && Testing/Support/with-display.sh ctest --preset "$1" -j "$(nproc)") || failures=1
}

# Those that crash leave their input in build/fuzz.
run_fuzzers() { # SECONDS
  local folder="$project/build/fuzz" name
  install_packages clang libclang-rt-14-dev cmake ninja-build
  logged fuzz cmake -G Ninja -S "$project/Testing/Fuzz" -B "$folder" -DCMAKE_CXX_COMPILER=clang++
  logged fuzz cmake --build "$folder"
  for name in PVM DF3 Atlas Table; do
    mkdir -p "$folder/corpus/$name"
    echo "Fuzzing $name for $1 s ..."
    (cd "$folder" && "./Fuzz$name" "corpus/$name" -max_total_time="$1" -max_len=2048 \
      -print_final_stats=1 2>"$name.log") || { tail -40 "$folder/$name.log"; failures=1; }
    grep executed_units "$folder/$name.log" || true
  done
}

# In builds that are slow by what they look for times mean nothing.
without_times=(--gtest_brief=1 '--gtest_filter=-*Milliseconds*')

# The unit tests, or others, alone, in a build of their own.
build_tests() { # PRESET [TARGET...]
  install_packages "${build_packages[@]}" "${vtk91_needs[@]}"
  unpack_vtk91
  logged configure env -C "$project" cmake --preset "$1"
  logged build cmake --build "$project/build/$1" --target FlatBlockUnitTests "${@:2}"
}

# Calls at random, frames that are given up, and what programs do to what is drawn. Leaks of the driver
# are not ours; it stays loaded, or nobody could tell whose they are.
run_render_tests_with_asan() {
  local tests='RandomCalls.*:StayingUp.*:*Interruption.Keeps*:Scenes.MarschnerLobb'
  "$project/Testing/Support/with-display.sh" env \
    LD_PRELOAD="$(g++ -print-file-name=libasan.so) $(find /usr/lib -name swrast_dri.so | tail -1)" \
    LSAN_OPTIONS="suppressions=$project/Testing/Support/leaks-of-others.txt:print_suppressions=0" \
    "$project/build/asan/Testing/FlatBlockRenderTests" --gtest_brief=1 "--gtest_filter=$tests"
}

run_sanitizers() {
  local archer
  install_packages clang libclang-rt-14-dev libomp-14-dev "${run_packages[@]}"
  build_tests asan FlatBlockRenderTests
  "$project/build/asan/Testing/FlatBlockUnitTests" "${without_times[@]}" || failures=1
  build_tests tsan
  archer=$(find /usr/lib/llvm-*/lib -name libarcher.so | tail -1) # tells of OpenMP's own order
  OMP_TOOL_LIBRARIES="$archer" TSAN_OPTIONS=ignore_noninstrumented_modules=1 \
    "$project/build/tsan/Testing/FlatBlockUnitTests" "${without_times[@]}" || failures=1
  run_render_tests_with_asan || failures=1
}

print_coverage() {
  install_packages gcovr
  build_tests coverage
  find "$project/build/coverage" -name '*.gcda' -delete
  logged coverage "$project/build/coverage/Testing/FlatBlockUnitTests" "${without_times[@]}"
  gcovr --root "$project" --filter 'Kernels/' --filter 'Module/Core/' --filter 'Module/IO/.*(Format|Codec)' \
    --exclude-throw-branches "$project/build/coverage"
}

failures=0
case "${1:-}" in
--coverage) print_coverage; exit ;;
--fuzz) run_fuzzers "${2:-60}"; exit "$failures" ;;
--sanitize) run_sanitizers; exit "$failures" ;;
esac
install_packages "${build_packages[@]}" "${run_packages[@]}" "${vtk91_needs[@]}"
check_format
build release -DFLATBLOCK_WARNINGS_AS_ERRORS=ON
check_tidy
unpack_vtk91
build vtk91 -DFLATBLOCK_WARNINGS_AS_ERRORS=ON
run_tests vtk91
run_tests release
exit "$failures"
