# SPDX-License-Identifier: LGPL-2.1-or-later
# A small run on two ranks leaves what doc/output.md promises, and running it again replaces it.
program=$1
source=$2

rm -rf output
for attempt in first second; do
  "$program" run "$source/prm/verification/sod.prm" -n 2 --set 'Output/Fields interval = 0.1 us' >out.txt
  for file in log.txt parameters.prm statistics.csv summary.json fields.xdmf fields/fields-00000.h5; do
    [ -s "output/sod/$file" ] || { echo "no $file after the $attempt run"; ls output/sod; exit 1; }
  done
done
grep -q '"status": "completed"' output/sod/summary.json
grep -q '^time \[us\],' output/sod/statistics.csv || { head -n 1 output/sod/statistics.csv; exit 1; }
# the parameters in force are a scene that reads back
"$program" run output/sod/parameters.prm --validate
