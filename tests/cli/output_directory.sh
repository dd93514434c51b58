# SPDX-License-Identifier: LGPL-2.1-or-later
# A directory that is not the output of a run is never written into, on one rank or two.
program=$1
source=$2

rm -rf mine
mkdir mine
echo precious >mine/notes.txt
for ranks in 1 2; do
  status=0
  "$program" run "$source/prm/whipple_shield.prm" -n $ranks --output mine 2>err.txt >out.txt || status=$?
  [ "$status" -eq 2 ] || { echo "status $status, not 2"; cat err.txt; exit 1; }
  [ "$(wc -l <err.txt)" -eq 1 ] || { echo 'not one line:'; cat err.txt; exit 1; }
done
[ "$(ls mine)" = notes.txt ] || { ls mine; exit 1; }

# Two runs into one directory: the second gets one line that names the first, and touches nothing. What a killed run held
# is free again.
slow() {
  exec "$program" run "$source/prm/whipple_shield.prm" --output shared --set 'Output/Fields interval = none' >slow.txt 2>&1
}
rm -rf shared
slow &
first=$!
for _ in $(seq 600); do [ -s shared/parameters.prm ] && break; sleep 0.1; done
cp shared/parameters.prm before.prm
for verb in "run $source/prm/verification/sod.prm --output shared" 'run --resume shared'; do
  status=0
  # shellcheck disable=SC2086
  "$program" $verb 2>err.txt >out.txt || status=$?
  [ "$status" -eq 2 ] && [ "$(wc -l <err.txt)" -eq 1 ] && grep -q "in use by another run or study (process $first on" err.txt ||
    { kill -9 $first; echo "status $status"; cat err.txt; exit 1; }
done
cmp before.prm shared/parameters.prm
kill -9 $first
wait $first || true
"$program" run "$source/prm/verification/sod.prm" --output shared --overwrite >out.txt
grep -q '"status": "completed"' shared/summary.json
