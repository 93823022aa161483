#!/usr/bin/env bash
# usage: page.sh WRINKLE FOLDER      makes a report without synthesis and timing, and looks at it as page.py does
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
"$1" report --no-area --no-speed --configs lean,standard --scenes patch_fig1,patch_fig6 --output "$2"
grep -q '^configurations,standard,precision_db,[0-9]' "$2/report.csv"
grep -q '^| standard | tangent | faithful |' "$2/report.md"
exec /usr/bin/python3 "$here/page.py" "$2/report.html" "$2/page.png"
