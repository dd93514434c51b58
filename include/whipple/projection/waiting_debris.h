// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/cell_geometry.h>
#include <whipple/projection/element.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

/// Debris that is on its way and not on any mesh: equations in doc/theory/stages.md, "Streaming hand-over".
namespace whipple
{
  /// An element, or a part of a piece, in free flight.
  template <int dim>
  struct Waiting
  {
    Element<dim> element;   ///< as it was when it began to wait
    double       since = 0; ///< us; when that was
    Vector<dim>  centre{};  ///< cm; middle of its piece's section then, of itself if it is none
    double       reach = 0; ///< cm; from there to the side of that section that is next to the axis
  };

  /// All that waits; a value, the same on all ranks. Free flight does not change the totals.
  template <int dim>
  struct WaitingDebris
  {
    std::vector<Waiting<dim>> parts;       ///< those of a piece one after the other
    ConservedTotals<dim>      totals;      ///< of the parts
    double                    fastest = 0; ///< cm/us, largest speed of a corner
  };

  /// Shared by copies of a run state. Null: nothing waits.
  template <int dim>
  using SharedDebris = std::shared_ptr<const WaitingDebris<dim>>;

  /// Let elements wait from now on, behind those that do already. Pieces get numbers that no other piece has, and
  /// elements that are none lose their deviatoric stress.
  /// @param stress carried fields of deviatoric stress
  std::vector<Waiting<2>>
  begin_to_wait(const CellPacketLayout<2> &layout, std::vector<Waiting<2>> waiting, std::vector<Element<2>> elements,
                std::span<const int> stress, double time);

  /// Where the corners of a part are, and their velocities: those it began to wait with, and outwards again once it has
  /// come to the axis.
  std::pair<CornerVectors<2>, CornerVectors<2>>
  motion_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time);

  /// Where the corners of a part are.
  CornerVectors<2>
  corners_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time);

  /// Parts as elements where they are. A piece's mass is spread over its parts by their volumes: give it whole.
  /// Mass, energies and momentum (along axis 0 but for what has come to the axis) are those of when they began to wait.
  std::vector<Element<2>>
  elements_at(Symmetry symmetry, const CellPacketLayout<2> &layout, std::span<const Waiting<2>> parts, double time);

  /// Mean void fraction of a part where it is.
  double
  void_fraction_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time);
} // namespace whipple
