// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/profile.h>
#include <whipple/material/material_factory.h>
#include <whipple/mesh/boundary.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace whipple::exact
{
  /// What an exact solution may learn of a body of the scene.
  template <int dim>
  struct BodyState
  {
    std::string                              name;
    Material                                 material;
    MaterialRequest                          constants;        ///< of the material, those of the library filled in
    Vector<dim>                              lower{}, upper{}; ///< bounding box, cm
    bool                                     round = false;    ///< the ball in that box, not all of it
    std::function<bool(const Vector<dim> &)> inside; ///< whether a point is in it; empty: it is the box, or the ball
    Vector<dim>                              velocity{};  ///< cm/us
    double                                   density = 0; ///< g/cm^3
    double                                   energy  = 0; ///< Mbar cm^3/g
    double                                   deposit = 0; ///< energy deposited, Mbar cm^3
  };

  /// What a scene says about its exact solution.
  template <int dim>
  struct ExactRequest
  {
    std::string                   name;                        ///< exact_kinds()
    Geometry                      geometry = Geometry::planar; ///< of a profile
    double                        start    = 0;                ///< time of the solution at the start of the run, us
    double                        duration = 0;                ///< of the run if known beforehand, else 0, us
    std::map<std::string, double> constants; ///< those of the kind, defaults filled in; internal units
    Symmetry                      symmetry = Symmetry::planar;
    Vector<dim>                   lower{}, upper{}; ///< corners of the domain, cm
    Boundaries<dim>               boundaries;
    std::vector<BodyState<dim>>   bodies; ///< in the order of the scene
  };

  /// A constant of an exact solution, set by its key in the scene's section "Exact solution".
  struct ExactConstant
  {
    std::string key;           ///< "Exponent"
    std::string quantity;      ///< "pure number", "length", "velocity" ...: names of scene/units.h
    double      default_value; ///< internal units
    std::string documentation;
  };

  /// One admissible name, for messages, help and the manual.
  struct ExactKind
  {
    std::string                name;        ///< "noh"
    std::string                description; ///< one line: the problem, what it takes from the scene, source
    std::vector<ExactConstant> constants;
    bool                       any_shape = false; ///< of bodies; else boxes and balls
  };

  /// All exact solutions of the library.
  template <int dim>
  std::vector<ExactKind>
  exact_kinds();

  /// The solution a request names.
  /// @throws InputError (one line, without file name) if the scene is not what the solution needs.
  template <int dim>
  std::unique_ptr<const ExactSolution<dim>>
  make_exact_solution(const ExactRequest<dim> &request);
} // namespace whipple::exact
