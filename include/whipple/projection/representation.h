// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>
#include <whipple/projection/element.h>
#include <whipple/projection/element_pieces.h>
#include <whipple/registry.h>
#include <whipple/section_entry.h>
#include <whipple/state/bookings.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What debris is when it is laid down on a fixed mesh. Each representation is a class that registers itself, in a file
/// of its own (doc/extending.md).
namespace whipple
{
  /// What a representation may look at beside the elements.
  struct LandingView
  {
    const Lattice<2>          &lattice; ///< elements have the keys of the cells that they came from
    const CellPacketLayout<2> &layout;
    KineticLoss                loss             = KineticLoss::heat; ///< what becomes of kinetic energy that it loses
    int                        fragmented_share = -1; ///< carried fields of the effect "fragment size": the share of
    int                        fragment_size_moment = -1; ///< mass that has broken, and that share times the size
  };

  class Representation
  {
  public:
    virtual ~Representation() = default;

    /// The elements as they are to be laid down, in place of all elements of all ranks, ordered by key. Mass, momentum
    /// and total energy are kept but for what is booked (the same on all ranks).
    virtual std::vector<Element<2>>
    gather(const LandingView &, std::vector<Element<2>> elements, Bookings<2> &) const
    {
      return elements;
    }

    /// One of them as the two triangles that are clipped. @throws StateError if it has no volume or no mass.
    virtual projection::ElementPieces
    pieces_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element) const = 0;

    /// Entry of the stage and the effect that this choice of it needs; empty if it needs none.
    virtual std::pair<std::string, std::string>
    needed_effect() const
    {
      return {};
    }
  };

  /// A representation as scenes and messages know it.
  struct RepresentationKind
  {
    std::string                                                                summary; ///< one line
    std::vector<SectionEntry>                                                  entries; ///< of the stage's section
    std::function<std::shared_ptr<const Representation>(const SectionInput &)> read;
  };

  /// All representations there are, by name.
  class RepresentationRegistry : public Registry<RepresentationRegistry, RepresentationKind>
  {
  public:
    /// One that needs no entries, or takes their defaults.
    /// @throws std::out_of_range if there is none of this name
    static std::shared_ptr<const Representation>
    make(const std::string &name);

    /// "distended (whole elements) | ..."
    static std::string
    usage();
  };

  /// Makes a representation known: one line at the end of its file.
  using RepresentationRegistration = RepresentationRegistry::Registered;
} // namespace whipple
