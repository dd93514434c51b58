# SPDX-License-Identifier: LGPL-2.1-or-later
# Shapes and expressions that cannot be: one line that names the key and what is allowed, exit status 2, nothing written.
# And those that can: what is in force reads back to the same scene.
program=$1
. "$2/tests/cli/common/refuses.sh"
cone=$2/tests/verification/scenes/turned_cone.prm
oblique=$2/prm/oblique_impact.prm

# Shapes
refuses_settings "unknown 'wedge'; allowed are box, cone, cylinder, plate, polygon, sphere" "$cone" 'Bodies/cone/Shape = wedge'
refuses_settings 'belongs to the shape cylinder, sphere, not to a cone' "$cone" 'Bodies/cone/Diameter = 1 mm'
refuses_settings 'Bodies/cone/Length' "$cone" 'Bodies/cone/Length ='
refuses_settings 'a cone stands on the axis' "$cone" 'Bodies/cone/Base center = 1 mm, 0 mm'
refuses_settings 'or 0 cm for a tip' "$cone" 'Bodies/cone/Top diameter = -1 mm'
refuses_settings 'allowed are 0 deg and 180 deg' "$cone" 'Bodies/cone/Rotation = 30 deg'
refuses_settings 'about a point on the axis' "$cone" 'Bodies/cone/Rotation center = 1 mm, 0 mm'
refuses_settings "'rad'" "$cone" 'Bodies/cone/Rotation = 3.14 rad'
refuses_settings 'the unit is missing; allowed is a angle' "$cone" 'Bodies/cone/Rotation = 180'
refuses_settings 'Bodies/cone/Base center' "$cone" 'Bodies/cone/Rotation center = 0 mm, 5 mm'
refuses_settings 'not both and not neither' "$cone" 'Bodies/ring/Corners = 1 mm, 0 mm; 2 mm, 0 mm; 2 mm, 1 mm'
refuses_settings 'not both and not neither' "$cone" 'Bodies/ring/Corners file ='
refuses_settings 'at least 3 corners' "$cone" 'Bodies/ring/Corners file =' 'Bodies/ring/Corners = 1 mm, 0 mm; 2 mm, 0 mm'
refuses_settings 'edges 1 and 3 cross or touch' "$cone" 'Bodies/ring/Corners file =' \
  'Bodies/ring/Corners = 1 mm, 0 mm; 2 mm, 1 mm; 2 mm, 0 mm; 1 mm, 1 mm'
refuses_settings 'a corner has r = -0.1 cm' "$cone" 'Bodies/ring/Corners file =' \
  'Bodies/ring/Corners = -1 mm, 0 mm; 2 mm, 0 mm; 2 mm, 1 mm'
refuses_settings 'the unit is missing' "$cone" 'Bodies/ring/Corners file =' 'Bodies/ring/Corners = 1, 0; 2, 0; 2, 1'
refuses_settings "no_such_corners.txt' cannot be read" "$cone" 'Bodies/ring/Corners file = no_such_corners.txt'
refuses_settings 'cannot be read; allowed are two columns' "$cone" 'Bodies/ring/Corners file = /dev/zero'
printf '1 2\n3 4\n5 6\n' >unitless.txt
refuses_settings "line 1 of '$PWD/unitless.txt'" "$cone" "Bodies/ring/Corners file = $PWD/unitless.txt"
printf 'mm mm\n1 2\n3 4 5\n' >three.txt
refuses_settings "line 3 of '$PWD/three.txt': 3 columns" "$cone" "Bodies/ring/Corners file = $PWD/three.txt"
printf 'mm mm\n1 2\n3 x\n' >letter.txt
refuses_settings "line 3 of '$PWD/letter.txt': not a number" "$cone" "Bodies/ring/Corners file = $PWD/letter.txt"
awk 'BEGIN { print "mm mm"; for (i = 0; i < 60; ++i) print 3 + cos(i * 0.1047), 9 + sin(i * 0.1047) }' >round.txt
refuses_settings "...': the body reaches over 0.8" "$cone" "Bodies/ring/Corners file = $PWD/round.txt"
refuses_settings "overlaps the body 'rod'" "$oblique" 'Bodies/plate/Front face = -0.3 cm'
refuses_settings 'allowed is the domain' "$oblique" 'Bodies/rod/Length = 2 cm'
refuses_settings 'out of range; allowed is -360 deg to 360 deg' "$oblique" 'Bodies/rod/Rotation = 1000 deg'

# Expressions
velocity='Bodies/cone/Velocity expression'
density='Bodies/ring/Density expression'
refuses_settings 'Unexpected token "sn" found at position' "$cone" "$velocity = 0; sn(r)"
refuses_settings 'an expression in r, z and pi' "$cone" "$velocity = 0; x"
refuses_settings '1 expressions; allowed are 2' "$cone" "$velocity = 0"
refuses_settings "components are separated by ';'" "$cone" "$velocity = 0, r; 1"
refuses_settings 'another one on every rank' "$cone" "$velocity = 0; rand()"
refuses_settings "a comparison is '=='" "$cone" "$velocity = 0; if(r = 1, 2, 3)"
refuses_settings 'the body leaves the axis' "$cone" "$velocity = 1 - r; 1"
refuses_settings 'the velocity along axis 1 is inf' "$cone" "$velocity = 0; 1/r"
refuses_settings 'the density is -' "$cone" "$density = 2 - z"
refuses_settings "Bodies/ring/Density expression = 'sqrt(2 - z)': the density is not a number" "$cone" "$density = sqrt(2 - z)"
refuses_settings 'a value is too large' "$cone" "$velocity = 0; 1e9"
refuses_settings 'must be given beside an expression' "$cone" 'Bodies/cone/Velocity unit ='
refuses_settings "'GPa' is not a unit of velocity" "$cone" 'Bodies/cone/Velocity unit = GPa'
refuses_settings 'Bodies/cone/Coordinate unit' "$cone" 'Bodies/cone/Coordinate unit ='
refuses_settings 'needs a Specific energy expression' "$cone" 'Bodies/cone/Specific energy unit = kJ/kg'
refuses_settings 'has a density expression; allowed is one of the two' "$cone" 'Bodies/ring/Density = 2.7 g/cm^3'
refuses_settings 'has a velocity expression; allowed is one of the two' "$cone" 'Bodies/cone/Velocity = 0 km/s, 1 km/s'
refuses_settings 'the exact solution gives it' "$cone" 'Exact solution/Name = translation' 'Bodies/cone/Initial state = exact'
[ ! -e output ] || { echo 'something was written'; exit 1; }

# What is in force reads back, without the file of corners beside it, to the same results.
"$program" run "$cone" --output first >/dev/null 2>&1
"$program" run first/parameters.prm --output second >/dev/null 2>&1
cmp first/statistics.csv second/statistics.csv || { echo 'parameters.prm does not read back to the same run'; exit 1; }
