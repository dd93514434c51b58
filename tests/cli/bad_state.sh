# SPDX-License-Identifier: LGPL-2.1-or-later
# A state that goes bad in the middle of a run: one line on standard error, exit status 3, the last good state and
# the summary on disk, in both modes, on one rank and two.
program=$1
source=$2

for mode in eulerian lagrangian; do
  for ranks in 1 2; do
    output=out_${mode}_$ranks
    status=0
    "$program" run "$source/prm/verification/sod.prm" -n $ranks --output "$output" \
      --set "Stages/tube/Mode = $mode" --set 'Numerics/Inject failure at step = 5' >out.txt 2>err.txt || status=$?
    [ "$status" -eq 3 ] || { echo "status $status, not 3 ($mode, $ranks ranks)"; cat err.txt; exit 1; }
    [ "$(wc -l <err.txt)" -eq 1 ] || { echo 'not one line:'; cat err.txt; exit 1; }
    grep -q '"status": "stopped"' "$output/summary.json" || { cat "$output/summary.json"; exit 1; }
    grep -q '"name": "tube"' "$output/summary.json" || { echo 'the stage that stopped is not in the summary'; exit 1; }
    [ -s "$output/last_good_state/README.txt" ] || { echo 'no last good state'; exit 1; }
    [ "$(ls "$output"/last_good_state/*.h5 | wc -l)" -eq $ranks ] || { ls "$output/last_good_state"; exit 1; }
  done
done
