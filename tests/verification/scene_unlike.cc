// SPDX-License-Identifier: LGPL-2.1-or-later
// Several materials: unlike ones in a planar impact against the impedance match, and like ones as one or as two.
#include "../figure.h"
#include "scene_run.h"

#include <ostream>
#include <variant>

namespace
{
  using namespace whipple;
  using figure::expect_at_most;
  using figure::expect_relative;
  using verification::run;

  struct Pair
  {
    const char              *name;
    std::vector<std::string> striker;            ///< what makes it, beside its library entry
    double                   pressure, velocity; ///< behind both shocks on aluminium 2024 at 6 km/s, Mbar, cm/us
  };

  void
  PrintTo(const Pair &pair, std::ostream *text)
  {
    *text << pair.name;
  }

  /// Root of rho0 (c0 + s u) u of both materials, worked out on its own; nylon: its curved Hugoniot.
  const Pair copper{"copper", {"Materials/striker/Library = copper OFHC"}, 1.20520867, 0.40345186},
      steel{"steel", {"Materials/striker/Library = stainless steel 304"}, 1.19085189, 0.40024629},
      tantalum{"tantalum", {"Materials/striker/Library = tantalum"}, 1.38822495, 0.44291468};

  class SceneUnlike : public testing::TestWithParam<std::tuple<Pair, const char *>>
  {
  };

  TEST_P(SceneUnlike, ImpedanceMatchWithoutSpikes)
  {
    const auto &[pair, mode] = GetParam();
    double spike             = 0;
    // the contact is at different places in its cell
    for (const double end : {0.42, 0.46, 0.5, 0.54})
      {
        std::vector<std::string> overrides = pair.striker;
        overrides.push_back(std::string("Stages/impact/Mode = ") + mode);
        overrides.push_back("Stages/impact/End = " + std::to_string(end) + " us");
        overrides.push_back("Output/Fields interval = none");
        const auto simulation =
            run("verification/unlike_impact.prm", overrides, std::string("unlike_") + pair.name + "_" + mode);
        const FlatMesh<2> &mesh    = simulation->domain().view->mesh;
        const State<2>    &state   = simulation->domain().state;
        const Derived     &derived = simulation->domain().derived;
        double             mass = 0, momentum = 0, volume = 0, load = 0;
        for (Index c = 0; c < mesh.n_owned; ++c)
          {
            double z = 0, v = 0;
            for (int k = 0; k < 4; ++k)
              {
                z += 0.25 * state.position[1][mesh.cell_node[4 * c + k]];
                v += 0.25 * state.velocity[1][mesh.cell_node[4 * c + k]];
              }
            // well behind both shocks
            if (std::abs(z - pair.velocity * end) > 0.1)
              continue;
            for (std::size_t i = 0; i < state.material.size(); ++i)
              if (const MaterialState &m = state.material[i]; m.mass[c] > 0)
                {
                  const double pressure = derived.material[i].pressure[c];
                  spike                 = std::max(spike, std::abs(pressure / pair.pressure - 1.));
                  mass += m.mass[c];
                  momentum += m.mass[c] * v;
                  volume += m.volume[c];
                  load += m.volume[c] * pressure;
                }
          }
        if (end < 0.5)
          continue;
        const std::string what =
            std::string(pair.name) + " on aluminium, " + mode + ", " + std::to_string(end).substr(0, 4) + " us: ";
        expect_relative(what + "pressure, Mbar", load / volume, pair.pressure, 0.01);
        expect_relative(what + "velocity, cm/us", momentum / mass, pair.velocity, 0.01);
      }
    expect_at_most(std::string(pair.name) + " on aluminium, " + mode +
                       ": largest departure of any pressure within 1 mm of the "
                       "contact, relative",
                   spike, 0.05);
  }
  INSTANTIATE_TEST_SUITE_P(Pairs, SceneUnlike,
                           testing::Combine(testing::Values(copper, steel, tantalum),
                                            testing::Values("eulerian", "lagrangian")),
                           [](const auto &info) {
                             return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param);
                           });

  /// Perforation of the published case with sphere and bumper of one material or of two with the same constants.
  std::map<std::string, double>
  perforation(bool two, const std::string &cell)
  {
    std::vector<std::string> overrides{"Mesh/Finest cell = " + cell, "Stages/List = perforation, debris",
                                       "Stages/debris/End = for 0.01 us", "Output/Fields interval = none"};
    if (two)
      for (const char *more :
           {"Materials/List = aluminium, aluminium b", "Bodies/bumper/Material = aluminium b",
            "Materials/aluminium b/Library = aluminium 2024-T4", "Materials/aluminium b/Strength = perfectly plastic",
            "Materials/aluminium b/Yield stress = 345 MPa", "Materials/aluminium b/Void law = rate",
            "Materials/aluminium b/Alpha = 1e5 us/cm^2", "Materials/aluminium b/Spall strength = 1.2 GPa"})
        overrides.push_back(more);
    const auto  simulation = run("whipple_shield.prm", overrides, two ? "like_two" : "like_one");
    const auto &results    = simulation->summary().results;
    return {{"hole, cm", std::get<double>(results.at("bumper").at("hole_diameter_cm"))},
            {"front velocity, cm/us",
             std::get<double>(results.at("debris").at("handover_leading_edge_velocity_cm_per_us"))}};
  }

  TEST(SceneLikeMaterials, OneOrTwoAreTheSame)
  {
    for (const std::string cell : {"0.016 cm", "0.008 cm"})
      {
        const auto one = perforation(false, cell), two = perforation(true, cell);
        for (const auto &[what, value] : one)
          expect_relative("published case with two materials instead of one, cells of " + cell + ": " + what,
                          two.at(what), value, 0.01);
      }
  }
} // namespace
