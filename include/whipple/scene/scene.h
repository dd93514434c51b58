// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/effect_parameters.h>
#include <whipple/effect/effect_verdict.h>
#include <whipple/hydro/hydro_parameters.h>
#include <whipple/material/material_request.h>
#include <whipple/mesh/bonds.h>
#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_builder.h>
#include <whipple/mesh/mesh_map.h>
#include <whipple/projection/projection_parameters.h>
#include <whipple/scene/shape.h>
#include <whipple/scene/stage_end.h>
#include <whipple/state/kinetic_loss.h>

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What a .prm says, checked and in internal units (cm, g, us, Mbar): plain data. What is built from it to run, models,
/// solutions, fields, is the Problem (problem/problem.h). The keys, units and defaults of every entry are in
/// doc/scene_files.md.
namespace whipple
{
  class RefinementCriterion;
  class Representation;

  /// A material under the name the scene gives it.
  struct SceneMaterial
  {
    std::string     name;    ///< the scene's name; request.library is the library's
    MaterialRequest request; ///< models and constants, those of the library filled in
  };

  /// Energy put into one cell of a body before the run starts (point explosions).
  template <int dim>
  struct EnergyDeposit
  {
    double      energy = 0; ///< Mbar cm^3, true volumes: what the whole domain receives
    Vector<dim> point{};    ///< cm; goes into the leaf that holds this point (of several, the one of smallest key)
  };

  /// What a body is filled with when it enters.
  enum class InitialState
  {
    uniform,    ///< one density, energy and velocity
    exact,      ///< those of the scene's exact solution at that time
    expressions ///< functions of the coordinates
  };

  /// A body as it enters the scene, without void and stress.
  template <int dim>
  struct Body
  {
    std::string                       name;
    Shape<dim>                        shape;
    std::size_t                       material      = 0; ///< index into Scene::materials
    InitialState                      initial_state = InitialState::uniform;
    Vector<dim>                       velocity{};  ///< cm/us; expressions: the mean by mass
    double                            density = 0; ///< g/cm^3; exact: the material's at rest; expressions: the mean
    double                            energy  = 0; ///< specific internal energy, Mbar cm^3/g; expressions: the mean
    std::optional<EnergyDeposit<dim>> deposit;

    /// Whether it has one state: density, energy and velocity above.
    bool
    is_uniform() const
    {
      return initial_state == InitialState::uniform;
    }
  };

  /// What moves the mesh of a stage.
  enum class StageMode
  {
    eulerian,  ///< fixed mesh: Lagrange step, then remap
    lagrangian ///< the mesh moves with the material: no remap
  };

  /// What a Lagrangian stage takes over from the Eulerian stage before it; the rest is dropped and booked.
  struct DebrisEntry
  {
    double                     void_cutoff            = 0.99; ///< cells with more void than this are dropped
    double                     minimum_axial_velocity = 0;    ///< cm/us, along the line of flight
    std::optional<std::size_t> behind; ///< only cells beyond the rear face of this body (as it entered the scene)
  };

  /// What a stage says whose mesh moves.
  struct LagrangianStage
  {
    Cohesion      cohesion = Cohesion::bonded;
    BreakCriteria breaking; ///< graded cohesion
    DebrisEntry   debris;   ///< where the stage follows an Eulerian one
  };

  /// When elements of a Lagrangian stage are laid down in the Eulerian one after it.
  enum class Landing
  {
    at_once,      ///< all at its begin
    as_it_arrives ///< what flies freely waits until it comes to what is there
  };

  /// One link of the chain.
  /// Until when an Eulerian stage follows its plates.
  enum class PlatesMeasured
  {
    at_the_end, ///< of the stage
    settled     ///< on in a copy of the state, until holes and craters have stopped growing
  };

  struct Stage
  {
    std::string                     name;
    std::vector<std::size_t>        introduces; ///< indices of bodies that enter at its start
    std::shared_ptr<const StageEnd> end;
    double                          max_time_step       = std::numeric_limits<double>::infinity(); ///< us
    KineticLoss                     lost_kinetic_energy = KineticLoss::heat; ///< by remap and projection
    PlatesMeasured                  plates_measured     = PlatesMeasured::at_the_end;
    std::optional<double>           void_growth; ///< us/cm^2, alpha of every rate void law; none: as the materials say
    /// What the elements of a Lagrangian stage before it are laid down as.
    std::shared_ptr<const Representation> representation;
    Landing                               landing = Landing::at_once;

    std::optional<LagrangianStage> lagrangian; ///< none: the mesh is fixed

