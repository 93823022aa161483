#!/bin/sh
# The normalizers alone, in Verilog, against the golden model (normalizer.cpp).
#   normalizer.sh BUILD                     every kind once
#   normalizer.sh BUILD --every-width       `compact` at every F and with V below, at and above it, half an hour
#   normalizer.sh BUILD --exhaustive KIND   one kind at F = V = 8 over every triple of magnitudes, minutes
# KIND is faithful, compact, lite or near. BUILD is the build directory, for its libraries.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
mode=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run KIND F V
run() {
  dir=$work/$1_$2_$3
  if ! verilator --cc --exe --build -O3 -fno-const-bit-op-tree --x-assign fast --default-language 1364-2005 -Wno-fatal \
    -GNORMALIZER="$1" -GUNIT_BITS="$2" -GVECTOR_BITS="$3" --top-module wrinkle_unit_vector -y "$root/rtl/unit" -y "$root/rtl/lib" \
    -CFLAGS "-std=c++20 -O2 -I$root -DKIND=$1 -DUNIT_BITS=$2 -DVECTOR_BITS=$3" \
    -LDFLAGS "$build/libgolden_pixel.a $build/libgolden_triangle.a $build/libgolden_texel.a $build/libgolden_config.a -lhwy" \
    --Mdir "$dir" -o check "$root/rtl/unit/wrinkle_unit_vector.v" "$root/tests/rtl/normalizer.cpp" >"$dir.log" 2>&1; then
    cat "$dir.log"
    exit 1
  fi
  "$dir/check" $mode
}

number() {
  case $1 in
    faithful) echo 1 ;;
    compact) echo 2 ;;
    lite) echo 3 ;;
    near) echo 4 ;;
    *) echo "$1: not a kind of normalizer" >&2; exit 1 ;;
  esac
}

if [ "$mode" = --exhaustive ]; then
  run "$(number "${3:-compact}")" 8 8
  exit
fi
if [ "$mode" = --every-width ]; then
  for f in 6 7 8 9 10 11 12 13 14 15 16; do run 2 "$f" "$f"; done
  run 2 16 5
  run 2 6 18
  run 4 12 16
  run 3 16 16
  exit
fi
run 1 9 9
run 2 9 9
run 3 8 9
run 4 10 9
