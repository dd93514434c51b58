// SPDX-License-Identifier: LGPL-2.1-or-later
#include "complaint.h"
#include "source_directory.h"

#include <whipple/error.h>
#include <whipple/exact/exact_factory.h>
#include <whipple/problem/problem.h>
#include <whipple/scene/plate_shape.h>
#include <whipple/scene/sphere_shape.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
  using namespace whipple;

  const std::string source = source_directory();
  const std::string shield = source + "/prm/whipple_shield.prm";

  /// The message a scene file with overrides is rejected with; empty if it is accepted.
  std::string
  complaint(const std::string &file, const std::vector<std::string> &overrides = {})
  {
    return complaint_of([&] { read_problem<2>(file, overrides); });
  }

  /// A scene file of the test's own, removed afterwards.
  class TemporaryScene
  {
  public:
    explicit TemporaryScene(const std::string &text)
      : path_(testing::TempDir() + "whipple_scene_" + testing::UnitTest::GetInstance()->current_test_info()->name() +
              ".prm")
    {
      std::ofstream(path_) << text;
    }
    ~TemporaryScene()
    {
      std::remove(path_.c_str());
    }
    const std::string &
    path() const
    {
      return path_;
    }

  private:
    std::string path_;
  };

  /// The shield's scene with one text in place of another.
  std::string
  edited_shield(const std::string &from, const std::string &to)
  {
    std::ifstream     input(shield);
    std::string       text{std::istreambuf_iterator<char>(input), {}};
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }

  TEST(SceneFile, WhippleShieldIsWhatItSays)
  {
    const Problem<2> problem = read_problem<2>(shield);
    const Scene<2>  &scene   = problem.scene;
    EXPECT_EQ(scene.lattice.symmetry, Symmetry::axisymmetric);
    EXPECT_EQ(scene.lattice.spacing, 0.004);
    EXPECT_EQ(scene.lattice.max_level, 5);
    EXPECT_EQ(scene.lattice.roots, (std::array<int, 2>{{32, 96}}));
    EXPECT_EQ(scene.lattice.origin, (Vector<2>{{0, -1.024}}));
    EXPECT_DOUBLE_EQ(scene.upper_corner()[0], 4.096);
    EXPECT_DOUBLE_EQ(scene.upper_corner()[1], 11.264);
    EXPECT_EQ(scene.boundaries[0].kind, BoundaryKind::reflecting);
    for (int side = 1; side < 4; ++side)
      EXPECT_EQ(scene.boundaries[side].kind, BoundaryKind::transmitting);
    EXPECT_EQ(scene.effects, (std::vector<std::string>{"body tags", "strength", "voids"}));

    ASSERT_EQ(scene.materials.size(), 1u);
    const SceneMaterial &aluminium = scene.materials[0];
    const Material      &model     = problem.materials[0].model;
    EXPECT_EQ(aluminium.name, "aluminium");
    EXPECT_DOUBLE_EQ(model.eos->reference_density(), 2.785);
    EXPECT_EQ(aluminium.request.constants.at("Yield stress"), 0.00345);
    EXPECT_EQ(aluminium.request.constants.at("Spall strength"), 0.012);
    EXPECT_EQ(aluminium.request.constants.at("Alpha"), 1e5);
    EXPECT_DOUBLE_EQ(aluminium.request.constants.at("Sound speed"), 0.5328);
    ASSERT_TRUE(model.strength);
    ASSERT_TRUE(model.void_law);
    EXPECT_EQ(model.void_law->name(), "rate");

    ASSERT_EQ(scene.bodies.size(), 3u);
    ASSERT_TRUE(scene.bodies[0].shape.as<Sphere<2>>());
    const auto &sphere = *scene.bodies[0].shape.as<Sphere<2>>();
    EXPECT_EQ(sphere.center, (Vector<2>{{0, -0.16}}));
    EXPECT_EQ(sphere.diameter, 0.32);
    EXPECT_EQ(scene.bodies[0].velocity, (Vector<2>{{0, 0.658}}));
    EXPECT_DOUBLE_EQ(scene.bodies[0].density, 2.785);
    EXPECT_EQ(scene.bodies[0].energy, 0.);
    const Box<2> bumper = extent(scene.bodies[1].shape), wall = extent(scene.bodies[2].shape);
    EXPECT_DOUBLE_EQ(bumper.upper[1] - bumper.lower[1], 0.081);
    EXPECT_DOUBLE_EQ(wall.lower[1] - bumper.upper[1], 10.16);
    EXPECT_EQ(scene.bodies[2].shape.as<Plate<2>>()->thickness, 0.127);

    ASSERT_EQ(scene.stages.size(), 3u);
    const Stage &perforation = scene.stages[0], &debris = scene.stages[1], &impact = scene.stages[2];
    EXPECT_EQ(perforation.mode(), StageMode::eulerian);
    EXPECT_EQ(perforation.introduces, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(perforation.end->fixed_time(), std::optional<double>(1.5));
    EXPECT_EQ(debris.mode(), StageMode::lagrangian);
    EXPECT_EQ(debris.lagrangian->cohesion, Cohesion::fragments);
    EXPECT_EQ(debris.lagrangian->breaking.damage, 0.5);
    EXPECT_EQ(debris.lagrangian->breaking.void_fraction, 0.15);
    EXPECT_EQ(debris.lagrangian->breaking.shape, 0.2);
    EXPECT_EQ(debris.lagrangian->debris.void_cutoff, 0.99);
    EXPECT_DOUBLE_EQ(debris.lagrangian->debris.minimum_axial_velocity, 0.0658);
    EXPECT_EQ(debris.lagrangian->debris.behind, std::optional<std::size_t>(1));
    EXPECT_EQ(debris.end->awaited_body(), std::optional<std::size_t>(2));
    EXPECT_FALSE(debris.end->is_known());
    EXPECT_TRUE(debris.introduces.empty());
    EXPECT_EQ(impact.introduces, (std::vector<std::size_t>{2}));
    EXPECT_FALSE(impact.end->fixed_time());
    EXPECT_EQ(impact.end->expected({1., 0., 0.}), 3.);
    EXPECT_EQ(scene.numerics.hydro.courant, 0.5);
    EXPECT_EQ(scene.output.fields_interval, std::optional<double>(0.5));
  }

  TEST(SceneFile, EveryShippedSceneIsValidAndReadsBackToItself)
  {
    int scenes = 0;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(source + "/prm"))
      if (entry.path().extension() == ".prm" && entry.path().parent_path().filename() != "studies")
        {
          const Scene<2>       scene = read_problem<2>(entry.path()).scene;
          const TemporaryScene copy("");
          write_effective_parameters(scene, copy.path());
          const Scene<2> again = read_problem<2>(copy.path()).scene;
          EXPECT_EQ(again.effective_parameters, scene.effective_parameters) << entry.path();
          EXPECT_EQ(again.lattice.roots, scene.lattice.roots);
          EXPECT_EQ(again.lattice.origin, scene.lattice.origin);
          ASSERT_EQ(again.bodies.size(), scene.bodies.size());
          for (std::size_t b = 0; b < scene.bodies.size(); ++b)
            {
              EXPECT_EQ(again.bodies[b].density, scene.bodies[b].density);
              EXPECT_EQ(again.bodies[b].energy, scene.bodies[b].energy);
              EXPECT_EQ(again.bodies[b].velocity, scene.bodies[b].velocity);
              EXPECT_EQ(extent(again.bodies[b].shape).lower, extent(scene.bodies[b].shape).lower);
              EXPECT_EQ(extent(again.bodies[b].shape).upper, extent(scene.bodies[b].shape).upper);
            }
          ASSERT_EQ(again.stages.size(), scene.stages.size());
          for (std::size_t s = 0; s < scene.stages.size(); ++s)
            {
              EXPECT_EQ(again.stages[s].introduces, scene.stages[s].introduces);
              ASSERT_EQ(again.stages[s].mode(), scene.stages[s].mode());
              if (const auto &moving = scene.stages[s].lagrangian)
                {
                  EXPECT_EQ(again.stages[s].lagrangian->debris.minimum_axial_velocity,
                            moving->debris.minimum_axial_velocity);
                }
            }
          ++scenes;
        }
    EXPECT_GE(scenes, 6);
  }

  bool
  is_exact_constant(const std::string &key)
  {
    for (const exact::ExactKind &kind : exact::exact_kinds<2>())
      for (const exact::ExactConstant &constant : kind.constants)
        if (constant.key == key)
          return true;
    return false;
  }

  bool
  is_model_constant(const std::string &key)
  {
    for (const ModelConstant &constant : all_model_constants())
      if (constant.key == key)
        return true;
    return false;
  }

  // The manual page has every key (as `Key`) and every section (as a heading).
  TEST(SceneFile, ManualNamesEveryKey)
  {
    std::ifstream      page(source + "/doc/scene_files.md");
    const std::string  manual{std::istreambuf_iterator<char>(page), {}};
    std::istringstream parameters(read_problem<2>(shield).scene.effective_parameters);
    int                depth = 0, keys = 0;
    for (std::string line; std::getline(parameters, line);)
      {
        std::istringstream words(line);
        std::string        word, rest;
        words >> word >> std::ws;
        std::getline(words, rest);
        if (word == "subsection" && ++depth == 1)
          {
            EXPECT_NE(manual.find("## " + rest + "\n"), std::string::npos) << rest;
          }
        if (word == "end")
          --depth;
        if (word != "set")
          continue;
        const std::string key = rest.substr(0, rest.find_last_not_of(' ', rest.find('=') - 1) + 1);
        if (is_exact_constant(key) || is_model_constant(key)) // whipple help 'exact solutions', doc/models.md have them
          continue;
        EXPECT_NE(manual.find("`" + key + "`"), std::string::npos) << key;
        ++keys;
      }
    EXPECT_GT(keys, 50);
  }

  TEST(SceneFile, OverridesAreReadLikeTheFile)
  {
    const Scene<2> scene =
        read_problem<2>(shield,
                        {"Mesh/Finest cell = 0.016 cm", "Materials/aluminium/Yield stress=100 MPa", "Title = coarse",
                         "Mesh/Levels = 2", "Mesh/Levels = 3", "Numerics/Inject failure at step = 7"})
            .scene;
    EXPECT_EQ(scene.lattice.spacing, 0.016);
    EXPECT_EQ(scene.lattice.max_level, 3);
    EXPECT_EQ(scene.title, "coarse");
    EXPECT_EQ(scene.materials[0].request.constants.at("Yield stress"), 0.001);
    EXPECT_EQ(scene.numerics.inject_failure_at_step, std::optional<int>(7));

    // a shorter list leaves subsections unused
    const Scene<2> first = read_problem<2>(shield, {"Stages/List = perforation"}).scene;
    EXPECT_EQ(first.stages.size(), 1u);
    EXPECT_EQ(first.stages[0].introduces, (std::vector<std::size_t>{0, 1}));

    EXPECT_EQ(
        complaint(shield, {"Mesh/Finest cel = 1 cm"}),
        "--set: Mesh/Finest cel = '1 cm': no such key; did you mean 'Finest cell'? allowed are Finest cell, Levels, "
        "Refinement, Buffer, Regrid interval, Distended threshold, Distended ratio, Quiet levels, Quiet velocity, "
        "Gradient field, Gradient levels, Gradient change, Smooth levels, Smooth change, Region, Region levels");
    EXPECT_EQ(complaint(shield, {"Mesh/Levels"}), "--set 'Mesh/Levels': allowed is 'Section/Sub/Name = value'");
    EXPECT_NE(complaint(shield, {"Mish/Levels = 2"}).find("no such section; did you mean 'Mesh'?"), std::string::npos);
    EXPECT_NE(complaint(shield, {"Mesh/Levels = many"}).find("--set: Mesh/Levels = 'many': allowed is a whole number"),
              std::string::npos);
  }

  TEST(SceneFile, DomainGrowsToWholeRootCells)
  {
    const Scene<2> scene = read_problem<2>(shield, {"Geometry/Upper corner = 4.1 cm, 11.3 cm"}).scene;
    EXPECT_EQ(scene.lattice.roots, (std::array<int, 2>{{33, 97}}));
    EXPECT_DOUBLE_EQ(scene.upper_corner()[0], 33 * 0.128);
    EXPECT_NE(scene.effective_parameters.find("4.224"), std::string::npos);
    const TemporaryScene copy("");
    write_effective_parameters(scene, copy.path());
    EXPECT_EQ(read_problem<2>(copy.path()).scene.lattice.roots, scene.lattice.roots);
  }

  TEST(SceneFile, EffectsLeftOutLeaveTheirModelsOut)
  {
    const Problem<2> problem = read_problem<2>(shield, {"Effects/List = strength", "Stages/List = perforation"});
    EXPECT_TRUE(problem.materials[0].model.strength);
    EXPECT_FALSE(problem.materials[0].model.void_law);
    EXPECT_TRUE(problem.materials[0].complete.void_law);
    EXPECT_FALSE(problem.layout.materials[0].void_law);
    EXPECT_FALSE(problem.scene.has_effect("voids"));
  }

  TEST(SceneFile, InitialStates)
  {
    const Scene<2> sod = read_problem<2>(source + "/prm/verification/sod.prm").scene;
    EXPECT_DOUBLE_EQ(sod.bodies[0].energy, 1. / 0.4);
    EXPECT_DOUBLE_EQ(sod.bodies[1].energy, 0.1 / 0.4 / 0.125);
    EXPECT_EQ(sod.lattice.roots, (std::array<int, 2>{{4, 100}}));
    EXPECT_EQ(sod.stages[0].introduces, (std::vector<std::size_t>{0, 1}));

    const Scene<2> sedov = read_problem<2>(source + "/prm/verification/sedov.prm").scene;
    EXPECT_EQ(sedov.lattice.roots, (std::array<int, 2>{{45, 45}}));
    ASSERT_TRUE(sedov.bodies[0].deposit);
    EXPECT_EQ(sedov.bodies[0].deposit->energy, 0.2467966);
    // twice as much, in all of space, brings the shock to 1 cm at 1 us; unit energy brings it to 1.151666 (exact
    // solution)
    EXPECT_NEAR(std::pow(2. * sedov.bodies[0].deposit->energy, -0.2), 1.151666, 1.5e-6);

    const Scene<2> piston = read_problem<2>(source + "/prm/verification/elastic_plastic_piston.prm").scene;
    EXPECT_EQ(piston.boundaries[2].kind, BoundaryKind::inflow);
    EXPECT_EQ(piston.boundaries[2].velocity, (Vector<2>{{0, 0.01}}));
    EXPECT_EQ(piston.materials[0].request.constants.at("Sound speed"), 0.533);
  }

  // The medium beyond a side is what touches it: here two plates at rest.
  TEST(SceneFile, AmbientStressIsThatOfTheBodiesAtTheSide)
  {
    const TemporaryScene file(
        edited_shield("set Right  = transmitting", "set Right  = transmitting, keeps ambient stress"));
    const Scene<2>     scene = read_problem<2>(file.path()).scene;
    const Boundary<2> &right = scene.boundaries[1];
    EXPECT_EQ(right.kind, BoundaryKind::transmitting);
    EXPECT_TRUE(right.keeps_ambient);
    EXPECT_FALSE(scene.boundaries[2].keeps_ambient);
    EXPECT_EQ(right.pressure, 0.);
    ASSERT_EQ(right.medium.size(), 1u);
    EXPECT_DOUBLE_EQ(right.medium[0].density, 2.785);
  }

  TEST(SceneFile, InfiniteConstants)
  {
    const Scene<2> scene = read_problem<2>(shield, {"Materials/aluminium/Alpha = infinite",
                                                    "Materials/aluminium/Spall strength = infinite"})
                               .scene;
    EXPECT_TRUE(std::isinf(scene.materials[0].request.constants.at("Alpha")));
    EXPECT_TRUE(std::isinf(scene.materials[0].request.constants.at("Spall strength")));
  }

  struct BadScene
  {
    const char *from, *to;   ///< edit of the shield's scene
    const char *key, *value; ///< what the message must name
    const char *allowed;     ///< and a part of what it says is allowed
  };

  TEST(SceneFile, WhateverIsWrongIsOneClearLine)
  {
    const std::vector<BadScene> bad{
        {"0.081 cm", "0.081", "Bodies/bumper/Thickness", "0.081", "the unit is missing; allowed is a length"},
        {"0.081 cm", "-0.081 cm", "Bodies/bumper/Thickness", "-0.081 cm", "must be > 0"},
        {"0.081 cm", "0.081 MPa", "Bodies/bumper/Thickness", "0.081 MPa", "'MPa' is not a unit of length"},
        {"0.081 cm", "0.081 furlong", "Bodies/bumper/Thickness", "0.081 furlong", "unknown unit 'furlong'"},
        {"0.081 cm", "", "Bodies/bumper/Thickness", "", "must be given"},
        {"0.32 cm\n", "0 cm\n", "Bodies/sphere/Diameter", "0 cm", "must be > 0"},
        {"0 cm, -0.16 cm", "0 cm, -0.15 cm", "Bodies/bumper/Front face", "0 cm", "overlaps the body 'sphere'"},
        {"0 cm, -0.16 cm", "0.5 cm, -0.16 cm", "Bodies/sphere/Center", "0.5 cm, -0.16 cm", "sits on the axis"},
        {"0 cm, -0.16 cm", "0 cm, -1.16 cm", "Bodies/sphere/Center", "0 cm, -1.16 cm", "allowed is the domain"},
        {"0 cm, -0.16 cm", "0 cm", "Bodies/sphere/Center", "0 cm", "2 components"},
        {"10.241 cm", "11.2 cm", "Bodies/wall/Front face", "11.2 cm", "allowed is the domain"},
        {"0 km/s, 6.58 km/s", "1 km/s, 6.58 km/s", "Bodies/sphere/Velocity", "1 km/s, 6.58 km/s", "on the axis"},
        {"0 km/s, 6.58 km/s", "0, 6.58", "Bodies/sphere/Velocity", "0, 6.58", "the unit is missing"},
        {"1.2 GPa", "-1.2 GPa", "Materials/aluminium/Spall strength", "-1.2 GPa", "must be >= 0"},
        {"345 MPa", "-345 MPa", "Materials/aluminium/Yield stress", "-345 MPa", "must be >= 0"},
        {"aluminium 2024-T4", "aluminum 2024-T4", "Materials/aluminium/Library", "aluminum 2024-T4",
         "did you mean 'aluminium 2024-T4'?"},
        {"aluminium 2024-T4", "", "Materials/aluminium/Equation of state", "mie-grueneisen", ""},
        {"= perfectly plastic", "= perfect", "Materials/aluminium/Strength", "perfect", "perfectly plastic"},
        {"= perfectly plastic", "= none", "Materials/aluminium/Equation of state", "mie-grueneisen", "no use"},
        {"= rate", "= fast", "Materials/aluminium/Void law", "fast", "none, equilibrium, p-alpha, rate"},
        {"= rate", "= none", "Materials/aluminium/Equation of state", "mie-grueneisen",
         "Alpha = 100000: no use to the models chosen"},
        {"set Shape    = sphere", "set Shape    = ball", "Bodies/sphere/Shape", "ball",
         "box, cone, cylinder, plate, polygon, sphere"},
        {"set Shape    = sphere", "", "Bodies/sphere/Shape", "",
         "must be given; allowed are box, cone, cylinder, plate, polygon, sphere"},
        {"set Diameter = 0.32 cm", "set Diametr = 0.32 cm", "Bodies/sphere/Diametr", "0.32 cm",
         "no such key; did you mean 'Diameter'?"},
        {"set Diameter = 0.32 cm", "set Diameter = 0.32 cm\n set Thickness = 1 cm", "Bodies/sphere/Thickness", "1 cm",
         "belongs to the shape plate"},
        {"set Material = aluminium", "set Material = steel", "Bodies/sphere/Material", "steel", "allowed is aluminium"},
        {"subsection bumper", "subsection bummper", "Bodies/bummper/Shape", "plate",
         "no such section; did you mean 'Bodies/bumper'?"},
        {"sphere, bumper, wall", "sphere, bumper, bumper", "Bodies/List", "sphere, bumper, bumper", "listed twice"},
        {"strength, voids, body tags", "strength, rust", "Effects/List", "strength, rust", "unknown 'rust'"},
        {"strength, voids, body tags", "strength, melting", "Effects/List", "strength, melting",
         "'melting' needs a material with a model for it; set Materials/NAME/Thermal model"},
        {"strength, voids, body tags", "strength, failure", "Effects/List", "strength, failure",
         "'failure' means nothing without 'voids'"},
        {"0.004 cm\n", "0 cm\n", "Mesh/Finest cell", "0 cm", "must be > 0"},
        {"0.004 cm\n", "1e-7 cm\n", "Mesh/Finest cell", "1e-7 cm", "too fine"},
        {"set Levels      = 5", "set Levels      = 5.5", "Mesh/Levels", "5.5", "whole number from 0 to 12"},
        {"= axisymmetric", "= spherical", "Geometry/Symmetry", "spherical", "axisymmetric, planar"},
        {"0 cm, -1.024 cm", "1 cm, -1.024 cm", "Geometry/Lower corner", "1 cm, -1.024 cm", "the axis"},
        {"4.096 cm, 11.264 cm", "4.096 cm, -11 cm", "Geometry/Upper corner", "4.096 cm, -11 cm", "above the lower"},
        {"set Left   = reflecting", "set Left   = transmitting", "Geometry/Left", "transmitting",
         "allowed is reflecting"},
        {"set Right  = transmitting", "set Right  = open", "Geometry/Right", "open", "inflow with a velocity"},
        {"set Right  = transmitting", "set Right  = inflow 1", "Geometry/Right", "inflow 1", "the unit is missing"},
        {"set Bottom = transmitting", "set Bottom = transmitting, keeps ambient stress", "Geometry/Bottom",
         "transmitting, keeps ambient stress", "no body touches this side"},
        {"= 1.5 us", "= 1.5", "Stages/perforation/End", "1.5", "the unit is missing; allowed is a time"},
        {"= 1.5 us", "= -1.5 us", "Stages/perforation/End", "-1.5 us", "must be > 0"},
        {"reaches wall", "reaches bumper", "Stages/debris/End", "until leading edge reaches bumper", "already"},
        {"reaches wall", "reaches moon", "Stages/debris/End", "until leading edge reaches moon", "unknown 'moon'"},
        {"= for 2 us", "= 1 us", "Stages/wall/End", "1 us", "does not start before 1.5 us"},
        {"set Introduces     = wall", "set Introduces     = bumper", "Stages/wall/Introduces", "bumper",
         "already entered"},
        {"= fragments", "= dust", "Stages/debris/Cohesion", "dust", "bonded, graded, fragments"},
        {"= fragments", "= graded\n set Break void = 2", "Stages/debris/Break void", "2", "0 to 1"},
        {"= 99 %", "= 101 %", "Stages/debris/Void cutoff", "101 %", "0 to 1"},
        {"= 10 %", "= 0.1", "Stages/debris/Minimum axial velocity", "0.1", "the unit is missing"},
        {"= hdf5", "= silo", "Output/Formats", "silo", "hdf5, vtu"},
        {"subsection Output", "subsection Exact solution\n set Name = magic\nend\nsubsection Output",
         "Exact solution/Name", "magic", "allowed are none, "},
        {"subsection Output", "subsection Numerics\n set Courant number = 0\nend\nsubsection Output",
         "Numerics/Courant number", "0", "1e-06 to 1"},
    };
    for (const BadScene &scene : bad)
      {
        const TemporaryScene file(edited_shield(scene.from, scene.to));
        const std::string    message = complaint(file.path());
        EXPECT_EQ(message.find(file.path()), 0u) << scene.key << ": " << message;
        EXPECT_NE(message.find(std::string(": ") + scene.key + " = '" + scene.value + "': "), std::string::npos)
            << scene.key << ": " << message;
        EXPECT_NE(message.find(scene.allowed), std::string::npos) << scene.key << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      }
  }

  // The line number leads to the place in the file.
  TEST(SceneFile, MessagesNameTheLine)
  {
    const TemporaryScene file(
        "set Title = x\nsubsection Geometry\n  set Symmetry = planar\n  set Lower corner = 0 cm, \\\n"
        "    0\nend\n");
    EXPECT_EQ(complaint(file.path()), file.path() +
                                          ":5: Geometry/Lower corner = '0 cm, 0': the unit is missing; allowed "
                                          "is a length such as 0.081 cm");
  }

  TEST(SceneFile, BrokenFiles)
  {
    EXPECT_EQ(complaint("/no/such/scene.prm"),
              "/no/such/scene.prm: cannot be read; give the path of a scene file (.prm)");
    const auto broken = [](const std::string &text) {
      const TemporaryScene file(text);
      return complaint(file.path());
    };
    EXPECT_NE(broken("subsection Mesh\n").find("subsection 'Mesh' is not closed"), std::string::npos);
    EXPECT_NE(broken("end\n").find(":1: 'end' without a subsection"), std::string::npos);
    EXPECT_NE(broken("\nMesh = fine\n").find(":2: 'Mesh = fine' is no statement"), std::string::npos);
    EXPECT_NE(broken("set Title\n").find("is no statement"), std::string::npos);
    EXPECT_NE(broken("set Title = a\nset Title = b\n").find("is set twice"), std::string::npos);
    EXPECT_NE(broken("").find("Geometry/Lower corner = '': must be given"), std::string::npos);
  }
} // namespace
