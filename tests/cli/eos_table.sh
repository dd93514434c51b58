# SPDX-License-Identifier: LGPL-2.1-or-later
# The converter of equation of state tables: SESAME and ANEOS texts of one law become the same file, what is wrong with a text is
# one line, and a scene takes the file.
program=$1
source=$2
convert() { /usr/bin/python3 "$source/scripts/convert_eos_table.py" "$@"; }

rm -rf ./*.txt ./*.h5 output
cat >texts.py <<'END_OF_PYTHON'
# P = (k - 1) rho c T - P_inf, e = c T + P_inf / rho: at rest at 2.7 g/cm^3 and 300 K; GPa, MJ/kg
k, infinity, rest, cold = 4., 20., 2.7, 300.
heat = infinity / ((k - 1.) * rest * cold)
density = [0., 1.] + [2. + 0.05 * i for i in range(41)]
temperature = [100. * 1.2 ** i for i in range(20)]
pressure = [(k - 1.) * rho * heat * t - infinity if rho else 0. for t in temperature for rho in density]
energy = [heat * t + infinity / rho if rho else 0. for t in temperature for rho in density]
total = [len(density), len(temperature)] + density + temperature + pressure + energy
free_energy = [0.] * len(energy)
normal = [13., 27., 2.71, 60., 0.]


def record(values, columns, flags):
    for i in range(0, len(values), 5):
        line = values[i:i + 5]
        yield "".join(f"{value:{columns}.8E}" for value in line) + (flags and "".join("1" for _ in line)) + "\n"


with open("sesame.txt", "w") as text:
    for material in (9998, 9999):
        for flag, kind, values in ((0, 101, None), (1, 201, normal), (1, 301, total)):
            count = 100 if values is None else len(values)
            text.write(f"{flag:2d}{material:6d}{kind:6d}{count:6d}   r   101070   101070   1\n")
            text.writelines(["a comment of two lines\n", "by hand\n"] if values is None else record(values, 15, "1"))
    text.write(" 2\n")
with open("aneos.txt", "w") as text:
    text.write(" INDEX     MATID =   9999   NWDS =        9\n")
    text.writelines(record([9999., 1., 1., 1., 2., 201., 301., 5., len(total + free_energy)], 16, ""))
    for kind, values in ((201, normal), (301, total + free_energy)):
        text.write(f" RECORD     TYPE =  {kind}     NWDS = {len(values):8d}\n")
        text.writelines(record(values, 16, ""))
END_OF_PYTHON
/usr/bin/python3 texts.py

convert sesame.txt sesame.h5 --material 9999 --temperature 300 >sesame_log.txt
convert aneos.txt aneos.h5 --temperature 300 >aneos_log.txt
/usr/bin/python3 - <<'END_OF_PYTHON'
import h5py
import numpy

with h5py.File("sesame.h5") as sesame, h5py.File("aneos.h5") as aneos:
    for file in (sesame, aneos):
        rho, t = file["density"][:][:, None], file["temperature"][:][None, :]
        assert rho.shape == (42, 1) and t.shape == (1, 20), (rho.shape, t.shape)
        heat = 20. / (3. * 2.7 * 300.)
        assert numpy.allclose(file["pressure"], 3. * rho * heat * t - 20., rtol=1e-7, atol=1e-6)
        assert numpy.allclose(file["energy"], heat * t + 20. / rho, rtol=1e-7)
        assert {name: data.attrs["units"] for name, data in file.items()} == {
            "density": "g/cm^3", "temperature": "K", "pressure": "GPa", "energy": "MJ/kg"}
        # the text has no row at 300 K: between 298.6 and 358.3 K this law is linear
        assert abs(file.attrs["reference_density"] - 2.7) < 1e-6, file.attrs["reference_density"]
        assert abs(file.attrs["reference_energy"] - (heat * 300. + 20. / 2.7)) < 1e-5
    assert all(numpy.array_equal(sesame[name], aneos[name]) for name in sesame)
END_OF_PYTHON

# rejects WORDS ARGUMENTS...: one line that holds WORDS, and no file
rejects() {
  words=$1
  shift
  status=0
  convert "$@" >out.txt 2>err.txt || status=$?
  [ "$status" -eq 1 ] || { echo "status $status, not 1: $*"; cat err.txt; exit 1; }
  [ "$(wc -l <err.txt)" -eq 1 ] || { echo "not one line: $*"; cat err.txt; exit 1; }
  grep -qF -- "$words" err.txt || { echo "'$words' is not in:"; cat err.txt; exit 1; }
  [ ! -e bad.h5 ] || { echo "written despite wrong input: $*"; exit 1; }
}
rejects 'choose with --material' sesame.txt bad.h5
rejects '--material 1: must be one' sesame.txt bad.h5 --material 1
rejects '--temperature 10.0: must be in 100' aneos.txt bad.h5 --temperature 10
rejects '--density 30.0: must be in 1' aneos.txt bad.h5 --density 30
rejects 'No such file' none.txt bad.h5
sed 's/2\.00000000E+01/2.0000x000E+01/' aneos.txt >misprint.txt
rejects 'must be numbers of 16 columns' misprint.txt bad.h5
head -n 100 aneos.txt >short.txt
rejects 'the file ends after' short.txt bad.h5
: >empty.txt
rejects 'the file is empty' empty.txt bad.h5

# a scene takes the table, and not one with a hole
scene() {
  sed -e 's/Equation of state *= mie-grueneisen/Equation of state = tabulated/' -e "/Grueneisen coef/s/.*/    set Table = $1/" \
    -e '/Density\|Sound speed\|Hugoniot slope\|Strength\|Shear modulus\|Yield stress/d' \
    -e 's/elastic-plastic piston/gas piston/' -e '/set List = strength/d' "$source/prm/verification/copper_piston.prm"
}
scene sesame.h5 >scene.prm
"$program" run scene.prm --validate >out.txt
/usr/bin/python3 - <<'END_OF_PYTHON'
import shutil

