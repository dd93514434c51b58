// SPDX-License-Identifier: LGPL-2.1-or-later
// Solid pieces of a physical size, and dust where that is too small to be seen: doc/theory/fragments.md.
#include <whipple/projection/form_fragments.h>

namespace whipple
{
  namespace
  {
    const std::string              size_key = "Fragment size", from_model = "model";
    const std::string              rings_key = "Fragment rings";
    const std::vector<std::string> rings_names{"solid", "thinned"}; // in the order of Rings

    class Fragments : public Representation
    {
    public:
      /// @param size of all fragments, cm; not given: what the effect "fragment size" carries
      Fragments(std::optional<double> size, projection::Rings rings)
        : size_(size)
        , rings_(rings)
      {
      }

      std::vector<Element<2>>
      gather(const LandingView &view, std::vector<Element<2>> elements, Bookings<2> &bookings) const override
      {
        std::vector<double> size(elements.size(), size_.value_or(0.));
        if (!size_)
          for (std::size_t i = 0; i < elements.size(); ++i)
            size[i] = carried_size(view, elements[i].packet);
        projection::FragmentReport report;
        elements                          = projection::form_fragments(view, std::move(elements), size, rings_, report);
        Booking<2> formed                 = lost_kinetic_energy<2>(report.kinetic_loss, view.loss);
        formed.left.emplace().momentum[0] = report.axis_impulse;
        formed.event                      = Event{static_cast<double>(report.pieces), report.mass, "g"};
        bookings.enter("fragments laid down as solid pieces", formed);
        bookings.note("fragments that would reach across the axis laid down as dust",
                      static_cast<double>(report.not_formed), 1., "times");
        return elements;
      }

      projection::ElementPieces
      pieces_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element) const override
      {
        return projection::distended_pieces(symmetry, layout, element);
      }

      std::pair<std::string, std::string>
      needed_effect() const override
      {
        return size_ ? std::pair<std::string, std::string>{} : std::pair{size_key, std::string("fragment size")};
      }

    private:
      /// Mean size by mass of what has broken, over the materials; 0 if less than half of the mass has.
      static double
      carried_size(const LandingView &view, const CellPacket &packet)
      {
        double mass = 0, broken = 0, moment = 0;
        for (int m = 0; m < view.layout.n_materials(); ++m)
          {
            const double own = packet[view.layout.mass(m)];
            mass += own;
            broken += own * packet[view.layout.field(m, view.fragmented_share)];
            moment += own * packet[view.layout.field(m, view.fragment_size_moment)];
          }
        return broken > 0.5 * mass ? moment / broken : 0.;
      }

      std::optional<double> size_;
      projection::Rings     rings_;
    };

    std::shared_ptr<const Representation>
    read(const SectionInput &input)
    {
      const auto rings = static_cast<projection::Rings>(input.choice(rings_key, rings_names));
      return std::make_shared<Fragments>(
          input.text(size_key) == from_model ? std::nullopt : std::optional<double>(input.length(size_key)), rings);
    }

    const RepresentationRegistration
        registration("fragments",
                     {"solid pieces of a physical size",
                      {{size_key, from_model,
                        "fragments: model (from the effect \"fragment size\") | a length, the size of all fragments"},
                       {rings_key, "thinned",
                        "fragments, off the axis: thinned (a ring's section stays a fragment's, void opens in it as it "
                        "flies outwards) | "
                        "solid (the section shrinks)"}},
                      read});
  } // namespace
} // namespace whipple
