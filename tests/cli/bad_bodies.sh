# SPDX-License-Identifier: LGPL-2.1-or-later
# Shapes and expressions that cannot be: one line that names the key and what is allowed, exit status 2, nothing written.
# And those that can: what is in force reads back to the same scene.
program=$1
cone=$2/tests/verification/scenes/turned_cone.prm
oblique=$2/prm/oblique_impact.prm

# rejects WORDS SCENE SETTINGS...: the message holds WORDS
rejects() {
  words=$1
  scene=$2
  shift 2
  for setting; do
    set -- "$@" --set "$setting"
    shift
  done
  status=0
  "$program" run "$scene" --validate "$@" >out.txt 2>err.txt || status=$?
  [ "$status" -eq 2 ] || { echo "status $status, not 2: $*"; cat err.txt; exit 1; }
  [ "$(wc -l <err.txt)" -eq 1 ] || { echo "not one line: $*"; cat err.txt; exit 1; }
  grep -qF -- "$words" err.txt || { echo "'$words' is not in:"; cat err.txt; exit 1; }
  [ ! -s out.txt ] || { echo "output despite wrong input: $*"; exit 1; }
}

# Shapes
rejects "unknown 'wedge'; allowed are box, cone, cylinder, plate, polygon, sphere" "$cone" 'Bodies/cone/Shape = wedge'
rejects 'belongs to the shape cylinder, sphere, not to a cone' "$cone" 'Bodies/cone/Diameter = 1 mm'
rejects 'Bodies/cone/Length' "$cone" 'Bodies/cone/Length ='
rejects 'a cone stands on the axis' "$cone" 'Bodies/cone/Base center = 1 mm, 0 mm'
rejects 'or 0 cm for a tip' "$cone" 'Bodies/cone/Top diameter = -1 mm'
rejects 'allowed are 0 deg and 180 deg' "$cone" 'Bodies/cone/Rotation = 30 deg'
rejects 'about a point on the axis' "$cone" 'Bodies/cone/Rotation center = 1 mm, 0 mm'
rejects "'rad'" "$cone" 'Bodies/cone/Rotation = 3.14 rad'
rejects 'the unit is missing; allowed is a angle' "$cone" 'Bodies/cone/Rotation = 180'
rejects 'Bodies/cone/Base center' "$cone" 'Bodies/cone/Rotation center = 0 mm, 5 mm'
rejects 'not both and not neither' "$cone" 'Bodies/ring/Corners = 1 mm, 0 mm; 2 mm, 0 mm; 2 mm, 1 mm'
rejects 'not both and not neither' "$cone" 'Bodies/ring/Corners file ='
rejects 'at least 3 corners' "$cone" 'Bodies/ring/Corners file =' 'Bodies/ring/Corners = 1 mm, 0 mm; 2 mm, 0 mm'
rejects 'edges 1 and 3 cross or touch' "$cone" 'Bodies/ring/Corners file =' \
  'Bodies/ring/Corners = 1 mm, 0 mm; 2 mm, 1 mm; 2 mm, 0 mm; 1 mm, 1 mm'
rejects 'a corner has r = -0.1 cm' "$cone" 'Bodies/ring/Corners file =' \
  'Bodies/ring/Corners = -1 mm, 0 mm; 2 mm, 0 mm; 2 mm, 1 mm'
rejects 'the unit is missing' "$cone" 'Bodies/ring/Corners file =' 'Bodies/ring/Corners = 1, 0; 2, 0; 2, 1'
rejects "no_such_corners.txt' cannot be read" "$cone" 'Bodies/ring/Corners file = no_such_corners.txt'
rejects 'cannot be read; allowed are two columns' "$cone" 'Bodies/ring/Corners file = /dev/zero'
printf '1 2\n3 4\n5 6\n' >unitless.txt
rejects "line 1 of '$PWD/unitless.txt'" "$cone" "Bodies/ring/Corners file = $PWD/unitless.txt"
printf 'mm mm\n1 2\n3 4 5\n' >three.txt
rejects "line 3 of '$PWD/three.txt': 3 columns" "$cone" "Bodies/ring/Corners file = $PWD/three.txt"
printf 'mm mm\n1 2\n3 x\n' >letter.txt
rejects "line 3 of '$PWD/letter.txt': not a number" "$cone" "Bodies/ring/Corners file = $PWD/letter.txt"
awk 'BEGIN { print "mm mm"; for (i = 0; i < 60; ++i) print 3 + cos(i * 0.1047), 9 + sin(i * 0.1047) }' >round.txt
rejects "...': the body reaches over 0.8" "$cone" "Bodies/ring/Corners file = $PWD/round.txt"
rejects "overlaps the body 'rod'" "$oblique" 'Bodies/plate/Front face = -0.3 cm'
rejects 'allowed is the domain' "$oblique" 'Bodies/rod/Length = 2 cm'
rejects 'out of range; allowed is -360 deg to 360 deg' "$oblique" 'Bodies/rod/Rotation = 1000 deg'

# Expressions
velocity='Bodies/cone/Velocity expression'
density='Bodies/ring/Density expression'
rejects 'Unexpected token "sn" found at position' "$cone" "$velocity = 0; sn(r)"
rejects 'an expression in r, z and pi' "$cone" "$velocity = 0; x"
rejects '1 expressions; allowed are 2' "$cone" "$velocity = 0"
rejects "components are separated by ';'" "$cone" "$velocity = 0, r; 1"
rejects 'another one on every rank' "$cone" "$velocity = 0; rand()"
rejects "a comparison is '=='" "$cone" "$velocity = 0; if(r = 1, 2, 3)"
rejects 'the body leaves the axis' "$cone" "$velocity = 1 - r; 1"
rejects 'the velocity along axis 1 is inf' "$cone" "$velocity = 0; 1/r"
rejects 'the density is -' "$cone" "$density = 2 - z"
rejects "Bodies/ring/Density expression = 'sqrt(2 - z)': the density is not a number" "$cone" "$density = sqrt(2 - z)"
rejects 'a value is too large' "$cone" "$velocity = 0; 1e9"
rejects 'must be given beside an expression' "$cone" 'Bodies/cone/Velocity unit ='
rejects "'GPa' is not a unit of velocity" "$cone" 'Bodies/cone/Velocity unit = GPa'
rejects 'Bodies/cone/Coordinate unit' "$cone" 'Bodies/cone/Coordinate unit ='
rejects 'needs a Specific energy expression' "$cone" 'Bodies/cone/Specific energy unit = kJ/kg'
rejects 'has a density expression; allowed is one of the two' "$cone" 'Bodies/ring/Density = 2.7 g/cm^3'
rejects 'has a velocity expression; allowed is one of the two' "$cone" 'Bodies/cone/Velocity = 0 km/s, 1 km/s'
rejects 'the exact solution gives it' "$cone" 'Exact solution/Name = translation' 'Bodies/cone/Initial state = exact'
[ ! -e output ] || { echo 'something was written'; exit 1; }

# What is in force reads back, without the file of corners beside it, to the same results.
"$program" run "$cone" --output first >/dev/null 2>&1
"$program" run first/parameters.prm --output second >/dev/null 2>&1
cmp first/statistics.csv second/statistics.csv || { echo 'parameters.prm does not read back to the same run'; exit 1; }
