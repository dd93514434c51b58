# SPDX-License-Identifier: LGPL-2.1-or-later
# A run that stops at its wall time limit goes on and ends like one that did not stop; what cannot go on says why in one line.
program=$1
source=$2
. "$source/tests/cli/common/refuses.sh"
scene=$source/prm/whipple_shield.prm

run() { "$program" run "$@" >out.txt 2>err.txt; }

# rejects WORDS ARGUMENTS...: one line that holds WORDS, status 2
rejects() {
  words=$1
  shift
  refuses "$words" "$program" run "$@"
}

rm -rf whole stopped other cut
set -- --set 'Mesh/Finest cell = 0.064 cm' --set 'Output/Fields interval = 2 us'
run "$scene" "$@" --output whole

# a limit that is over at once: nothing but the first state
status=0
run "$scene" "$@" --set 'Output/Wall time limit = 1 us' --output stopped || status=$?
[ "$status" -eq 3 ] || { echo "status $status, not 3"; cat err.txt; exit 1; }
grep -q '"resumable": true' stopped/summary.json || { cat stopped/summary.json; exit 1; }
grep -q "whipple run --resume 'stopped'" err.txt || { cat err.txt; exit 1; }

rejects 'is no directory of a run' --resume nowhere
rejects 'takes no scene file beside it' "$scene" --resume stopped
rejects 'takes no --output' --resume stopped --output other
rejects "Numerics/Courant number = '0.3': was '0.5'" --resume stopped --set 'Numerics/Courant number = 0.3'
rejects "Stages/perforation/End = '1 us'" --resume stopped --set 'Stages/perforation/End = 1 us'
rejects 'Bodies/sphere/Velosity' --resume stopped --set 'Bodies/sphere/Velosity = 1 km/s'
[ "$(ls stopped/checkpoints)" = 000000 ] || { ls stopped/checkpoints; exit 1; }

run --resume stopped --set 'Output/Wall time limit = none' -n 2
grep -q '"status": "completed"' stopped/summary.json || { cat stopped/summary.json; exit 1; }
sums() { sed -n '/"datasets"/,/}/p' "$1/checkpoints/$(ls "$1/checkpoints" | tail -n 1)/contents.json"; }
[ "$(sums whole)" = "$(sums stopped)" ] || { sums whole; sums stopped; exit 1; }
[ "$(ls whole/fields)" = "$(ls stopped/fields)" ] || { ls whole/fields stopped/fields; exit 1; }
[ "$(cut -d, -f1-9 whole/statistics.csv | cksum)" = "$(cut -d, -f1-9 stopped/statistics.csv | cksum)" ] || exit 1

# a table that lost rows: all ranks say so together
cp -r whole cut
: >cut/statistics.csv
rejects 'cut/statistics.csv: is shorter than the' --resume cut -n 2
! grep 'alone' err.txt || exit 1

# what is over stays as it is
rm -rf whole/checkpoints
rejects 'has no checkpoint, and its run is over' --resume whole
