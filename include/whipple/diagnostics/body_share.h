// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/field_layout.h>
#include <whipple/scene/scene.h>
#include <whipple/state/fields.h>

namespace whipple
{
  /// Share of a material's mass in a cell that came from a body. @param m the state of the body's material
  template <int dim>
  double
  share_of_body(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const MaterialState &m, Index c)
  {
    if (layout.body_tag[body] >= 0)
      return m.fields[layout.body_tag[body]].value[c];
    double share = 1.;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      if (layout.body_material[b] == layout.body_material[body] && layout.body_tag[b] >= 0)
        share -= m.fields[layout.body_tag[b]].value[c];
    return share;
  }
} // namespace whipple