    StageMode
    mode() const
    {
      return lagrangian ? StageMode::lagrangian : StageMode::eulerian;
    }
  };

  enum class Refinement
  {
    adaptive, ///< by what the cells hold
    uniform,  ///< the finest level everywhere
    region    ///< the finest level in a fixed box, coarser cells around it: order tests with hanging nodes
  };

  /// How the forest follows the material; its cells themselves are Scene::lattice.
  struct MeshControl
  {
    Refinement refinement     = Refinement::adaptive;
    int        buffer         = 8;  ///< cells of the level needed kept around material
    int        regrid_steps   = 10; ///< steps between looks whether to regrid
    double     solid_fraction = 0;  ///< solid volume / cell volume below which a cell gives up one level ...
    double     solid_ratio    = 0;  ///< ... and one more for each factor of this (< 1) below it
    int        quiet_levels   = 0;  ///< levels that undisturbed material gives up
    double     quiet_velocity = 0;  ///< cm/us; slower than this, and with less stress than rho c times it: undisturbed

    std::vector<std::shared_ptr<const RefinementCriterion>>
        criteria; ///< that are on; the one that gives up most counts

    Box<2> region;            ///< cm; Refinement::region
    int    region_levels = 0; ///< levels that cells outside the region give up
  };

  /// Coefficients of the scheme; doc/theory says what they multiply.
  struct Numerics
  {
    HydroParameters hydro;                  ///< Courant number, viscosity, hourglass, volume change
    double          advection_limit = 0.45; ///< largest displacement of a node in a step, in cell edges (Eulerian)
    double          growth_limit    = 1.1;  ///< largest ratio of one time step to the last, > 1
    int             remap_order     = 2;    ///< 1 or 2

    std::optional<int> inject_failure_at_step; ///< test hook: the state goes bad in this step (counted from 1) ...
    int                injected_failures = std::numeric_limits<int>::max(); ///< ... and in so many tries of it
  };

  struct OutputControl
  {
    std::optional<double> fields_interval;            ///< us; none: no field files
    bool                  hdf5                = true; ///< HDF5 + XDMF
    bool                  vtu                 = false;
    double                statistics_interval = 0; ///< us; 0: every step
    std::optional<double> history_interval;        ///< us; none: no history.csv
    std::optional<double> checkpoint_interval;     ///< s of wall time; none: checkpoints at the ends of stages only
    std::optional<double> wall_time_limit;         ///< s; none: no limit
    int error_estimate_levels = 0; ///< cell sizes, the scene's own included, that error bars are taken from; 0: none
  };

  /// What an extra section (problem/extra_section.h) says; its owner knows what it is.
  struct SectionContent
  {
    virtual ~SectionContent() = default;
  };

  template <int dim>
  struct Scene
  {
    std::string file;  ///< the .prm it was read from
    std::string title; ///< one line for the banner

    Boundaries<dim> boundaries;
    Lattice<dim>    lattice;                      ///< symmetry, lower corner, finest cell, root cells, levels
    MeshMap         mesh_map = MeshMap::identity; ///< where the nodes of the lattice, and all bodies on it, start
    MeshControl     mesh;

    std::vector<SceneMaterial>              materials;
    std::vector<std::string>                effects;           ///< names of those that are on
    std::vector<EffectVerdict>              effect_verdicts;   ///< for every effect there is
    std::map<std::string, EffectParameters> effect_parameters; ///< by the name of the effect; of those that have any
    std::vector<Body<dim>>                  bodies;
    std::vector<Stage>                      stages; ///< at least one
    Numerics                                numerics;
    OutputControl                           output;

    std::map<std::string, std::shared_ptr<const SectionContent>>
        extra; ///< by the name of the section; those that are used

    std::string effective_parameters; ///< every value in force, as a .prm that reads back to this scene

    bool
    has_effect(const std::string &name) const
    {
      for (const std::string &effect : effects)
        if (effect == name)
          return true;
      return false;
    }

    /// Upper corner of the domain, cm.
    Vector<dim>
    upper_corner() const
    {
      Vector<dim> upper;
      for (int d = 0; d < dim; ++d)
        upper[d] = lattice.origin[d] + lattice.spacing * lattice.finest(d);
      return upper;
    }

    /// Smallest box around what the map makes of a box of the lattice that reaches through all angles if it is polar.
    Box<dim>
    mapped_box(const Box<dim> &box) const
    {
      if (mesh_map != MeshMap::polar)
        return box;
      Box<dim> square;
      square.upper.fill(box.upper[0]);
      return square;
    }
  };
} // namespace whipple
