# SPDX-License-Identifier: LGPL-2.1-or-later
# --validate accepts every scene and every study that comes with Whipple, on one rank and two, and writes nothing.
program=$1
source=$2

for scene in "$source"/prm/*.prm "$source"/prm/verification/*.prm; do
  "$program" run "$scene" --validate
done
for study in "$source"/prm/studies/*.prm "$source"/prm/verification/*.prm; do
  ! grep -q '^subsection Study' "$study" || "$program" study "$study" --validate
done
"$program" run "$source/prm/whipple_shield.prm" --validate -n 2
[ ! -e output ] || { echo 'something was written'; exit 1; }
