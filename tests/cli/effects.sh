# SPDX-License-Identifier: LGPL-2.1-or-later
# Effects: the report runs nothing, auto says what it chose and why, what is on is in the results.
program=$1
shield=$2/prm/whipple_shield.prm
rm -rf output

"$program" run "$shield" --effects-report >report.txt
grep -q '^sphere on bumper at 6.58 km/s: 89.2 GPa' report.txt || { cat report.txt; exit 1; }
grep -q '^auto would choose' report.txt
[ ! -e output ] || { echo 'the report wrote something'; exit 1; }

"$program" run "$shield" --set 'Stages/List = perforation' --set 'Stages/perforation/End = 0.2 us' \
  --set 'Mesh/Finest cell = 0.016 cm' --set 'Materials/aluminium/Thermal model = constant specific heat' \
  --set 'Effects/List = auto' --output output/auto >out.txt
grep -q '^  melting  *on ' output/auto/log.txt || { cat output/auto/log.txt; exit 1; }
grep -q '"melt_share"' output/auto/summary.json
grep -q 'aluminium temperature' output/auto/fields.xdmf
grep -q 'List *= body tags, melting, strength, voids' output/auto/parameters.prm || { grep -n List output/auto/parameters.prm; exit 1; }

# the parameters in force choose the same effects again
"$program" run output/auto/parameters.prm --validate
