// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies painted with an exact solution, and the errors and the shock measured against one.
#include <whipple/diagnostics/exact_errors.h>
#include <whipple/diagnostics/shock_measure.h>
#include <whipple/exact/profile.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/run/handover.h>
#include <whipple/scene/body_volume.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <numbers>

namespace
{
  using namespace whipple;

  constexpr double exponent = 1.4;

  /// A gas that fills [0, 1] x [0, 1] cm and takes the scene's exact solution.
  std::string
  scene_text(const std::string &symmetry, const std::string &state, const std::string &more = "")
  {
    return "subsection Geometry\n set Symmetry = " + symmetry +
           "\n set Lower corner = 0 cm, 0 cm\n set Upper corner = 1 cm, 1 cm\nend\n"
           "subsection Materials\n set List = gas\n subsection gas\n set Equation of state = ideal gas\n"
           " set Density = 1 g/cm^3\n set Adiabatic exponent = 1.4\n end\nend\n"
           "subsection Bodies\n set List = gas\n subsection gas\n set Shape = box\n set Lower corner = 0 cm, 0 cm\n"
           " set Upper corner = 1 cm, 1 cm\n set Material = gas\n" +
           state +
           " end\nend\n"
           "subsection Stages\n set List = s\n subsection s\n set End = 1 us\n end\nend\n"
           "subsection Exact solution\n set Name = noh\nend\n" +
           more;
  }

  Problem<2>
  problem_of(const std::string &text, const std::vector<std::string> &overrides)
  {
    const std::string path = testing::TempDir() + "whipple_stage_exact.prm";
    std::ofstream(path) << text;
    const Problem<2> problem = read_problem<2>(path, overrides);
    std::remove(path.c_str());
    return problem;
  }

  std::vector<std::string>
  uniform_cells(const std::string &cell)
  {
    return {"Mesh/Finest cell = " + cell, "Mesh/Levels = 0", "Mesh/Refinement = uniform"};
  }

  /// The state at the start of a scene's first stage.
  struct Start
  {
    explicit Start(const Problem<2> &given)
      : problem(given)
      , regridding(scene, layout)
      , domain{Forest<2>(MPI_COMM_SELF, scene.lattice), nullptr, {}}
    {
      Ledger<2>       ledger;
      SharedDebris<2> waiting;
      Handover<2>(problem, regridding).enter(scene.stages[0], nullptr, domain, ledger, waiting);
      LagrangeStep<2>(domain.view->mesh, layout.materials, scene.boundaries, scene.numerics.hydro)
          .evaluate(domain.state, domain.derived);
    }

    std::map<std::string, summary::Error>
    errors(const exact::ExactSolution<2> &solution) const
    {
      return exact_errors<2>(solution, domain.view->mesh, domain.state, domain.derived, MPI_COMM_SELF);
    }

    Problem<2>         problem;
    const Scene<2>    &scene  = problem.scene;
    const FieldLayout &layout = problem.layout;
    Regridding<2>      regridding;
    Domain<2>          domain;
  };

  /// A smooth flow without symmetry, at rest normal to the sides x = 0 and y = 0; pressure of the gas.
  class Smooth : public exact::ExactSolution<2>
  {
  public:
    explicit Smooth(double shift = 0)
      : exact::ExactSolution<2>("smooth")
      , shift_(shift)
    {
    }
    exact::PointState<2>
    at(const Vector<2> &x, double) const override
    {
      const double density = 1. + 0.3 * std::sin(3. * x[0] + x[1]) + shift_, energy = 2. + std::cos(2. * x[1] - x[0]);
      return {density, (exponent - 1.) * density * energy, energy, {{std::sin(x[0]) + shift_, x[1] * std::cos(x[0])}}};
    }

  private:
    double shift_;
  };

