// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of straight edges fly through vacuum as they are, and a flow that starts from expressions runs as the one that
// starts from the exact solution.
#include "../connected_pieces.h"
#include "../figure.h"
#include "scene_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace
{
  using namespace whipple;
  using figure::expect_at_most;

  /// Volume of a body and sum |V - V exact| over the cells, the exact shape moved with the body.
  std::pair<double, double>
  shape_difference(const Simulation<2> &simulation, const Shape<2> &shape, const Vector<2> &way, double whole)
  {
    const FlatMesh<2> &mesh       = simulation.domain().view->mesh;
    const State<2>    &state      = simulation.domain().state;
    double             difference = 0, inside = 0;
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        const Vector<2> lower{{mesh.lower[0][c] - way[0], mesh.lower[1][c] - way[1]}};
        const Vector<2> upper{{lower[0] + mesh.size[c], lower[1] + mesh.size[c]}};
        const double    exact = shape->volume(mesh.symmetry, lower, upper);
        difference += std::abs(state.material[0].volume[c] - exact);
        inside += exact;
      }
    return {difference + whole - inside, whole};
  }

  /// Run the translation of a sphere with another body in its place and look at what has become of it.
  void
  expect_undisturbed(const std::string &body, const std::vector<std::string> &overrides, const Vector<2> &way,
                     double whole, double allowed_shape_error)
  {
    const std::string    file       = "verification/sphere_translation.prm";
    const auto           run        = verification::run(file, overrides, "translation of a " + body);
    const Simulation<2> &simulation = *run;
    const Shape<2>       shape = read_problem<2>(source_directory() + "/prm/" + file, overrides).scene.bodies[0].shape;
    const ConservedTotals<2> before = simulation.ledger().introduced();
    const ConservedTotals<2> after  = totals(simulation.domain().view->mesh, simulation.domain().state, MPI_COMM_SELF);
    expect_at_most(body + " in flight: mass against the formula, relative", before.mass / (2.785 * whole) - 1., 1e-13);
    expect_at_most(body + " in flight: mass, relative change", after.mass / before.mass - 1., 1e-13);
    expect_at_most(body + " in flight: axial momentum, relative change", after.momentum[1] / before.momentum[1] - 1.,
                   1e-12);
    EXPECT_EQ(simulation.ledger().left().mass, 0.);
    EXPECT_EQ(connected_pieces(simulation.domain().view->mesh, simulation.domain().state, 1e-6), 1);
    const auto [difference, volume] = shape_difference(simulation, shape, way, whole);
    expect_at_most(body + " in flight: shape error, sum of abs(V - V exact) / V", difference / volume,
                   allowed_shape_error);
  }

  // A blunt cone along the axis of r, z: four of its lengths, 48 cells across its base.
  TEST(SceneShapes, ConeInFlight)
  {
    const std::string body  = "Bodies/sphere/";
    const double      whole = std::numbers::pi / 3. * 0.4 * (0.24 * 0.24 + 0.24 * 0.08 + 0.08 * 0.08);
    expect_undisturbed("blunt cone",
                       {body + "Shape = cone", body + "Center =", body + "Diameter =",
                        body + "Base center = 0 cm, -0.2 cm", body + "Base diameter = 0.48 cm",
                        body + "Top diameter = 0.16 cm", body + "Length = 0.4 cm", "Stages/flight/End = 2.4 us"},
                       {{0., 2.4 * 0.658}}, whole, 0.01);
  }

  // An oblique plate that flies along its normal, ten of its thicknesses.
  TEST(SceneShapes, TurnedPlateInFlight)
  {
    const std::string body = "Bodies/sphere/";
    expect_undisturbed("turned plate",
                       {body + "Shape = plate", body + "Center =", body + "Diameter =", body + "Front face = -0.04 cm",
                        body + "Thickness = 0.08 cm", body + "Half width = 0.3 cm", body + "Rotation = 30 deg",
                        body + "Velocity = -1 km/s, 1.7320508075688772 km/s", "Geometry/Symmetry = planar",
                        "Geometry/Left = transmitting", "Geometry/Lower corner = -0.88 cm, -0.48 cm",
                        "Geometry/Upper corner = 0.48 cm, 1.28 cm", "Stages/flight/End = 4 us"},
                       {{-0.4, 0.69282032302755092}}, 0.08 * 0.6, 0.03);
  }

  // The vortex of the library and the same formulas as expressions, after a run.
  TEST(SceneShapes, AVortexInWordsTurnsAsTheOneOfTheLibrary)
  {
    const std::string body = "Bodies/gas/", cold = "(1 - 0.25*exp(1 - x^2 - y^2)/7)",
                      turn = "0.5*exp(0.5*(1 - x^2 - y^2))";
    std::vector<std::string> words{"Mesh/Finest cell = 0.25 cm"};
    const auto               library = verification::run("verification/isentropic_vortex.prm", words, "vortex_library");
    for (const std::string &entry :
         {std::string("Initial state = uniform"), std::string("Coordinate unit = cm"),
          "Density expression = " + cold + "^2.5", std::string("Density unit = g/cm^3"),
          "Specific energy expression = 2.5*" + cold, std::string("Specific energy unit = Mbar cm^3/g"),
          "Velocity expression = -y*" + turn + "; x*" + turn, std::string("Velocity unit = cm/us")})
      words.push_back(body + entry);
    const auto      spoken = verification::run("verification/isentropic_vortex.prm", words, "vortex_words");
    const State<2> &a = library->domain().state, &b = spoken->domain().state;
    ASSERT_EQ(a.material[0].mass.size(), b.material[0].mass.size());
    double largest = 0;
    for (std::size_t c = 0; c < a.material[0].mass.size(); ++c)
      largest = std::max({largest, std::abs(a.material[0].density[c] - b.material[0].density[c]),
                          std::abs(a.material[0].energy[c] - b.material[0].energy[c])});
    expect_at_most("vortex from expressions: density and energy against the library's, 1 us, largest difference",
                   largest, 1e-11);
  }
} // namespace
