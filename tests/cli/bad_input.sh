# SPDX-License-Identifier: LGPL-2.1-or-later
# What is wrong with the input is one line on standard error and exit status 2; nothing is computed or written.
program=$1
. "$2/tests/cli/common/refuses.sh"

# rejects WORDS ARGUMENTS...: the message holds WORDS
rejects() {
  words=$1
  shift
  refuses_quietly "$words" "$program" "$@"
}

rejects "unknown verb 'fly'" fly
rejects 'a verb of the launcher' test
rejects 'needs a scene file' run
rejects 'study needs a file' study
rejects 'a verb of the launcher' plot output
rejects 'no_such_study.prm' study no_such_study.prm
rejects "unknown option '--sett'" run scene.prm --sett 'A = b'
rejects "--set = 'Courant'" run scene.prm --set Courant
rejects "-n = '0'" run scene.prm -n 0
rejects "-n = 'two'" run scene.prm -n two
rejects 'two scene files' run one.prm two.prm
rejects 'needs a value' run scene.prm --output
rejects "no help on 'weather'" help weather
rejects 'no_such_scene.prm' run no_such_scene.prm --validate
rejects 'no_such_scene.prm' run no_such_scene.prm -n 2

# Models and effects: what is missing, what nothing reads, what contradicts.
shield=$2/prm/whipple_shield.prm
set_material='Materials/aluminium'
rejects 'Hardening modulus is needed' run "$shield" --set "$set_material/Strength = linear hardening"
rejects 'needs a thermal model' run "$shield" --set "$set_material/Conduction = constant conductivity"
rejects 'isothermal = true with heat conduction' run "$shield" --set "$set_material/Conduction = constant conductivity" \
  --set "$set_material/Thermal model = constant specific heat" --set "$set_material/Isothermal = true"
rejects 'set Materials/NAME/Thermal model' run "$shield" --set 'Effects/List = strength, voids, melting'
rejects "'failure' means nothing without 'voids'" run "$shield" --set 'Effects/List = strength, failure'
rejects "unknown 'everything'" run "$shield" --set 'Effects/List = everything'
rejects "Effects/heat conduction/Share of the stable step = '2': must be" run "$shield" \
  --set 'Effects/heat conduction/Share of the stable step = 2'
rejects 'Effects/fragment size/Void fraction' run "$shield" --set 'Effects/fragment size/Void fraction = 1 cm'
rejects 'no such key' run "$shield" --set 'Effects/fragment size/Size = 1 cm'
rejects 'no such section' run "$shield" --set 'Effects/strength/Size = 1 cm'
rejects 'no_such_table.h5' run "$shield" --set "$set_material/Equation of state = tabulated" \
  --set "$set_material/Table = no_such_table.h5"
rejects 'must be >= 0 or infinite' run "$shield" --set "$set_material/Spall strength = -1 GPa"

# What is no scene, or no text.
rejects 'is no file (a folder, pipe or device)' run . --validate
rejects 'is no file (a folder, pipe or device)' run /dev/zero --validate
rm -f pipe
mkfifo pipe
rejects 'is no file (a folder, pipe or device)' run pipe --validate
printf 'set Title = a bell \007 and a line\n' >control.prm
rejects 'control.prm:1: control character 0x07' run control.prm --validate
rejects 'control character 0x1b' run "$shield" --set "$(printf 'Title = \033[2J')"
printf '\357\273\277' | cat - "$shield" >marked.prm
"$program" run marked.prm --validate >out.txt 2>err.txt || { echo 'a byte order mark is not accepted'; cat err.txt; exit 1; }
rejects 'must be given; allowed are one or more names' run "$shield" --set 'Bodies/List ='

# Numbers that can be read and mean nothing.
rejects 'at most 1e+09 g/cm^3' run "$shield" --set 'Bodies/sphere/Density = 1e20 g/cm^3'
rejects 'at most 29979.2458 cm/us' run "$shield" --set 'Bodies/sphere/Velocity = 0 cm/us, 1e30 cm/us'
rejects 'too large; allowed is a specific energy' run "$shield" --set 'Bodies/sphere/Specific energy = 1e30 MJ/kg'
rejects 'a tension that no matter holds' run "$shield" --set 'Bodies/sphere/Pressure = -1000 GPa'
rejects 'a tension that no matter holds' run "$shield" --set 'Geometry/Top = pressure -1000 GPa'
rejects 'too large; allowed is a time' run "$shield" --set 'Stages/perforation/End = 1e300 s'
rejects 'too large; allowed is a pure number' run "$shield" --set "$set_material/Hugoniot slope = 1e30"
rejects 'and the finest cell 100000 cm; allowed is a body of at least 2e-06 cells' run "$shield" \
  --set 'Mesh/Finest cell = 1 km'
[ ! -e output ] || { echo 'something was written'; exit 1; }
