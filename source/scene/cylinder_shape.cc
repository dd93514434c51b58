// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/box_shape.h>
#include <whipple/scene/shape_registry.h>

namespace whipple
{
  namespace
  {
    const ShapeRegistration<2> registration(
        {.name    = "cylinder",
         .summary = "a solid cylinder along axis 1; planar: the box whose cross-section it is",
         .documentation =
             "In axisymmetry it stands on the axis: a disc or a rod. In planar symmetry it is as wide as its "
             "diameter, and `Rotation` turns it.",
         .parameters   = {{"Center", "two lengths", "", "its middle"},
                          {"Diameter", "a length", "", "across axis 1"},
                          {"Length", "a length", "", "along axis 1"}},
         .position_key = "Center",
         .size_key     = "Length"},
        [](const ShapeInput<2> &input) -> Shape<2> {
          const Vector<2> center = input.point("Center");
          const double radius = 0.5 * input.positive_length("Diameter"), half = 0.5 * input.positive_length("Length");
          if (input.symmetry() == Symmetry::axisymmetric && center[0] != 0)
            input.reject("Center", "in axisymmetry a cylinder stands on the axis; its first component must be 0 cm");
          return BoxShape<2>({{{center[0] - radius, center[1] - half}}, {{center[0] + radius, center[1] + half}}});
        });
  } // namespace
} // namespace whipple
