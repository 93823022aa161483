#!/bin/sh
# Lint gates of the Verilog: Verilator -Wall, Icarus -g2005 -Wall and Yosys, without waivers, for the core in very
# different configurations, for every stage alone, and for illegal configurations, which must not elaborate.
# One line a check; exit 1 with the tool's message at the first that fails.
#   lint.sh CONFIGURATIONS [FILTER]     only the checks whose line contains FILTER
# CONFIGURATIONS is the program of configurations.cpp, which draws those of the core.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
filter=${2:-}
log=$(mktemp)
list=$(mktemp)
trap 'rm -f "$log" "$list"' EXIT
"$1" >"$list" || exit 1

libraries="" sources=""
for folder in rtl rtl/stage rtl/perturb rtl/unit rtl/lib; do
  libraries="$libraries -y $root/$folder -I$root/$folder"
  if ls "$root/$folder"/*.v >/dev/null 2>&1; then sources="$sources $root/$folder/*.v"; fi
done
file_of() { ls "$root"/rtl/"$1.v" "$root"/rtl/*/"$1.v" 2>/dev/null; }

# check NAME COMMAND...: passes when the command succeeds and prints nothing.
check() {
  name=$1
  shift
  case "$name" in *"$filter"*) ;; *) return ;; esac
  if ! "$@" >"$log" 2>&1 || [ -s "$log" ]; then
    echo "FAILED $name"
    cat "$log"
    exit 1
  fi
  echo "passed $name"
}

# refused NAME FAULT COMMAND...: passes when the command fails and names the fault.
refused() {
  name=$1
  fault=$2
  shift 2
  case "$name" in *"$filter"*) ;; *) return ;; esac
  if "$@" >"$log" 2>&1 || ! grep -q "$fault" "$log"; then
    echo "FAILED $name: $fault was not reported"
    cat "$log"
    exit 1
  fi
  echo "passed $name"
}

verilator_lint() { # TOP [NAME=VALUE...]
  top=$1
  shift
  flags=""
  for setting in "$@"; do flags="$flags -G$setting"; done
  # shellcheck disable=SC2086
  verilator --lint-only -Wall --default-language 1364-2005 --top-module "$top" $flags \
    $libraries "$(file_of "$top")"
}

icarus_lint() {
  top=$1
  shift
  flags=""
  for setting in "$@"; do flags="$flags -P$top.$setting"; done
  # shellcheck disable=SC2086
  iverilog -g2005 -Wall -s "$top" $flags $libraries -o /dev/null "$(file_of "$top")"
}

yosys_run() { # SCRIPT TOP [NAME=VALUE...]
  script=$1
  top=$2
  shift 2
  flags=""
  for setting in "$@"; do flags="$flags -set ${setting%%=*} ${setting#*=}"; done
  read="read_verilog -defer $sources"
  yosys -q -e . -p "$read; ${flags:+chparam $flags $top;} hierarchy -check -top $top; $script"
}

yosys_check() { yosys_run "proc; check -assert" "$@"; }
yosys_synthesize() { yosys_run "synth -run coarse: -noabc; check -assert" "$@"; }

all_three() { # NAME [NAME=VALUE...]
  configuration=$1
  shift
  check "verilator core: $configuration" verilator_lint wrinkle_core "$@"
  check "icarus    core: $configuration" icarus_lint wrinkle_core "$@"
  check "yosys     core: $configuration" yosys_check wrinkle_core "$@"
}

# The first line, which is empty, is the default.
while read -r settings; do
  # shellcheck disable=SC2086
  all_three "${settings:-default}" $settings
done <"$list"

