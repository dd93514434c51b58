# SPDX-License-Identifier: LGPL-2.1-or-later
# Gauges that cannot be: one line that names the key and what is allowed, exit status 2. And those that can: nan where
# there is no material, the picture of each, and no folder where nobody has asked for gauges.
program=$1
source=$2
. "$source/tests/cli/common/refuses.sh"
scene=$source/prm/verification/aluminium_impact.prm

rejects() {
  words=$1
  shift
  refuses_settings "$words" "$scene" "$@"
}

rejects 'Gauges/a/Point' 'Gauges/List = a'
rejects 'outside the domain; allowed is along axis 1 -2.2 cm to 1.' 'Gauges/List = a' 'Gauges/a/Point = 0 cm, 2 cm'
rejects "did you mean 'pressure'? allowed are velocity, density, pressure, solid fraction" 'Gauges/List = a' \
  'Gauges/a/Point = 0 cm, 0 cm' 'Gauges/a/Fields = density, presure'
rejects "'density' is listed twice" 'Gauges/List = a' 'Gauges/a/Point = 0 cm, 0 cm' 'Gauges/a/Fields = density, density'
rejects 'allowed are fixed, material, surface velocity' 'Gauges/List = a' 'Gauges/a/Kind = moving'
rejects "unknown 'wall'; allowed are flyer, target" 'Gauges/List = a' 'Gauges/a/Kind = surface velocity' 'Gauges/a/Body = wall'
rejects "cannot be told from body 'flyer'" 'Gauges/List = a' 'Gauges/a/Kind = surface velocity' 'Gauges/a/Body = target'
rejects 'allowed are rear, front' 'Effects/List = body tags' 'Gauges/List = a' 'Gauges/a/Kind = surface velocity' \
  'Gauges/a/Body = target' 'Gauges/a/Side = left'
rejects 'belongs to a gauge of kind surface velocity' 'Gauges/List = a' 'Gauges/a/Point = 0 cm, 0 cm' 'Gauges/a/Body = target'
rejects 'belongs to a gauge of kind fixed or material' 'Effects/List = body tags' 'Gauges/List = a' \
  'Gauges/a/Kind = surface velocity' 'Gauges/a/Body = target' 'Gauges/a/Point = 0 cm, 0 cm'
rejects 'Gauges/a/Interval' 'Gauges/List = a' 'Gauges/a/Point = 0 cm, 0 cm' 'Gauges/a/Interval = -1 us'
rejects 'Gauges/b/Point' 'Gauges/List = a' 'Gauges/a/Point = 0 cm, 0 cm' 'Gauges/b/Point = 0 cm, 0 cm'
rejects 'listed twice' 'Gauges/List = a, a'

run() {
  directory=$1
  shift
  "$program" run "$scene" --output "$directory" --set 'Mesh/Finest cell = 0.04 cm' --set 'Stages/impact/End = 0.1 us' \
    "$@" >out.txt
}

run without
[ ! -e without/gauges ] || { echo 'a folder of gauges where there are none'; exit 1; }

run with --set 'Gauges/List = empty, rear side' --set 'Gauges/empty/Point = 0 cm, 1.5 cm' --set 'Effects/List = body tags' \
  --set 'Gauges/rear side/Kind = surface velocity' --set 'Gauges/rear side/Body = target'
head -n 1 with/gauges/empty.csv |
  grep -qxF 'time [us],position 0 [cm],position 1 [cm],density [g/cm^3],pressure [Mbar],velocity 0 [cm/us],velocity 1 [cm/us]'
tail -n 1 with/gauges/empty.csv | grep -q ',0,1.5,nan,nan,nan,nan$'
head -n 1 'with/gauges/rear side.csv' | grep -qxF 'time [us],position 1 [cm],velocity 1 [cm/us]'
grep -qE '^0,(1|0\.99999999999999.*|1\.00000000000000.*),0$' 'with/gauges/rear side.csv'
"$program" run with/parameters.prm --validate >/dev/null # what is in force reads back
if /usr/bin/python3 -c 'import matplotlib, h5py' 2>/dev/null; then
  /usr/bin/python3 "$source/scripts/plot_run.py" with >/dev/null
  [ -s 'with/pictures/gauge-rear side.png' ] && [ -s with/pictures/gauge-empty.png ]
fi
run with --overwrite
[ ! -e with/gauges ] || { echo 'gauges of an earlier run are left'; exit 1; }
