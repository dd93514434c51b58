# SPDX-License-Identifier: LGPL-2.1-or-later
# A tolerance on a scene without a study: coarse runs, the forecast, the run, and how wrong the forecast was; a budget
# that is too small stops before the run; and a run can estimate its own errors.
program=$1
source=$2

rm -rf output
# the bumper is bulged, not yet perforated, after 0.5 us
first='Stages/List = perforation'
short='Stages/perforation/End = 0.5 us'
cells='Mesh/Finest cell = 0.008 cm'
set -- --set "$first" --set "$short" --set "$cells" --set 'Output/Fields interval = none'
scene=$source/prm/whipple_shield.prm

status=0
"$program" study "$scene" "$@" --tolerance 'bumper crater depth = 0.0001 %' --budget '1 s' >out.txt 2>err.txt || status=$?
[ "$status" -eq 1 ] && grep -q '^whipple: the tolerance of 0.0001 % is not reached' err.txt || { cat err.txt; exit 1; }
grep -q '| cell size | expected error | expected time |' out.txt || { cat out.txt; exit 1; }
grep -Eq 'does not fit what is left of the budget|No cell size to choose from' out.txt || { cat out.txt; exit 1; }

"$program" study "$scene" "$@" --tolerance 'bumper crater depth = 60 %' >out.txt
grep -q '3 of 3 points are there already' out.txt || { cat out.txt; exit 1; }
grep -q 'Cheapest setting that reaches 60 %' out.txt || { cat out.txt; exit 1; }

"$program" run "$scene" "$@" --set 'Output/Error estimate = 3' --output output/run >out.txt
grep -Eq '^bumper crater_depth_cm [0-9.]+ \+- [0-9.]+ \(' out.txt || { tail out.txt; exit 1; }
grep -q '"error_bars"' output/run/summary.json
[ -s output/run/error_estimate/cell=0.032cm/summary.json ] || { ls output/run/error_estimate; exit 1; }
"$program" run "$scene" "$@" --output output/run --overwrite >out.txt
[ ! -e output/run/error_estimate ] || { echo 'left over'; exit 1; }
