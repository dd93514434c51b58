# SPDX-License-Identifier: LGPL-2.1-or-later
# --validate accepts every scene that comes with Whipple, on one rank and two, and writes nothing.
program=$1
source=$2

for scene in "$source"/prm/*.prm "$source"/prm/*/*.prm; do
  "$program" run "$scene" --validate
done
"$program" run "$source/prm/whipple_shield.prm" --validate -n 2
[ ! -e output ] || { echo 'something was written'; exit 1; }
