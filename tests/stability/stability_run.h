// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "case_record.h"
#include "scene_text.h"
#include "statistics_table.h"

#include <whipple/ledger/ledger.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/output/summary.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  template <int dim>
  class Simulation;
}

namespace whipple::stability
{
  /// One owned cell with material at the end of a run.
  struct Cell
  {
    double x[2];     ///< centre, cm
    double extent;   ///< along axis 1, cm
    double volume;   ///< cm^3
    double mass;     ///< of all materials, g
    double velocity; ///< along axis 1, mean of the corners, cm/us
    double density;  ///< mass / volume of the cell, g/cm^3
    double pressure; ///< volume-weighted over the materials, open void counting as 0, Mbar
    double energy;   ///< specific internal energy by mass, Mbar cm^3/g
  };

  /// A run that ended, or stopped.
  struct Outcome
  {
    std::shared_ptr<Simulation<2>> simulation;
    std::optional<std::string>     stopped; ///< why, if it did
    std::string                    directory;
    StatisticsTable                statistics;

    const FlatMesh<2> &
    mesh() const;
    const State<2> &
    state() const;
    const Derived &
    derived() const;
    const Ledger<2> &
    ledger() const;
    const summary::Summary &
    summary() const;

    /// Largest kinetic energy at any step over what all bodies brought with them.
    double
    kinetic_growth() const;

    /// Largest value of a column of the statistics.
    double
    largest(const std::string &column) const;

    /// Largest closure of mass, axial momentum and energy over all steps.
    double
    closure() const;

    /// Steps of all stages.
    long
    steps() const;

    /// Smallest time step over the median one; the last step of a stage, which ends where it must, is left out.
    double
    smallest_step_over_median() const;

    /// Owned cells with material, ordered along axis 1, then axis 0.
    std::vector<Cell>
    cells() const;

    /// Smallest value of a member of MaterialState over all cells that hold the material; -infinity if one is not a
    /// number.
    double
    smallest(std::vector<double> MaterialState::*member) const;

    /// The same of the pressure of the materials, Mbar.
    double
    smallest_pressure() const;

    /// Largest value of a member of MaterialState over all cells that hold the material; infinity if one is not a
    /// number.
    double
    greatest(std::vector<double> MaterialState::*member) const;

    /// Fastest node with mass, component along an axis (up or down), cm/us.
    double
    fastest(int axis = 1) const;
  };

  /// Run a scene file, in this process; what stops it is an outcome, not an error.
  /// @param folder of the output, under stability_output/ of the working directory
  Outcome
  run_file(const std::string &file, const std::string &folder, const std::vector<std::string> &overrides = {});

  /// Run a scene that was built in code; it is left beside its output as scene.prm.
  Outcome
  run(const SceneText &scene, const std::string &folder);

  /// What must hold of every run: it ends, nothing is not a number, the ledger is closed.
  void
  expect_sound(Case &table, const Outcome &outcome);

  /// ... and, where no side does work and bodies bring no pressure with them, kinetic energy is never more than at
  /// first.
  void
  expect_sound_impact(Case &table, const Outcome &outcome);
} // namespace whipple::stability
