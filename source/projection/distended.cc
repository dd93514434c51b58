// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole elements with their voids: the dust limit.
#include <whipple/projection/representation.h>

namespace whipple
{
  namespace
  {
    class Distended : public Representation
    {
    public:
      projection::ElementPieces
      pieces_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element) const override
      {
        return projection::distended_pieces(symmetry, layout, element);
      }
    };

    const RepresentationRegistration registration("distended",
                                                  {"whole elements with their voids", {}, [](const SectionInput &) {
                                                     return std::make_shared<Distended>();
                                                   }});
  } // namespace
} // namespace whipple
