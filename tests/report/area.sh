#!/usr/bin/env bash
# usage: area.sh WRINKLE      Fig. 1, 2 and 3 against tests/baselines/area.json
set -euo pipefail
if [[ ${WRINKLE_LONG:-0} != 1 ]]; then
  echo "skipped: synthesis of three figures takes minutes; ./wrinkle test --long"
  exit 77
fi
if [[ ! -f $(dirname "$(readlink -f "$0")")/../baselines/area.json ]]; then
  echo "skipped: no tests/baselines/area.json; ./wrinkle area --keep writes it"
  exit 77
fi
exec "$1" area --check
