// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/polygon_shape.h>
#include <whipple/scene/shape_registry.h>

namespace whipple
{
  namespace
  {
    const ShapeRegistration<2> registration(
        {.name    = "cone",
         .summary = "a cone along axis 1, sharp or blunt; planar: a wedge",
         .documentation =
             "Base at the bottom, tip at larger axis 1; `Rotation = 180 deg` turns it over. In axisymmetry it "
             "stands on the axis.",
         .parameters   = {{"Base center", "two lengths", "", "middle of its base"},
                          {"Base diameter", "a length", "", "at its lower end"},
                          {"Top diameter", "a length", "0 cm: a tip", "at its upper end"},
                          {"Length", "a length", "", "along axis 1"}},
         .position_key = "Base center",
         .size_key     = "Length"},
        [](const ShapeInput<2> &input) -> Shape<2> {
          const Vector<2> base = input.point("Base center");
          const double radius = 0.5 * input.positive_length("Base diameter"), length = input.positive_length("Length");
          if (input.symmetry() == Symmetry::axisymmetric && base[0] != 0)
            input.reject("Base center", "in axisymmetry a cone stands on the axis; its first component must be 0 cm");
          double top = 0;
          if (input.given("Top diameter") && (top = 0.5 * input.length("Top diameter")) < 0)
            input.reject("Top diameter", "must be >= 0; allowed is a length such as 0.1 cm, or 0 cm for a tip");
          std::vector<Vector<2>> corners{{{base[0] - radius, base[1]}}, {{base[0] + radius, base[1]}}};
          corners.push_back({{base[0] + top, base[1] + length}});
          if (top > 0)
            corners.push_back({{base[0] - top, base[1] + length}});
          return PolygonShape(std::move(corners));
        });
  } // namespace
} // namespace whipple
