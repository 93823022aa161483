#!/bin/sh
# Every table of linear segments in Verilog, at every input, against the golden model (tables.cpp).
#   tables.sh BUILD [RTL]     BUILD is the build directory, for its libraries; RTL other Verilog than the project's
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
rtl=${2:-$root/rtl}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

golden="$build/libgolden_pixel.a $build/libgolden_triangle.a $build/libgolden_texel.a $build/libgolden_config.a
$build/libgolden_pixel.a -lhwy"
# shellcheck disable=SC2086
"${CXX:-c++}" -std=c++20 -O1 -I"$root" "$root/tests/rtl/tables.cpp" $golden -o "$work/wrapper"
"$work/wrapper" --wrapper "$work/tables.v"
if ! verilator --cc --exe --build -O3 -fno-const-bit-op-tree --x-assign fast --default-language 1364-2005 -Wno-fatal \
  --top-module tables -y "$rtl/unit" -y "$rtl/lib" -CFLAGS "-std=c++20 -I$root -DTABLES_MODEL" -MAKEFLAGS "OPT_SLOW=-O0 OPT_FAST=-O1" -j 2 \
  -LDFLAGS "$(echo $golden)" --Mdir "$work/model" -o check "$work/tables.v" "$root/tests/rtl/tables.cpp" \
  >"$work/log" 2>&1; then
  cat "$work/log"
  exit 1
fi
"$work/model/check"
