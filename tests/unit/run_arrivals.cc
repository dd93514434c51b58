// SPDX-License-Identifier: LGPL-2.1-or-later
// Debris that waits is laid down when it comes to what is on the mesh, not before, and each landing closes.
#include "../flying_element.h"

#include <whipple/error.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/arrivals.h>
#include <whipple/run/handover.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace
{
  using namespace whipple;

  /// A plate at z = 0.5 cm, on which a cloud of rubble will fly.
  Problem<2>
  plate(const std::string &symmetry)
  {
    const std::string path = testing::TempDir() + "whipple_arrivals.prm";
    std::ofstream(path)
        << "subsection Geometry\n set Symmetry = " << symmetry
        << "\n set Lower corner = 0 cm, -0.6 cm\n set Upper corner = 0.8 cm, 1 cm\n set Left = reflecting\n"
           " set Right = transmitting\n set Bottom = transmitting\n set Top = transmitting\nend\n"
           "subsection Mesh\n set Finest cell = 0.0125 cm\n set Levels = 2\nend\n"
           "subsection Materials\n set List = al\n subsection al\n set Library = aluminium 2024-T4\n"
           " set Void law = rate\n set Alpha = 1e5 us/cm^2\n set Spall strength = 1.2 GPa\n end\nend\n"
           "subsection Effects\n set List = voids\nend\n"
           "subsection Bodies\n set List = plate\n"
           " subsection plate\n set Shape = plate\n set Front face = 0.5 cm\n"
           " set Thickness = 0.1 cm\n set Material = al\n end\nend\n"
           "subsection Stages\n set List = blow\n"
           " subsection blow\n set Mode = eulerian\n set End = 1 us\n end\nend\n";
    const Problem<2> problem = read_problem<2>(path);
    std::remove(path.c_str());
    return problem;
  }

  /// A square of edge 0.02 cm in flight.
  Element<2>
  square(const CellPacketLayout<2> &layout, Symmetry symmetry, double r, double z, double phi, double velocity,
         double radial = 0.)
  {
    return flying_rectangle(layout, symmetry, {{r, z}}, {{0.02, 0.02}}, 2.77, 0.002, phi, {{radial, velocity}});
  }

  struct Case
  {
    Problem<2>    problem;
    Regridding<2> regridding{problem.scene, problem.layout};
    Handover<2>   handover{problem, regridding};
    Domain<2>     domain{Forest<2>(MPI_COMM_SELF, problem.scene.lattice), nullptr, {}};
    Ledger<2>     ledger;

    explicit Case(const std::string &symmetry)
      : problem(plate(symmetry))
    {
      SharedDebris<2> none;
      handover.enter(problem.scene.stages[0], nullptr, domain, ledger, none);
      evaluate();
    }

    void
    evaluate()
    {
      LagrangeStep<2> step(domain.view->mesh, problem.layout.materials, problem.scene.boundaries,
                           problem.scene.numerics.hydro);
      step.update_node_mass(domain.state);
      step.evaluate(domain.state, domain.derived);
    }

    CellPacketLayout<2>
    layout() const
    {
      return CellPacketLayout<2>::of(domain.state);
    }
    Symmetry
    symmetry() const
    {
      return problem.scene.lattice.symmetry;
    }

    SharedDebris<2>
    waiting(std::vector<Element<2>> elements) const
    {
      WaitingDebris<2> result;
      result.parts = begin_to_wait(layout(), {}, std::move(elements), {}, 0.);
      for (const Waiting<2> &part : result.parts)
        {
          result.totals += totals_of(layout(), part.element);
          result.fastest = std::max(result.fastest, std::abs(part.element.packet[layout().velocity(1, 0)]));
        }
      return std::make_shared<const WaitingDebris<2>>(result);
    }

    ConservedTotals<2>
    held() const
    {
      return totals(domain.view->mesh, domain.state, MPI_COMM_SELF);
    }
  };

  std::vector<std::uint8_t>
  arrivals(const Case &of, const std::vector<Element<2>> &elements)
  {
    const Scene<2> &scene = of.problem.scene;
    RigidWalls<2>   walls;
    walls.there[0] = true; // at r = 0
    return find_arrivals(scene, of.layout(), *of.waiting(elements), walls, of.domain.view->mesh, of.domain.state,
                         MPI_COMM_SELF);
  }

  /// The plate's face is at 0.5 cm, met 4 cells (0.05 cm) before it, seen 1.5 times 16 cells (0.3 cm) ahead. The
  /// fastest flies 0.3 cm in 0.5 us. What is farther, slower, or flies off waits; what is close but does not come does,
  /// too.
  TEST(Arrivals, AreWhatComesToThePlate)
  {
    const Case of("planar");
    const auto element = [&](double r, double z, double velocity, double radial = 0.) {
      return square(of.layout(), of.symmetry(), r, z, 0.9, velocity, radial);
    };
    const std::vector<Element<2>>   elements{element(0.3, 0.14, 0.6),         // front at 0.16: 0.34 to go, 0.35 seen
                                           element(0.3, 0.11, 0.6),         // front at 0.13: 0.37 to go
                                           element(0.5, 0.14, 0.3),         // too slow as yet
                                           element(0.1, 0.46, -0.1),        // at the plate, but it flies off
                                           element(0.75, 0.46, 0.1),        // at the plate
                                           element(0.6, -0.4, 0.02, 0.),    // still far, alone
                                           element(0.01, -0.4, 0.02, -0.1), // meets the wall at r = 0
                                           element(0.2, -0.59, 0.02),       // touches no side yet
                                           element(0.2, -0.63, -0.02)};     // has left
    const std::vector<std::uint8_t> expected{1, 0, 0, 0, 1, 0, 1, 0, 1};
    EXPECT_EQ(arrivals(of, elements), expected);
  }

  /// Two that run into one another land; one behind the other at the same speed, or a slower one behind, do not. Of a
  /// piece all parts land if one does.
  TEST(Arrivals, AreWhatMeetsAmongWhatWaits)
  {
    const Case of("planar");
    const auto element = [&](double z, double velocity, long piece = -1) {
      Element<2> e = square(of.layout(), of.symmetry(), 0.4, z, 0.9, velocity);
      e.piece      = piece;
      return e;
    };
    const std::vector<std::uint8_t> all{1, 1}, none{0, 0};
    EXPECT_EQ(arrivals(of, {element(-0.5, 0.5), element(-0.45, 0.4)}), all);
    EXPECT_EQ(arrivals(of, {element(-0.5, 0.5), element(-0.48, 0.5)}), none);
    EXPECT_EQ(arrivals(of, {element(-0.5, 0.4), element(-0.48, 0.5)}), none);
    EXPECT_EQ(arrivals(of, {element(0.15, 0.5, 7), element(-0.5, 0.5, 7)}), all);
    EXPECT_EQ(arrivals(of, {element(0.15, 0.5, 7), element(-0.5, 0.5, 8)}), (std::vector<std::uint8_t>{1, 0}));
  }

  /// A batch on top of what is there, part of it inside the plate where nothing more fits: what was on the way is in
  /// the domain then, to the last digits, and no cell holds more solid than it is large.
  TEST(Arrivals, LandOnTopOfWhatIsThereAndClose)
  {
    for (const std::string symmetry : {"planar", "axisymmetric"})
      {
        Case                    of(symmetry);
        const auto              layout = of.layout();
        std::vector<Element<2>> elements;
        for (int i = 0; i < 20; ++i)
          for (int j = 0; j < 4; ++j)
            {
              // the first row lies half in the plate, dense; a last row is far
              const double z = j == 3 ? -0.5 : 0.49 - 0.02 * j;
              elements.push_back(square(layout, of.symmetry(), 0.02 * i, z, j == 0 ? 0.1 : 0.8, 0.5 + 0.01 * j));
            }
        auto         waiting = of.waiting(elements);
        const auto   before  = of.held();
        const double all     = before.mass + waiting->totals.mass;
        ASSERT_TRUE(of.handover.land_arrivals(of.problem.scene.stages[0], of.domain, of.ledger, waiting));
        ASSERT_TRUE(waiting);
        EXPECT_EQ(waiting->parts.size(), 20u);
        const auto after = of.held();
        EXPECT_NEAR(after.mass + waiting->totals.mass, all, 1e-12 * all);
        const double momentum = before.momentum[1] + of.waiting(elements)->totals.momentum[1];
        EXPECT_NEAR(after.momentum[1] + waiting->totals.momentum[1], momentum, 1e-12 * momentum);
        const double energy = before.total_energy() + of.waiting(elements)->totals.total_energy();
        EXPECT_NEAR(after.total_energy() + waiting->totals.total_energy(), energy, 1e-12 * energy) << symmetry;
        EXPECT_GT(of.ledger.bookings().of("projection").converted.value_or(0.), 0.); // it met the plate inelastically
        const FlatMesh<2>   &mesh = of.domain.view->mesh;
        const MaterialState &al   = of.domain.state.material[0];
        for (Index c = 0; c < mesh.n_owned; ++c)
          {
            EXPECT_GE(al.mass[c], 0.);
            EXPECT_LE((1. - al.void_fraction[c]) * al.volume[c], of.domain.state.volume[c] * (1. + 1e-9));
            EXPECT_TRUE(al.mass[c] == 0. || al.density[c] > 0.);
          }
        // nothing has come since: nothing happens
        of.evaluate();
        EXPECT_FALSE(of.handover.land_arrivals(of.problem.scene.stages[0], of.domain, of.ledger, waiting));
      }
  }

  /// What will come is what flies at the plate within the domain and is fast enough.
  TEST(Arrivals, OfWhatWillComeTheMomentumCounts)
  {
    const Case of("planar");
    const auto layout = of.layout();
    const auto come   = [&](double r, double z, double velocity, double radial, double least) {
      const auto waiting = of.waiting({square(layout, of.symmetry(), r, z, 0.9, velocity, radial)});
      return momentum_that_comes(of.problem.scene, layout, *waiting, 0., 0.5, least) / waiting->totals.momentum[1];
    };
    EXPECT_NEAR(come(0.4, -0.5, 0.5, 0., 0.1), 1., 1e-12);
    EXPECT_EQ(come(0.4, -0.5, 0.5, 0., 0.6), 0.);  // too slow
    EXPECT_EQ(come(0.4, -0.5, 0.5, 0.3, 0.1), 0.); // flies out at the side: 0.6 cm of 0.4
    EXPECT_EQ(come(0.4, 0.7, 0.5, 0., 0.1), 0.);   // beyond the plate
    EXPECT_EQ(come(0.4, -0.5, -0.5, 0., 0.1), 0.);
  }

  TEST(Arrivals, AStageWithoutElementsBeforeItHasNone)
  {
    const auto stage = [](const std::string &list, const std::string &name, const std::string &entries) {
      return list.find(name) == std::string::npos
                 ? std::string()
                 : " subsection " + name + '\n' + entries + " set End = for 1 us\n end\n";
    };
    const auto read = [&](const std::string &list) {
      const std::string path = testing::TempDir() + "whipple_arrivals_refused.prm";
      std::ofstream(path)
          << "subsection Geometry\n set Lower corner = 0 cm, 0 cm\n set Upper corner = 0.8 cm, 0.8 cm\nend\n"
             "subsection Mesh\n set Finest cell = 0.1 cm\nend\n"
             "subsection Materials\n set List = al\n subsection al\n set Library = aluminium 2024-T4\n"
             " set Void law = rate\n set Alpha = 1e5 us/cm^2\n set Spall strength = 1.2 GPa\n end\nend\n"
             "subsection Effects\n set List = voids\nend\n"
             "subsection Bodies\n set List = block\n subsection block\n set Shape = box\n"
             " set Lower corner = 0.2 cm, 0.2 cm\n set Upper corner = 0.4 cm, 0.4 cm\n"
             " set Velocity = 0 km/s, 1 km/s\n set Material = al\n end\nend\n"
             "subsection Stages\n set List = "
          << list << '\n'
          << stage(list, "a", " set Mode = eulerian\n") << stage(list, "b", " set Mode = lagrangian\n")
          << stage(list, "c", " set Mode = eulerian\n set Hand-over = as it arrives\n")
          << stage(list, "d", " set Mode = lagrangian\n set Hand-over = as it arrives\n") << "end\n";
      const auto problem = read_problem<2>(path);
      std::remove(path.c_str());
      return problem.scene.stages.back().landing;
    };
    EXPECT_EQ(read("a, b, c"), Landing::as_it_arrives);
    for (const char *list : {"c", "a, c", "a, d", "a, b, d"})
      try
        {
          read(list);
          ADD_FAILURE() << list;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find("Hand-over"), std::string::npos) << error.what();
          EXPECT_NE(std::string(error.what()).find("at once"), std::string::npos) << error.what();
        }
  }
} // namespace
