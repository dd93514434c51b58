// SPDX-License-Identifier: LGPL-2.1-or-later
// Solid triangles, one for each half of an element: as in 1993.
#include <whipple/projection/representation.h>

namespace whipple
{
  namespace
  {
    class Packages : public Representation
    {
    public:
      projection::ElementPieces
      pieces_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element) const override
      {
        return projection::solid_pieces(symmetry, layout, element);
      }
    };

    const RepresentationRegistration registration("packages", {"solid triangles, 1993", {}, [](const SectionInput &) {
                                                                 return std::make_shared<Packages>();
                                                               }});
  } // namespace
} // namespace whipple