import h5py

shutil.copy("sesame.h5", "hole.h5")
with h5py.File("hole.h5", "r+") as file:
    file["pressure"][3, 4] = float("nan")
END_OF_PYTHON
scene hole.h5 >scene.prm
status=0
"$program" run scene.prm --validate >out.txt 2>err.txt || status=$?
[ "$status" -eq 2 ] || { echo "status $status, not 2"; cat err.txt; exit 1; }
grep -qF 'pressure[3, 4]' err.txt || { echo 'no word of the hole in:'; cat err.txt; exit 1; }

# Maxwell's construction: the pressure of a vapour up to 2.7 g/cm^3 at 300 K, steep from there. Rows of energies that are level
# and fall a little, a pressure that falls with T: the program takes it, at rest on the steep branch without pressure
cat >plateau.py <<'END_OF_PYTHON'
import texts

stiff, heat = 60., 9e-4  # GPa, MJ/(kg K)
density = [0., 0.3, 1., 1.6, 2.2, 2.5, 2.65, 2.75, 2.9, 3.1, 3.4, 3.8, 4.3, 5.]
temperature = [100., 150., 200., 250., 290., 310., 350., 500., 800., 1500., 3000., 6000., 12000.]


def pressure(rho, t):
    steep = stiff * ((rho / 2.7) ** 2 - 1.) + 6e-3 * rho * (t - 300.)
    vapour = 1e-9 * t + (max(t - 1500., 0.) * 1e-4 * rho)
    return max(steep, vapour) if rho else 0.


def energy(rho, t):
    cold = stiff / 2.7 ** 2 * (rho + 2.7 ** 2 / rho - 2. * 2.7) if rho > 2.7 else 0.
    return cold + heat * t if rho else 0.


