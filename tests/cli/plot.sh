# SPDX-License-Identifier: LGPL-2.1-or-later
# What ./whipple plot draws of a run: each option leaves its pictures, only what is new is drawn, what is not there or not so is
# said in one line.
program=$1 source=$2
# shellcheck source=tests/cli/common/refuses.sh
. "$source/tests/cli/common/refuses.sh"
/usr/bin/python3 -c 'import matplotlib, h5py' 2>/dev/null || exit 77

run() {
  "$program" run "$source/prm/whipple_shield.prm" --output "$1" --set 'Mesh/Finest cell = 0.064 cm' --set 'Mesh/Levels = 2' \
    --set 'Stages/perforation/End = 0.8 us' --set 'Stages/wall/End = for 0.1 us' --set 'Output/Formats = hdf5' --set "$2" \
    --set "Output/History interval = ${3-none}" >/dev/null
}
plot() {
  /usr/bin/python3 "$source/scripts/plot_run.py" "$@"
}
# draws NAMES OPTIONS...: these files are in a new folder afterwards, and no others
draws() {
  names=$1
  shift
  rm -rf drawn
  plot full --output drawn "$@" >said.txt 2>err.txt
  [ "$(ls drawn | sort | tr '\n' ' ')" = "$names " ] || { echo "not '$names' but:"; ls drawn; exit 1; }
}
picture_size() {
  /usr/bin/python3 -c 'import sys; from PIL import Image; print(*{Image.open(p).size for p in sys.argv[1:]})' "$@"
}

rm -rf full bare drawn
run full 'Output/Fields interval = 5 us'

# written times: all of one size; drawn again only if something has changed
plot full >said.txt 2>err.txt
grep -q ': 9 drawn, 0 as they were' err.txt
[ "$(picture_size full/pictures/fields-*.png | wc -w)" -eq 2 ]
plot full >said.txt 2>err.txt
grep -q ': 0 drawn, 9 as they were' err.txt
rm full/pictures/fields-00001.png
touch full/fields/fields-00003.h5
plot full >said.txt 2>err.txt
grep -q ': 2 drawn, 7 as they were' err.txt
plot full --again >said.txt 2>err.txt
grep -q ': 9 drawn' err.txt

# results against time: a picture for each place that has changed
run told 'Output/Fields interval = none' '0.1 us'
plot told >said.txt 2>err.txt
ls told/pictures >names.txt
grep -qx 'history-bumper.png' names.txt && grep -qx 'history-debris.png' names.txt || { cat names.txt; exit 1; }

draws 'fields-00000.png fields-00003.png fields-00006.png' --every 3
draws 'fields-00007.png fields-00008.png' --stage wall
draws 'velocity-00001.svg' --field velocity --time 0.79 --stage perforation --format svg
draws 'pressure-plastic_strain-00000.png' --field pressure,plastic_strain --time 0 --stage perforation
for field in speed,speed bodies mesh 'deviatoric stress 11'; do
  plot full --field "$field" --time 1 --output fields >said.txt 2>err.txt || { cat err.txt; exit 1; }
done
draws 'fields-00000.png' --time 0 --window 1 -0.5 0.5
draws 'fields-00000.png' --time 0 --planar --window -1 1 -0.5 0.5
end=gif
! command -v ffmpeg >/dev/null || end=mp4
draws "fields-00000.png fields-00004.png fields-00008.png film-fields.$end" --every 4 --film
run other 'Output/Fields interval = 8 us'
draws 'against-fields-00002.png' --against other --time 1

plot full --radiograph --time 9 --output radiograph >said.txt
[ "$(ls radiograph)" = "$(basename "$(cat said.txt)")" ]
plot full --strip >said.txt
[ -s full/pictures/strip.png ]
draws 'figure-2a.png figure-2b.png figure-2c.png figure-3.png handover-1.png handover-2.png' --figure all
plot full --debris >said.txt
[ -s full/pictures/debris.png ] && [ -s full/pictures/load-wall.png ]
plot full --limit >said.txt
[ -s full/pictures/ballistic_limit.png ]

refuses "has no figure '3f'; it has: all, handovers, 2a, 2b, 2c, 3" plot full --figure 3f
refuses "'0' is not a whole number from 1" plot full --every 0
refuses "'-3' is not a whole number from 1" plot full --every=-3
refuses "there is no stage 'landing'; there is: perforation, debris, wall" plot full --stage landing
refuses "there is no field 'colour'" plot full --field colour
refuses 'one quantity, or two' plot full --field a,b,c
refuses 'R Z_MIN Z_MAX' plot full --window 1 2
refuses 'R Z_MIN Z_MAX' plot full --window 1 2 1
refuses 'there is no such directory' plot full --against nowhere
refuses 'there is no such directory' plot nowhere
refuses 'a film is made of png' plot full --film --format svg
refuses '--field goes with' plot full --field speed --strip
mkdir -p neither
refuses 'neither the output of a run' plot neither
head -c 3000 full/fields/fields-00002.h5 >cut.h5
mv full/fields/fields-00002.h5 whole.h5
mv cut.h5 full/fields/fields-00002.h5
refuses 'fields-00002.h5: is cut short' plot full
mv whole.h5 full/fields/fields-00002.h5

mkdir -p study
for content in '{}' '{"study": ' '[]'; do
  printf '%s' "$content" >study/study.json
  refuses 'study.json' /usr/bin/python3 "$source/scripts/plot_study.py" study
done

refuses 'unrecognized arguments: --every' /usr/bin/python3 "$source/scripts/plot_study.py" study --every 3
refuses 'unrecognized arguments' /usr/bin/python3 "$source/scripts/write_report.py" full --radiograph
printf '{}' >bare_summary.json
mv full/summary.json whole.json
cp bare_summary.json full/summary.json
refuses "summary.json: has no 'status'" plot full
mv whole.json full/summary.json

run bare 'Output/Fields interval = none'
refuses 'has no fields: set Output/Fields interval' plot bare --strip
refuses 'has no fields: set Output/Fields interval' plot bare --field speed
refuses 'has no fields: set Output/Fields interval' plot bare
plot bare --limit >said.txt
[ -s bare/pictures/ballistic_limit.png ]
