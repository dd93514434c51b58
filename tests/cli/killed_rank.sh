# SPDX-License-Identifier: LGPL-2.1-or-later
# A rank that is killed ends the run with one line that says by what, and how to go on.
program=$1
source=$2
command -v pgrep >/dev/null || exit 77

rm -rf output
"$program" run "$source/prm/whipple_shield.prm" --output output -n 2 --set 'Mesh/Finest cell = 0.016 cm' \
  --set 'Output/Fields interval = none' --set 'Output/Checkpoint interval = 1 s' >out.txt 2>err.txt &
run=$!
for _ in $(seq 600); do
  [ -z "$(ls output/checkpoints 2>/dev/null)" ] || break
  sleep 0.1
done
kill -9 "$(pgrep -P "$(pgrep -P $run)" | tail -n 1)"
status=0
wait $run || status=$?
[ "$status" -eq 137 ] || { echo "status $status, not 137"; cat err.txt; exit 1; }
grep -q '^whipple: a rank was ended by signal 9 (.*), and with it the run; go on from its last checkpoint with: whipple run --resume output$' err.txt ||
  { cat err.txt; exit 1; }
"$program" run --resume output --set 'Stages/wall/End = for 0.01 us' >out.txt
grep -q '"status": "completed"' output/summary.json
