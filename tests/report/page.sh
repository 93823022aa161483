#!/usr/bin/env bash
# usage: page.sh WRINKLE FOLDER
# Makes a report without synthesis and timing, and checks its tables and its page. Then it does the same with made-up
# areas, since the charts that show areas would be empty otherwise.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
"$1" report --no-area --no-speed --configs lean,standard,blinn --scenes patch_fig1,patch_fig6 --output "$2"
# Fails unless a line of file $2 matches the pattern $1.
has() { grep -q "$1" "$2" || { echo "$2 has no line that matches $1"; exit 1; }; }
has '^configurations,"standard, patch_fig6",precision_db,[0-9]' "$2/report.csv"
has '^"error of blinn, patch_fig1",normaliz[a-z]*,ulp_max,[0-9]' "$2/report.csv"
has '^pictures,fig5 against fig6,psnr_db,39' "$2/report.csv"
has '^| standard, patch_fig6 | patch_fig6 | normal_map | faithful |' "$2/report.md"
has '^choices,lean,self_shadow,hard' "$2/report.csv"
has '^provenance,command,value,.*/wrinkle report' "$2/report.csv"
/usr/bin/python3 "$here/page.py" "$2/report.html"
/usr/bin/python3 "$here/made_up_areas.py" "$2/report.json" >"$2/made_up.json"
"$1" report --from "$2/made_up.json" --output "$2/made_up"
has '^figures,fig3,over_fig1,0.0006' "$2/made_up/report.csv"
exec /usr/bin/python3 "$here/page.py" --screenshot "$2/page.png" "$2/made_up/report.html"
