# SPDX-License-Identifier: LGPL-2.1-or-later
# scripts/same_bits.py: a run is the same as itself made again, and one bit, one digit or one file tells another one.
program=$1
source=$2
/usr/bin/python3 -c 'import h5py' 2>/dev/null || { echo 'needs python3-h5py'; exit 77; }
compare() { /usr/bin/python3 "$source/scripts/same_bits.py" "$@"; }
differs() { # differs WHAT: one/sod and two/sod, by that and nothing else
  if compare one two >found.txt; then echo "no difference: $1"; exit 1; fi
  grep -q "$1" found.txt || { cat found.txt; exit 1; }
  [ "$(wc -l <found.txt)" -eq 2 ] || { cat found.txt; exit 1; }
}

rm -rf one two whole
for directory in one two; do
  "$program" run "$source/prm/verification/sod.prm" --set 'Output/Fields interval = 0.1 us' --output "$directory/sod" >out.txt
done
compare one two
compare one/sod two/sod
cp -r two/sod whole

again() { rm -rf two/sod && cp -r whole two/sod; }
/usr/bin/python3 - two/sod/fields/fields-00001.h5 <<'END'
import h5py, sys
with h5py.File(sys.argv[1], "r+") as file:
    values = file["pressure"][...]
    values.view("i%d" % values.itemsize)[3] ^= 1
    file["pressure"][...] = values
END
differs 'fields/fields-00001.h5: pressure: 1 of'
again
sed '5s/,\([^,]*\)$/,\1 /' whole/statistics.csv >two/sod/statistics.csv
differs 'statistics.csv:5: set at axis 1'
again
rm two/sod/fields/fields-00002.h5
differs 'fields/fields-00002.h5: only before'
again
sed 's/"status": "completed"/"status": "stopped"/' whole/summary.json >two/sod/summary.json
differs 'summary.json/status: completed -> stopped'
again
rm -r two/sod
differs 'no such run after'

status=0
compare "$source/doc" one 2>out.txt || status=$?
[ "$status" -eq 2 ] || { echo "no run: exit status $status"; exit 1; }
