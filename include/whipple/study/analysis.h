// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/convergence.h>
#include <whipple/study/study_runner.h>

#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// A number that runs are measured by: a result, or an error against the exact solution.
  struct Quantity
  {
    bool        exact = false; ///< an error against the exact solution: limit 0
    std::string place;         ///< of a result; field of an error ("density")
    std::string name;          ///< of a result ("hole_diameter_cm"); norm of an error ("L1")

    auto
    operator<=>(const Quantity &) const = default;

    /// "bumper hole diameter, cm", "density L1, g/cm^3"
    std::string
    readable() const;
    std::string
    unit() const;
  };

  /// The value of a quantity in a record; none if it has none. The error "shock position" is made of two results.
  std::optional<double>
  value_of(const PointRecord &record, const Quantity &quantity);

  /// A quantity along a series.
  struct Trend
  {
    Quantity                           quantity;
    std::vector<convergence::Level>    levels; ///< coarse to fine; points without a value are left out
    std::vector<std::optional<double>> orders; ///< one a level: errors: from the level before, results: the two before
    convergence::Estimate              estimate; ///< results only
  };

  /// A result that is a verdict, yes or no, along a series: no order, no error bar.
  struct Verdicts
  {
    std::string                          place, name;
    std::vector<std::pair<double, bool>> levels; ///< cell (cm) and verdict, coarse to fine
  };

  /// Points that differ in their cells only.
  struct Series
  {
    std::string              label;  ///< values of the other axes; "base" if there are none
    std::vector<std::size_t> choice; ///< of its first point
    std::vector<std::size_t> points; ///< indices of outcomes, coarse to fine
    std::vector<Trend>       errors, results;
    std::vector<Verdicts>    verdicts;
  };

  /// What the errors of a result are relative to: the best estimate of its limit that the study has.
  struct Reference
  {
    Quantity    quantity;
    double      value = 0, uncertainty = 0;
    std::string series; ///< label of the series it comes from
  };

  /// A choice (a value of an axis other than cell and ranks) against the base of that axis, all else at the base.
  struct ChoiceEffect
  {
    Quantity    quantity;
    std::string axis, label, base;
    double      cell       = 0; ///< cm, of both points
    double      base_value = 0, value = 0;
    /// What the mesh does to the base's result: its distance from the extrapolated limit (or the finest value) and what
    /// that may be wrong by; none if the base has one level only.
    std::optional<double> mesh_error;
  };

  /// All that a study says.
  struct StudyAnalysis
  {
    std::vector<Quantity>     errors, results; ///< that some point has a number for
    std::vector<Series>       series;
    std::vector<Reference>    references;
    std::vector<ChoiceEffect> effects;

    /// Null if there is none.
    const Reference *
    reference(const Quantity &quantity) const;
  };

  StudyAnalysis
  analyse(const StudyPlan &plan, const std::vector<PointOutcome> &outcomes);

  /// Error of a point as a number > 0: of an exact solution the error itself, else the distance from the reference,
  /// relative to it unless its uncertainty reaches to 0; with what the reference itself may be wrong by (0 for an exact
  /// solution).
  struct PointError
  {
    double error = 0, uncertainty = 0;
    bool   relative = false;
  };

  std::optional<PointError>
  point_error(const StudyAnalysis &analysis, const PointRecord &record, const Quantity &quantity);
} // namespace whipple
