# SPDX-License-Identifier: LGPL-2.1-or-later
# Rooms include only rooms that stand before them, every source is built, and the script that says so notices what is not so.
source=$2
check() { /usr/bin/python3 "$source/scripts/check_rooms.py" "$@"; }

check "$source"

rm -rf wrong
mkdir -p wrong/include/whipple/mesh wrong/source/mesh
echo '    source/mesh/listed.cc' >wrong/source/sources.cmake
echo '#include <whipple/run/simulation.h>' >wrong/include/whipple/mesh/looks_up.h
echo '#include <whipple/mesh/looks_up.h>' >wrong/source/mesh/listed.cc
mkdir -p wrong/include/whipple/scene wrong/include/whipple/projection
echo '#include <whipple/material/material.h>' >wrong/include/whipple/scene/knows_models.h
echo '#include <whipple/material/material_request.h>' >wrong/include/whipple/scene/is_plain.h
echo '#include <whipple/state/fields.h>' >wrong/include/whipple/projection/projection_parameters.h
cp wrong/source/mesh/listed.cc wrong/source/mesh/forgotten.cc
status=0
check "$PWD/wrong" >out.txt || status=$?
[ "$status" -eq 1 ] || { echo "status $status, not 1"; exit 1; }
grep -q 'looks_up.h:1: mesh includes run' out.txt || { cat out.txt; exit 1; }
grep -q 'forgotten.cc: is not in' out.txt || { cat out.txt; exit 1; }
grep -q 'knows_models.h:1: scene includes material/material.h' out.txt || { cat out.txt; exit 1; }
grep -q 'projection_parameters.h:1: a header of plain data includes' out.txt || { cat out.txt; exit 1; }
[ "$(wc -l <out.txt)" -eq 4 ] || { cat out.txt; exit 1; }