  /// Density that jumps at a radius.
  class Step : public exact::Profile
  {
  public:
    explicit Step(double position)
      : position_(position)
    {
    }
    exact::ProfileState
    at(double coordinate, double) const override
    {
      return {coordinate < position_ ? 4. : 1., 0., 1., 1.};
    }
    std::vector<double>
    breaks(double) const override
    {
      return {position_};
    }
    std::optional<double>
    shock_position(double) const override
    {
      return position_;
    }

  private:
    double position_;
  };

  std::shared_ptr<const exact::ExactSolution<2>>
  step(double position, exact::Geometry geometry, Symmetry symmetry)
  {
    return std::make_shared<exact::ProfileSolution<2>>("step", std::make_unique<Step>(position), geometry, symmetry,
                                                       0.);
  }

  const std::string exact_state = " set Initial state = exact\n";
  const std::string unit_state  = " set Density = 1 g/cm^3\n set Pressure = 1 Mbar\n";

  TEST(StageExact, PaintedStateIsTheExactOne)
  {
    for (const std::string symmetry : {"planar", "axisymmetric"})
      {
        Problem<2> problem = problem_of(scene_text(symmetry, exact_state), uniform_cells("0.1 cm"));
        problem.exact      = std::make_shared<Smooth>();
        const auto errors  = Start(problem).errors(*problem.exact);
        for (const char *name : {"density", "energy", "pressure"})
          EXPECT_LT(*errors.at(name).linf, 1e-14) << symmetry << ' ' << name;
        EXPECT_EQ(*errors.at("velocity").linf, 0.) << symmetry;
      }
  }

  TEST(StageExact, NodesAreExactOnMeshesWithHangingNodes)
  {
    Problem<2> problem = problem_of(scene_text("planar", exact_state),
                                    {"Mesh/Finest cell = 0.025 cm", "Mesh/Levels = 2", "Mesh/Refinement = region",
                                     "Mesh/Region = 0 cm, 0 cm, 0.4 cm, 0.3 cm"});
    problem.exact      = std::make_shared<Smooth>();
    const Start        start(problem);
    const FlatMesh<2> &mesh  = start.domain.view->mesh;
    const State<2>    &state = start.domain.state;
    std::vector<bool>  hangs(mesh.n_nodes, false);
    ASSERT_GT(mesh.hanging.size(), 0u);
    for (const Index n : mesh.hanging)
      hangs[n] = true;
    for (Index n = 0; n < mesh.n_nodes; ++n)
      if (!hangs[n])
        {
          for (int d = 0; d < 2; ++d)
            EXPECT_NEAR(state.velocity[d][n],
                        problem.exact->at({{state.position[0][n], state.position[1][n]}}, 0.).velocity[d], 1e-12);
        }
    const auto errors = start.errors(*problem.exact);
    EXPECT_LT(*errors.at("density").linf, 1e-14);
    EXPECT_LT(*errors.at("energy").linf, 1e-12); // nothing has been heated
    EXPECT_GT(*errors.at("velocity").linf, 0.);  // the hanging nodes
  }

  TEST(StageExact, ShiftedStateHasTheErrorOfTheShift)
  {
    Problem<2> problem = problem_of(scene_text("axisymmetric", exact_state), uniform_cells("0.1 cm"));
    problem.exact      = std::make_shared<Smooth>();
    const auto errors  = Start(problem).errors(Smooth(0.125));
    for (const char *name : {"density", "velocity"})
      for (const auto &norm : {errors.at(name).l1, errors.at(name).l2, errors.at(name).linf})
        EXPECT_NEAR(*norm, 0.125, 1e-13) << name;
  }

