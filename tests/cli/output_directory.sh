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
