// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/problem.h>

#include <string>
#include <vector>

/// What is likely to disappoint about a scene, told from what it says alone, before anything runs: one line each, with
/// the numbers. Nothing here is an error, and all estimates are rough (doc/theory/stages.md, "Warnings before a run").
namespace whipple
{
  /// All of the below, in this order.
  template <int dim>
  std::vector<std::string>
  scene_warnings(const Problem<dim> &problem);

  namespace warnings
  {
    /// Bodies thinner than 2.5 finest cells, spheres of fewer than 10 cells a diameter.
    template <int dim>
    std::vector<std::string>
    resolution(const Scene<dim> &scene);

    /// Stages that wait for a body towards which nothing moves, and those whose criteria drop all that moves.
    template <int dim>
    std::vector<std::string>
    endless_stages(const Scene<dim> &scene);

    /// Bodies and debris that will leave through a side before the last stage ends.
    template <int dim>
    std::vector<std::string>
    leaving_matter(const Scene<dim> &scene);

    /// Johnson-Cook damage whose fit has no ductility left within its own range.
    template <int dim>
    std::vector<std::string>
    damage_without_ductility(const Problem<dim> &problem);

    /// Laws that keep a pressure in vacuum at an energy that the fastest impact of the scene can bring.
    template <int dim>
    std::vector<std::string>
    pressure_in_vacuum(const Problem<dim> &problem);

    /// Memory above 1 GB, time above 1 h.
    template <int dim>
    std::vector<std::string>
    cost(const Problem<dim> &problem);
  } // namespace warnings

  /// What a run is likely to take, on one core.
  struct CostEstimate
  {
    double cells   = 0; ///< most active cells of a stage
    double steps   = 0; ///< of all stages
    double seconds = 0;
    double bytes   = 0;

    std::vector<double> stage_seconds; ///< of each stage; 0 where its end cannot be foreseen
  };

  template <int dim>
  CostEstimate
  estimate_cost(const Problem<dim> &problem);

  /// When stages start and the last one ends, us: fixed times from the scene, a wait for the leading edge from the way
  /// and the speed of the fastest body (infinite if nothing moves there). One entry more than there are stages.
  template <int dim>
  std::vector<double>
  stage_times(const Scene<dim> &scene);
} // namespace whipple