  TEST(StageExact, JumpInsideCellsIsIntegrated)
  {
    const double position = 0.637;
    struct Case
    {
      std::string     symmetry;
      exact::Geometry geometry;
      double          share; // of the domain inside the jump
      double          tolerance;
    };
    for (const Case &c :
         {Case{"planar", exact::Geometry::planar, position, 1e-13},
          Case{"planar", exact::Geometry::cylindrical, std::numbers::pi / 4. * position * position, 1e-5},
          Case{"axisymmetric", exact::Geometry::cylindrical, position * position, 1e-13},
          Case{"axisymmetric", exact::Geometry::spherical, 2. / 3. * std::pow(position, 3), 1e-5}})
      {
        const Problem<2> problem = problem_of(scene_text(c.symmetry, unit_state), uniform_cells("0.1 cm"));
        const auto       errors  = Start(problem).errors(*step(position, c.geometry, problem.scene.lattice.symmetry));
        EXPECT_NEAR(*errors.at("density").l1, 3. * c.share, c.tolerance) << c.symmetry;
        EXPECT_NEAR(*errors.at("density").linf, 3., 1e-13);
      }
  }

  TEST(StageExact, ShockIsFoundOnAllRays)
  {
    for (const auto geometry : {exact::Geometry::planar, exact::Geometry::cylindrical, exact::Geometry::spherical})
      {
        Problem<2> problem = problem_of(scene_text("axisymmetric", exact_state), uniform_cells("0.02 cm"));
        problem.exact      = step(0.637, geometry, Symmetry::axisymmetric);
        const Start start(problem);
        const auto  shock = measure_shock<2>(start.problem, start.domain.view->mesh, start.domain.state, MPI_COMM_SELF);
        ASSERT_TRUE(shock && shock->mean && shock->spread);
        EXPECT_EQ(shock->exact, 0.637);
        EXPECT_NEAR(*shock->mean, 0.637, 0.01);
        EXPECT_LT(*shock->spread, geometry == exact::Geometry::spherical ? 0.02 : 1e-12);
      }
  }

  TEST(StageExact, SceneSaysWhatIsWrong)
  {
    const auto complaint = [](const std::string &state, const std::vector<std::string> &overrides) -> std::string {
      try
        {
          std::vector<std::string> all = uniform_cells("0.1 cm");
          all.insert(all.end(), overrides.begin(), overrides.end());
          problem_of(scene_text("planar", state), all);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    };
    EXPECT_EQ(complaint(exact_state, {}), "");
    EXPECT_NE(complaint(exact_state, {"Exact solution/Name = none"}).find("Bodies/gas/Initial state = 'exact': "),
              std::string::npos);
    EXPECT_NE(
        complaint(exact_state + unit_state, {}).find("Bodies/gas/Density = '1 g/cm^3': the initial state is exact"),
        std::string::npos);
    EXPECT_NE(complaint(unit_state, {"Exact solution/Name = magic"}).find("Exact solution/Name = 'magic': unknown"),
              std::string::npos);
    EXPECT_NE(complaint(unit_state, {"Exact solution/Infall velocity = 1"}).find("the unit is missing"),
              std::string::npos);
    EXPECT_NE(complaint(unit_state, {"Exact solution/Name = none", "Exact solution/Infall velocity = 1 cm/us"})
                  .find("Exact solution/Infall velocity = '1 cm/us': no exact solution is named"),
              std::string::npos);
    EXPECT_NE(complaint(unit_state, {"Exact solution/Geometry = spherical"})
                  .find("Exact solution/Name = 'noh': exact solution 'noh': a spherical profile needs"),
              std::string::npos);
  }

  TEST(StageExact, DefaultsOfAKindAreInTheEffectiveParameters)
  {
    const Problem<2> problem = problem_of(scene_text("planar", exact_state), uniform_cells("0.1 cm"));
    ASSERT_TRUE(problem.exact);
    EXPECT_EQ(problem.exact->name(), "noh");
    EXPECT_NE(problem.scene.effective_parameters.find("set Infall velocity"), std::string::npos);
    const Problem<2> again = problem_of(problem.scene.effective_parameters, {});
    EXPECT_EQ(again.scene.effective_parameters, problem.scene.effective_parameters);
  }
} // namespace
