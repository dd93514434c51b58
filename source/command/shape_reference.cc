// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/command/shape_reference.h>
#include <whipple/scene/shape_registry.h>

#include <sstream>

namespace whipple
{
  std::string
  shape_reference()
  {
    std::ostringstream text;
    text << "# Shapes of bodies\n\n"
            "Chosen by Bodies/NAME/Shape. Written by `whipple help shapes`.\n\n"
            "Every shape can be turned: `Rotation` (an angle, `30 deg`, from axis 0 towards axis 1) about `Rotation "
            "center` (two\nlengths; unless given the middle of the body's extent, 0 along an axis on which it reaches "
            "over "
            "the whole domain).\nIn axisymmetry only by 180 deg, end for end, about a point on the axis.\n";
    for (const auto &[name, entry] : ShapeRegistry<2>::all())
      {
        const ShapeDescription &shape = entry.description;
        text << "\n## " << name << "\n\n"
             << shape.summary << '.' << (shape.documentation.empty() ? "" : " ") << shape.documentation << '\n';
        text << "\n| parameter | value | unless given | meaning |\n|---|---|---|---|\n";
        for (const ShapeParameter &p : shape.parameters)
          text << "| `" << p.key << "` | " << p.value << " | " << (p.otherwise.empty() ? "needed" : p.otherwise)
               << " | " << p.documentation << " |\n";
      }
    return text.str();
  }
} // namespace whipple
