# SPDX-License-Identifier: LGPL-2.1-or-later
# A small run on two ranks leaves what doc/output.md promises. Run again it goes beside the first, or in its place.
program=$1
source=$2

sod() {
  "$program" run "$source/prm/verification/sod.prm" -n 2 --set 'Output/Fields interval = 0.1 us' "$@" >out.txt
  for file in log.txt parameters.prm statistics.csv summary.json fields.xdmf fields/fields-00000.h5 manifest.txt; do
    [ -s "$folder/$file" ] || { echo "no $file in $folder: $*"; ls "$folder"; exit 1; }
  done
}
folder=output/sod
sod
cp output/sod/log.txt first_log.txt
echo mine >output/sod/fields/mine.txt
folder=output/sod-2
sod
grep -q "^'output/sod' holds an earlier run, which stays; this one goes to 'output/sod-2' (--overwrite: replace it)$" out.txt
cmp first_log.txt output/sod/log.txt
folder=output/sod
sod --overwrite
! cmp -s first_log.txt output/sod/log.txt
[ "$(cat output/sod/fields/mine.txt)" = mine ]
[ ! -e output/sod-3 ]
# what mpirun has started by itself replaces nothing either
status=0
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mpirun -n 1 "$program" run "$source/prm/verification/sod.prm" >out.txt 2>err.txt || status=$?
grep -q '^whipple: .*holds an earlier run; give another directory, or --overwrite' err.txt || { cat err.txt; exit 1; }
grep -q '"status": "completed"' output/sod/summary.json
grep -q '^time \[us\],' output/sod/statistics.csv || { head -n 1 output/sod/statistics.csv; exit 1; }
# the parameters in force are a scene that reads back
"$program" run output/sod/parameters.prm --validate
# a shield ends with what became of each plate and gap, in the order of the flight, in the log as well
"$program" run "$source/prm/whipple_shield.prm" --output output/shield --set 'Mesh/Finest cell = 0.064 cm' \
  --set 'Mesh/Levels = 2' --set 'Stages/perforation/End = 0.8 us' --set 'Stages/wall/End = for 0.1 us' \
  --set 'Output/Fields interval = none' >said.txt
sed -n '/^results:/,$p' output/shield/log.txt >results.txt
sed -n '2,4s/^  \([a-z]*\): .*/\1/p' results.txt >places.txt
printf 'bumper\ndebris\nwall\n' | cmp - places.txt
grep -q '^completed in .* on 1 rank' results.txt
tail -n 1 said.txt | grep -q '^output in output/shield'
# ... and leaves them against time: the last line before the end of a stage is close to what that stage ended with
/usr/bin/python3 - output/shield <<'P'
import csv, json, sys
results = json.load(open(sys.argv[1] + "/summary.json"))["results"]
rows = list(csv.DictReader(open(sys.argv[1] + "/history.csv")))
times = [float(row["time_us"]) for row in rows]
assert times == sorted(times) and len(rows) > 8, times
last = [row for row in rows if row["stage"] == "1"][-1]
assert float(last["bumper crater_depth_cm"]) > 0 and last["debris mass_g"] == "nan", last
for place, quantity, stage in (("bumper", "hole_diameter_cm", "1"), ("debris", "mass_g", "2")):
    found = float([row for row in rows if row["stage"] == stage][-1][f"{place} {quantity}"])
    assert abs(found - results[place][quantity]) <= 0.1 * abs(results[place][quantity]), (found, results[place][quantity])
P
