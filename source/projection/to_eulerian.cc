// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/to_eulerian.h>

#include <whipple/error.h>
#include <whipple/projection/deposit.h>

#include <cmath>
#include <set>
#include <sstream>

namespace whipple
{
  namespace
  {
    using namespace projection;

    /// Add up over the ranks what each has counted over its owned cells.
    void
    sum_over_ranks(MPI_Comm communicator, std::vector<double *> values)
    {
      std::vector<double> buffer;
      for (const double *value : values)
        buffer.push_back(*value);
      MPI_Allreduce(MPI_IN_PLACE, buffer.data(), static_cast<int>(buffer.size()), MPI_DOUBLE, MPI_SUM, communicator);
      for (std::size_t i = 0; i < values.size(); ++i)
        *values[i] = buffer[i];
    }

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
  ToEulerianReport<2>
  to_eulerian<2>(MPI_Comm communicator, const Lattice<2> &lattice, const CellPacketLayout<2> &layout,
                 const std::vector<Element<2>> &elements, Representation representation, const FlatMesh<2> &mesh,
                 const Halo<2> &halo, const LayDownLimits &limits, const Boundaries<2> &boundaries, KineticLoss loss,
                 State<2> &state)
  {
    ToEulerianReport<2> report;
    Deposit             deposit(lattice, layout, mesh, state);
    for (const Element<2> &element : elements)
      {
        const ElementPieces pieces = pieces_of(lattice.symmetry, layout, element, representation);
        deposit.lay_down(element, pieces);
        report.elements += totals_of<2>(layout, element);
        report.left_domain += beyond_domain(lattice, layout, element, pieces);
        report.folded_elements += pieces.folded;
        report.mirrored_corners += pieces.mirrored_corners;
      }

    double laid_down = deposit.owned_mass();
    report.spread    = spread_excess(communicator, mesh, halo, state, limits.closed, deposit.laid());
    if (limits.sliver > 0)
      report.slivers = gather_slivers(communicator, mesh, halo, state, limits.sliver, deposit.laid());

    const CornerVelocities<2> corners = deposit.finish();
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const Squeeze squeeze = squeeze_overfull<2>(state, cell);
        if (cell < mesh.n_owned)
          {
            report.pores_squeezed += squeeze.pores;
            report.solid_compressed += squeeze.solid;
          }
      }
    const GatherReport<2> gathered = gather_velocities<2>(mesh, boundaries, corners, loss, state);
    report.kinetic_loss            = gathered.kinetic_loss;
    report.wall_impulse            = gathered.wall_impulse;

    sum_over_ranks(communicator, {&report.kinetic_loss, &report.pores_squeezed, &report.solid_compressed,
                                  &report.wall_impulse[0], &report.wall_impulse[1], &laid_down});
    report.pores_squeezed += report.spread.pores_squeezed;
    check_covered(report.elements.mass, report.left_domain.mass, laid_down);
    return report;
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
