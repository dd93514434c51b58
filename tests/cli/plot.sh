# SPDX-License-Identifier: LGPL-2.1-or-later
# What ./whipple plot draws of a run: each option leaves its pictures, what is not there is said in one line.
program=$1 source=$2
# shellcheck source=tests/cli/common/refuses.sh
. "$source/tests/cli/common/refuses.sh"
/usr/bin/python3 -c 'import matplotlib, h5py' 2>/dev/null || exit 77

run() {
  "$program" run "$source/prm/whipple_shield.prm" --output "$1" --set 'Mesh/Finest cell = 0.064 cm' --set 'Mesh/Levels = 2' \
    --set 'Stages/perforation/End = 0.8 us' --set 'Stages/wall/End = for 0.1 us' --set 'Output/Formats = hdf5' --set "$2" >/dev/null
}
plot() {
  /usr/bin/python3 "$source/scripts/plot_run.py" "$@"
}

run full 'Output/Fields interval = 5 us'
plot full --radiograph --time 9 --output radiograph >said.txt
[ "$(ls radiograph)" = "$(basename "$(cat said.txt)")" ]
plot full --strip >said.txt
[ -s full/pictures/strip.png ]
plot full --figure all --output figures >said.txt
for name in handover-1 handover-2 figure-2a figure-2b figure-2c figure-3; do
  [ -s "figures/$name.png" ] || { echo "no figure $name"; exit 1; }
done
[ "$(find figures -type f | wc -l)" -eq 6 ]
plot full --debris >said.txt
[ -s full/pictures/debris.png ] && [ -s full/pictures/load-wall.png ]
plot full --limit >said.txt
[ -s full/pictures/ballistic_limit.png ]
refuses "has no figure '3f'; it has: all, handovers, 2a, 2b, 2c, 3" plot full --figure 3f

run bare 'Output/Fields interval = none'
refuses 'has no fields' plot bare --strip
refuses 'has no fields' plot bare
plot bare --limit >said.txt
[ -s bare/pictures/ballistic_limit.png ]
