# SPDX-License-Identifier: LGPL-2.1-or-later
# --validate accepts every scene and every study that comes with Whipple, on one rank and two, and writes nothing; the
# published shield warns of nothing, a poor one in one line a warning, which a run counts.
program=$1
source=$2
rm -rf output # of a run of this test that failed

for scene in "$source"/prm/*.prm "$source"/prm/verification/*.prm "$source"/bench/*.prm; do
  "$program" run "$scene" --validate
done
for study in "$source"/prm/*.prm "$source"/prm/studies/*.prm "$source"/prm/verification/*.prm; do
  ! grep -q '^subsection Study' "$study" || "$program" study "$study" --validate
done
"$program" run "$source/prm/whipple_shield.prm" --validate -n 2
"$program" run "$source/prm/whipple_shield.prm" --validate >said.txt
grep -q 'whipple_shield.prm: fine. 3 stages, about .* steps of at most .* cells: .* of one core, .* MB' said.txt || { cat said.txt; exit 1; }
! grep warning said.txt || { echo 'a false alarm'; exit 1; }
thin='Bodies/bumper/Thickness = 0.009 cm'
"$program" run "$source/prm/whipple_shield.prm" --validate -n 2 --set "$thin" >said.txt
[ "$(grep warning said.txt)" = "$(grep "^warning: body 'bumper' is 0.009 cm thin, 2.25 finest cells" said.txt)" ] || { cat said.txt; exit 1; }
[ ! -e output ] || { echo 'something was written'; exit 1; }

"$program" run "$source/prm/whipple_shield.prm" --output output/thin --set "$thin" --set 'Stages/List = perforation' \
  --set 'Stages/perforation/End = 0.01 us' --set 'Output/Fields interval = none' >out.txt
grep -q "^warning: body 'bumper' is 0.009 cm thin" output/thin/log.txt
grep -q '^warning: stage perforation: remnants given away by cells left almost empty' output/thin/log.txt
grep -q '"warnings": 2' output/thin/summary.json || { grep warnings output/thin/summary.json; exit 1; }
rm -r output