pressures = [pressure(rho, t) for t in temperature for rho in density]
energies = [energy(rho, t) for t in temperature for rho in density]
n = len(density)
energies[1 * n + 4] = energies[4]  # level
energies[2 * n + 9] = energies[9] - 1e-3  # falls
pressures[8 * n + 9] -= 4.  # as a solid that shrinks when it melts
total = [n, len(temperature)] + density + temperature + pressures + energies
with open("plateau.txt", "w") as text:
    for kind, values in ((201, texts.normal), (301, total)):
        text.write(f" 1{9999:6d}{kind:6d}{len(values):6d}   r   101070   101070   1\n")
        text.writelines(texts.record(values, 15, "1"))
END_OF_PYTHON
/usr/bin/python3 plateau.py
convert plateau.txt plateau.h5 --temperature 300 >plateau_log.txt
grep -qF '2 of 210 energies do not rise along the temperature' plateau_log.txt || { cat plateau_log.txt; exit 1; }
/usr/bin/python3 - <<'END_OF_PYTHON'
import h5py

with h5py.File("plateau.h5") as file:
    rest = file.attrs["reference_density"]
    # the steep branch is a parabola, which the polynomial through its points meets
    assert abs(rest - 2.7 * (1. + 1e-4 / 60.) ** 0.5) < 1e-5, rest
    assert file["density"].shape == (15,) and abs(file["density"][7] - rest) < 1e-12, file["density"][:]
END_OF_PYTHON
scene plateau.h5 >scene.prm
"$program" run scene.prm --validate --set 'Exact solution/Name = none' >out.txt

# What is no such table is one line and status 2, and never waited for
/usr/bin/python3 - <<'END_OF_PYTHON'
import shutil

import h5py
import numpy


def spoilt(name, change):
    shutil.copy("sesame.h5", name)
    with h5py.File(name, "r+") as file:
        change(file)


def replace(file, **keywords):
    del file["pressure"]
    file.create_dataset("pressure", **keywords).attrs["units"] = "GPa"


spoilt("bad_words.h5", lambda file: replace(file, data=numpy.full((42, 20), b"high")))
spoilt("bad_cube.h5", lambda file: replace(file, data=numpy.zeros((42, 20, 3))))
spoilt("bad_none.h5", lambda file: replace(file, shape=(0, 20), dtype="f8"))
spoilt("bad_huge.h5", lambda file: replace(file, shape=(10 ** 9, 10 ** 9), dtype="f8", chunks=(100, 100)))


def group(file):
    del file["pressure"]
    file.create_group("pressure")


def units(file):
    file["pressure"].attrs["units"] = numpy.array([b"GPa"] * 1000)


spoilt("bad_group.h5", group)
spoilt("bad_units.h5", units)
with open("sesame.h5", "rb") as whole, open("bad_half.h5", "wb") as half:
    half.write(whole.read()[:9000])
END_OF_PYTHON
echo 'no table' >bad_text.h5
mkdir -p bad_folder.h5
[ -e bad_pipe.h5 ] || mkfifo bad_pipe.h5
while read -r table words; do
  scene "$table" >scene.prm
  status=0
  "$program" run scene.prm --validate >out.txt 2>err.txt || status=$?
  [ "$status" -eq 2 ] || { echo "$table: status $status, not 2"; cat err.txt; exit 1; }
  [ "$(wc -l <err.txt)" -eq 1 ] || { echo "$table: not one line"; cat err.txt; exit 1; }
  grep -qF -- "$table: $words" err.txt || { echo "'$table: $words' is not in:"; cat err.txt; exit 1; }
done <<'END_OF_LIST'
bad_words.h5 dataset 'pressure' must hold numbers
bad_cube.h5 dataset 'pressure' must be an array of one or two indices
bad_none.h5 dataset 'pressure' has an extent of 0
bad_huge.h5 dataset 'pressure' has an extent of 1000000000
bad_group.h5 dataset 'pressure' is missing
bad_units.h5 dataset 'pressure' has no attribute 'units'
bad_half.h5 cannot be read as HDF5
bad_text.h5 cannot be read as HDF5
bad_folder.h5 is no regular file
bad_pipe.h5 is no regular file
END_OF_LIST
