// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/to_eulerian.h>

#include <whipple/error.h>
#include <whipple/projection/deposit.h>
#include <whipple/state/exact_sum.h>
#include <whipple/state/velocity_gather.h>

#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace whipple
{
  namespace
  {
    using namespace projection;

    /// Voids pressed out of less than this share of a cell are round-off.
    constexpr double pressed_noticed = 1e-6;

    void
    check_covered(double elements, double left, double laid_down)
    {
      constexpr double tolerance = 1e-11;
      if (std::abs(elements - left - laid_down) <= tolerance * elements)
        return;
      std::ostringstream text;
      text << "projection onto cells: of " << elements << " g of elements " << left << " g lie beyond the domain and "
           << laid_down << " g found cells; the mesh does not cover the rest";
      throw ConservationError(text.str());
    }
  } // namespace

  template <>
  LaidDown<2>
  to_eulerian<2>(MPI_Comm communicator, const Lattice<2> &lattice, const CellPacketLayout<2> &layout,
                 const std::vector<Element<2>> &elements, const Representation &representation, const FlatMesh<2> &mesh,
                 const Halo<2> &halo, const LayDownLimits &limits, const Boundaries<2> &boundaries, KineticLoss loss,
                 State<2> &state)
  {
    LaidDown<2>        result;
    ConservedTotals<2> left;
    double             folded = 0, mirrored = 0;
    Deposit            deposit(lattice, layout, mesh, state);
    for (const Element<2> &element : elements) // of all ranks: what is counted here is the same on all
      {
        const ElementPieces pieces = representation.pieces_of(lattice.symmetry, layout, element);
        deposit.lay_down(element, pieces);
        result.elements += totals_of<2>(layout, element);
        left += beyond_domain(lattice, layout, element, pieces);
        folded += pieces.folded;
        mirrored += pieces.mirrored_corners;
      }
    result.bookings.leave(laid_down::beyond, left);
    result.bookings.note(laid_down::folded, folded, 1., "times");
    result.bookings.note(laid_down::mirrored, mirrored, 1., "times");

    const double       found  = deposit.owned_mass();
    const SpreadReport spread = spread_excess(communicator, mesh, halo, state, limits.closed, deposit.laid());
    result.bookings.enter(laid_down::spread, {.event = spread.moved});
    if (limits.sliver > 0)
      result.bookings.enter(laid_down::slivers,
                            {.event = gather_slivers(communicator, mesh, halo, state, limits.sliver, deposit.laid())});

    const CornerVelocities<2> corners = deposit.finish();
    std::array<double, 3>     sums{found, 0., 0.};
    ExactSum                  pressed;
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const Squeeze squeeze = squeeze_overfull<2>(state, cell);
        if (cell < mesh.n_owned)
          {
            pressed.add(squeeze.pores);
            sums[1] += squeeze.solid;
            sums[2] += squeeze.pores > pressed_noticed * state.volume[cell];
          }
      }
    result.bookings.enter(laid_down::projection,
                          sum_over_ranks(gather_velocities<2>(mesh, boundaries, corners, loss, state), communicator));
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), 3, MPI_DOUBLE, MPI_SUM, communicator);
    ExactSum::reduce({&pressed, 1}, communicator);
    result.pores_squeezed   = pressed.value() + spread.pores_squeezed;
    result.solid_compressed = sums[1];
    result.bookings.note(laid_down::pressed, sums[2] + (spread.pores_squeezed > 0 ? spread.moved.number : 0.),
                         result.pores_squeezed, "cm^3");
    check_covered(result.elements.mass, left.mass, sums[0]);
    return result;
  }

  template <>
  std::vector<CellKey>
  touched_cells<2>(const Lattice<2> &lattice, const std::vector<Element<2>> &elements, int level)
  {
    const int         extent = lattice.extent(level);
    const double      edge   = extent * lattice.spacing;
    std::set<CellKey> touched;
    for (const Element<2> &element : elements)
      for (const Triangle &triangle : bisect(mirrored(lattice.symmetry, element.position), {}).triangle)
        {
          Vector<2> lower, upper;
          bounds({&triangle, 1}, lower, upper);
          LatticePoint<2> first, last;
          for (int d = 0; d < 2; ++d)
            {
              const double end = lattice.roots[d] * double(1 << level) - 1.;
              first[d] = static_cast<int>(std::clamp(std::floor((lower[d] - lattice.origin[d]) / edge) - 1., 0., end));
              last[d]  = static_cast<int>(std::clamp(std::floor((upper[d] - lattice.origin[d]) / edge) + 1., 0., end));
            }
          for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i)
              {
                const LatticePoint<2> point{{i * extent, j * extent}};
                Vector<2>             a, b;
                CellTree<2>::box(lattice, level, point, a, b);
                if (moments(lattice.symmetry, clip(triangle, a, b)).volume > 0)
                  touched.insert(make_key<2>(level, point));
              }
        }
    return {touched.begin(), touched.end()};
  }
} // namespace whipple
