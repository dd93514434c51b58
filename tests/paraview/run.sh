# SPDX-License-Identifier: LGPL-2.1-or-later
# A short chain of three stages as ParaView sees it. 77: there is no ParaView.
program=$1
source=$2

command -v pvpython >/dev/null || exit 77
for ranks in 1 2; do
  "$program" run "$source/prm/whipple_shield.prm" --output run$ranks -n $ranks --set 'Mesh/Finest cell = 0.064 cm' \
    --set 'Mesh/Levels = 2' --set 'Stages/perforation/End = 0.8 us' --set 'Stages/wall/End = for 0.1 us' \
    --set 'Output/Fields interval = 2 us' --set 'Output/Formats = hdf5, vtu' >out.txt
  pvpython "$source/tests/paraview/times_in_paraview.py" run$ranks
done
