#!/bin/sh
# The normalizers alone, in Verilog, against the golden model (normalizer.cpp).
#   normalizer.sh BUILD                all kinds, at the ends and in the middle of F and V
#   normalizer.sh BUILD --exhaustive   the faithful one at F = V = 8 over every triple of magnitudes, about a minute
# BUILD is the build directory, for its libraries.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
mode=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run KIND F V
run() {
  dir=$work/$1_$2_$3
  if ! verilator --cc --exe --build -O3 --x-assign fast --default-language 1364-2005 -Wno-fatal \
    -GKIND="$1" -GUNIT_BITS="$2" -GVECTOR_BITS="$3" -GPIPELINED=0 --top-module wrinkle_normalizer -y "$root/rtl/lib" \
    -CFLAGS "-std=c++20 -O2 -I$root -DKIND=$1 -DUNIT_BITS=$2 -DVECTOR_BITS=$3" \
    -LDFLAGS "$build/libgolden_pixel.a $build/libgolden_triangle.a $build/libgolden_texel.a $build/libgolden_config.a -lhwy" \
    --Mdir "$dir" -o check "$root/rtl/lib/wrinkle_normalizer.v" "$root/tests/rtl/normalizer.cpp" >"$dir.log" 2>&1; then
    cat "$dir.log"
    exit 1
  fi
  "$dir/check" $mode
}

if [ "$mode" = --exhaustive ]; then
  run 1 8 8
  exit
fi
run 1 9 9
run 1 8 8
run 1 6 18
run 1 16 5
run 1 12 12
run 2 9 9
run 3 9 9
run 3 10 12