# Every module of a stage alone, with the widths it has where nobody gives others.
for file in "$root"/rtl/stage/*.v "$root"/rtl/perturb/*.v; do
  module=$(basename "$file" .v)
  check "verilator $module alone" verilator_lint "$module"
  check "icarus    $module alone" icarus_lint "$module"
  check "yosys     $module alone, synthesized" yosys_synthesize "$module"
done

# Whole cores that differ in what each stage has, synthesized.
synthesized() { # NAME [NAME=VALUE...]
  configuration=$1
  shift
  check "yosys     core: $configuration, synthesized" yosys_synthesize wrinkle_core "$@"
}
number=0
for datapath in $(sed -n 's/.*datapath\/\([a-z_0-9]*\)\.h".*/\1/p' "$root/golden/datapath/list.def"); do
  all_three "datapath $datapath" "DATAPATH=$number"
  synthesized "datapath $datapath" "DATAPATH=$number"
  number=$((number + 1))
done
synthesized "shared and single" SHARING=1 BUFFERING=1
synthesized "normalized after" NORMALIZE_ORDER=1 SELF_SHADOW=0
synthesized "reflection" LIGHTING=2
synthesized "half-angle at every pixel" LIGHTING=3

refused "verilator refuses TEXEL_BITS=11" wrinkle_error_texel_bits verilator_lint wrinkle_core TEXEL_BITS=11
refused "icarus refuses TEXEL_BITS=11" wrinkle_error_texel_bits icarus_lint wrinkle_core TEXEL_BITS=11
refused "yosys refuses TEXEL_BITS=11" wrinkle_error_texel_bits yosys_check wrinkle_core TEXEL_BITS=11
refused "verilator refuses DATAPATH=99" wrinkle_error_datapath verilator_lint wrinkle_core DATAPATH=99
refused "icarus refuses WIDE_BITS=23" wrinkle_error_wide_bits icarus_lint wrinkle_core WIDE_BITS=23
refused "yosys refuses LIGHTING=4" wrinkle_error_lighting yosys_check wrinkle_core LIGHTING=4
refused "verilator refuses constant light in the rotated frame" wrinkle_error_light_vectors_turn \
  verilator_lint wrinkle_core DATAPATH=3 LIGHT_VECTORS=1
refused "icarus refuses blinn without a normalizer" wrinkle_error_normalizer_n_must_take_any_length \
  icarus_lint wrinkle_core DATAPATH=2 NORMALIZER_N=0
refused "yosys refuses a half-angle at every pixel without a normalizer" \
  wrinkle_error_normalizer_h_must_take_any_length yosys_check wrinkle_core LIGHTING=3 NORMALIZER_H=0
refused "verilator refuses to share constant light vectors" wrinkle_error_sharing_is_of_n_l_h \
  verilator_lint wrinkle_core SHARING=1 LIGHT_VECTORS=1
refused "icarus refuses to share two kinds of normalizer" wrinkle_error_sharing_is_of_n_l_h \
  icarus_lint wrinkle_core SHARING=1 NORMALIZER_H=0
refused "yosys refuses BUFFERING=2" wrinkle_error_buffering yosys_check wrinkle_core BUFFERING=2
refused "icarus refuses self-shadow of vectors that are normalized after" wrinkle_error_normalize_order_after \
  icarus_lint wrinkle_core NORMALIZE_ORDER=1
refused "yosys refuses constant light of vectors that are normalized after" wrinkle_error_normalize_order_after \
  yosys_check wrinkle_core NORMALIZE_ORDER=1 SELF_SHADOW=0 LIGHT_VECTORS=1
refused "verilator refuses FILTER=3" wrinkle_error_filter verilator_lint wrinkle_core FILTER=3
refused "icarus refuses DOT_BITS > 2 UNIT_BITS" wrinkle_error_dot_bits_exceeds icarus_lint wrinkle_core UNIT_BITS=6 \
  DOT_BITS=13 POWER_BITS=13
refused "yosys refuses POWER_BITS < DOT_BITS" wrinkle_error_power_bits_is_less yosys_check wrinkle_core POWER_BITS=9
refused "verilator refuses RECIPROCAL_BITS < Q_BITS - 1" wrinkle_error_reciprocal_bits_is_less \
  verilator_lint wrinkle_core PERSPECTIVE=1 Q_BITS=18 RECIPROCAL_BITS=16
