// SPDX-License-Identifier: LGPL-2.1-or-later
// Size does not matter: nothing in the equations of a chain without rates has a length of its own, so a shield of a
// micrometre and one of ten metres are the same shield. Sizes that differ by a power of two differ in no bit.
#include "../figure.h"
#include "scene_run.h"

#include <whipple/ledger/totals.h>

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace
{
  using namespace whipple;

  std::string
  lengths(const std::vector<double> &values, double size, const std::string &unit)
  {
    std::ostringstream text;
    text << std::setprecision(17);
    for (std::size_t i = 0; i < values.size(); ++i)
      text << (i > 0 ? ", " : "") << values[i] * size << ' ' << unit;
    return text.str();
  }

  /// The shield, coarse and short, with all lengths and times multiplied by `size`; alpha is a time over an area at
  /// given velocities, so one over a length.
  std::unique_ptr<Simulation<2>>
  shield(double size, const std::string &folder)
  {
    const auto length = [size](std::vector<double> values) { return " = " + lengths(values, size, "cm"); };
    const auto time   = [size](double value) { return lengths({value}, size, "us"); };
    return verification::run("whipple_shield.prm",
                             {"Geometry/Lower corner" + length({0., -0.512}),
                              "Geometry/Upper corner" + length({1.024, 2.56}), "Mesh/Finest cell" + length({0.032}),
                              "Mesh/Levels = 2", "Materials/aluminium/Alpha = " + lengths({1e5}, 1. / size, "us/cm^2"),
                              "Bodies/sphere/Center" + length({0., -0.16}), "Bodies/sphere/Diameter" + length({0.32}),
                              "Bodies/bumper/Front face" + length({0.}), "Bodies/bumper/Thickness" + length({0.081}),
                              "Bodies/wall/Front face" + length({2.081}), "Bodies/wall/Thickness" + length({0.127}),
                              "Stages/perforation/End = " + time(1.5), "Stages/wall/End = for " + time(0.5),
                              "Output/Fields interval = none"},
                             folder);
  }

  /// Results without their dimension: over the size to the power that the name's unit gives.
  std::map<std::string, double>
  dimensionless(const Simulation<2> &simulation, double size)
  {
    std::map<std::string, double> result;
    for (const auto &[place, quantities] : simulation.summary().results)
      for (const auto &[name, value] : quantities)
        if (const double *number = std::get_if<double>(&value))
          {
            const auto ends            = [&](const char *unit) { return name.ends_with(unit); };
            const int  power           = ends("_g_cm_per_us") || ends("_g") || ends("_Mbar_cm3") ? 3
                                         : ends("_per_us")                                       ? 0
                                                           : ends("_cm") || ends("_us");
            result[place + ' ' + name] = *number / std::pow(size, power);
          }
    const auto present = totals(simulation.domain().view->mesh, simulation.domain().state, MPI_COMM_SELF);
    result["mass"]     = present.mass / std::pow(size, 3);
    result["energy"]   = present.total_energy() / std::pow(size, 3);
    return result;
  }
} // namespace

TEST(SceneScale, AMicrometreAndTenMetresAreTheSameShield)
{
  const auto reference = dimensionless(*shield(1., "scale_cm"), 1.);
  ASSERT_GT(reference.size(), 20u);
  EXPECT_GT(reference.at("bumper hole_diameter_cm"), 0.4);
  for (const auto &[size, folder] :
       {std::pair(0x1p-12, "scale_um"), std::pair(0x1p12, "scale_10_m")}) // spheres of 0.78 um and 13 m
    for (const auto &[name, value] : dimensionless(*shield(size, folder), size))
      EXPECT_EQ(value, reference.at(name)) << name << " at size " << size;
}
