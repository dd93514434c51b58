// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/snapshot.h>
#include <whipple/problem/field_layout.h>
#include <whipple/scene/scene.h>

#include <string>
#include <vector>

namespace whipple
{
  enum class GaugeKind
  {
    fixed,           ///< stays where it is
    material,        ///< moves with the material
    surface_velocity ///< looks at the free surface of a body on the lower side of axis 0
  };

  /// One instrument of a scene (doc/theory/gauges.md).
  template <int dim>
  struct Gauge
  {
    std::string              name;
    GaugeKind                kind = GaugeKind::fixed;
    Vector<dim>              point{};      ///< cm; fixed and material: where it is at the start
    std::size_t              body = 0;     ///< surface velocity: whose surface ...
    bool                     rear = true;  ///< ... the upper one along axis 1, or the lower
    std::vector<std::string> fields;       ///< fixed and material: names as in field files, and "velocity"
    double                   interval = 0; ///< us between rows; 0: every step
  };

  /// The section Gauges.
  template <int dim>
  struct Gauges : SectionContent
  {
    static constexpr const char *section = "Gauges";

    std::vector<Gauge<dim>> list;
  };

  /// Name of the field that is a vector and sits on the nodes.
  inline constexpr const char *velocity_field = "velocity";

  /// The fields of some cells as the field files show them, but for the rank.
  template <int dim>
  std::vector<CellField>
  gauge_fields(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
               const std::vector<Index> &cells);

  /// The same without cells: names and units of what a scene has.
  template <int dim>
  std::vector<CellField>
  known_gauge_fields(const FieldLayout &layout);
} // namespace whipple
