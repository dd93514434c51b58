# SPDX-License-Identifier: LGPL-2.1-or-later
# A study runs its points, goes on where it was killed, keeps out of directories that are not its own, tells what went
# wrong with a point, and is plotted.
program=$1
source=$2
. "$source/tests/cli/common/refuses.sh"

# study FILE AXIS...: the first microseconds of the shield on coarse cells, and one more axis
study() {
  cat >"$1" <<END_OF_STUDY
subsection Study
  set Scene     = $source/prm/whipple_shield.prm
  set Overrides = Stages/List = perforation | Stages/perforation/End = 0.1 us | Output/Fields interval = none
  set Axes      = cell, other
  subsection cell
    set Parameter = Mesh/Finest cell
    set Values    = 0.064 cm | 0.032 cm
  end
  subsection other
    set Parameter = $2
    set Values    = $3
  end
end
END_OF_STUDY
}

# rejects WORDS ARGUMENTS...: one line that holds WORDS, status 2
rejects() {
  words=$1
  shift
  refuses "$words" "$program" study "$@"
}

# A study of which two points stop says which, in one line, and ends as they did.
stops() {
  status=0
  "$program" study failing.prm "$@" >out.txt 2>err.txt || status=$?
  [ "$status" -eq 3 ] && [ "$(wc -l <err.txt)" -eq 1 ] &&
    grep -q '^whipple: stopped: 2 of 4 points of the study did not complete, cell=0.064cm,other=3: ' err.txt ||
    { echo "status $status"; cat err.txt; exit 1; }
}

rm -rf ./*.prm output mine
study failing.prm 'Numerics/Inject failure at step' 'none | 3'
study misspelt.prm 'Numerics/Remap ordr' '2 | 1'
study wrong.prm 'Numerics/Remap order' '2 | 3'

# what is wrong is said before anything is written
rejects "misspelt.prm:11: Numerics/Remap ordr = '2': no such key; did you mean 'Remap order'" misspelt.prm
rejects "wrong.prm:11: Numerics/Remap order = '3'" wrong.prm
rejects 'allowed are bumper crater depth' failing.prm --tolerance 'bumper crater deepness = 2 %'
rejects "--budget = 'soon'" failing.prm --tolerance 'bumper hole diameter = 2 %' --budget soon
rejects 'has no section Study' "$source/prm/whipple_shield.prm"
mkdir mine
echo precious >mine/notes.txt
rejects 'not the output of a study' failing.prm --output mine
[ "$(ls mine)" = notes.txt ] || { ls mine; exit 1; }
[ ! -e output ] || { echo 'something was written'; exit 1; }

# killed once the first point is there
"$program" study failing.prm >killed.txt &
while [ ! -e output/failing/points/cell=0.064cm,other=none/summary.json ]; do sleep 0.1; done
kill -9 $!
wait $! || true
rm -f 'output/failing/points/cell=0.032cm,other=3/summary.json'

# goes on with the rest; a point that stops is a row with its reason
stops
grep -q 'of 4 points are there already' out.txt || { cat out.txt; exit 1; }
grep -q 'stopped: ' out.txt || { cat out.txt; exit 1; }
for file in study.md study.csv study.json; do
  [ -s "output/failing/$file" ] || { echo "no $file"; exit 1; }
done
[ "$(wc -l <output/failing/study.csv)" -eq 5 ] || { cat output/failing/study.csv; exit 1; }
[ "$(grep -c ',stopped,' output/failing/study.csv)" -eq 2 ] || { cat output/failing/study.csv; exit 1; }
[ "$(grep -c ',completed,' output/failing/study.csv)" -eq 2 ] || { cat output/failing/study.csv; exit 1; }
grep -q 'bumper hole diameter' output/failing/study.md || { cat output/failing/study.md; exit 1; }
grep -q '## Points without a result' output/failing/study.md || { cat output/failing/study.md; exit 1; }

# a third time nothing is run; what has changed since is run anew, and only that
stops
grep -q '4 of 4 points are there already' out.txt || { cat out.txt; exit 1; }
! grep -q 'done in' out.txt || { cat out.txt; exit 1; }
stops --set 'Numerics/Courant number = 0.4'
! grep -q 'there already' out.txt || { cat out.txt; exit 1; }

# a point that is killed is no success either
study killed.prm 'Numerics/Remap order' '2 | 1'
"$program" study killed.prm --set 'Stages/perforation/End = 40 us' >out.txt 2>err.txt &
study=$!
for _ in $(seq 600); do
  point=$(pgrep -P $study | head -n 1) && [ -n "$point" ] && break
  sleep 0.05
done
kill -9 "$point"
status=0
wait $study || status=$?
[ "$status" -eq 1 ] && grep -q 'points of the study did not complete, .*signal 9' err.txt || { echo "status $status"; cat err.txt; exit 1; }

# another study keeps out
study other.prm 'Numerics/Remap order' '2 | 1'
cp output/failing/study.csv before.csv
rejects 'belongs to another study' other.prm --output output/failing
cmp -s output/failing/study.csv before.csv || { echo 'overwritten'; exit 1; }

/usr/bin/python3 "$source/scripts/plot_study.py" output/failing >plots.txt
for plot in work_precision convergence cost; do
  for kind in png svg; do
    [ -s "output/failing/$plot.$kind" ] || { echo "no $plot.$kind"; ls output/failing; exit 1; }
  done
done
