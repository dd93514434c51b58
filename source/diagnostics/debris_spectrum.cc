// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/debris_spectrum.h>
#include <whipple/ledger/exact_totals.h>
#include <whipple/mesh/collective.h>
#include <whipple/projection/cell_totals.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace whipple
{
  namespace
  {
    constexpr int most_bins = 64;

    /// Call visit(cell) with what each owned cell that holds material contains, and on the first rank with each part
    /// that waits.
    template <int dim, typename Visit>
    void
    for_each_cell(const FlatMesh<dim> &mesh, const State<dim> &state, const WaitingDebris<dim> *waiting,
                  MPI_Comm communicator, const Visit &visit)
    {
      int rank = 0;
      MPI_Comm_rank(communicator, &rank);
      if (waiting && rank == 0)
        for (const Waiting<dim> &part : waiting->parts)
          visit(totals_of(CellPacketLayout<dim>::of(state), part.element));
      const CornerVelocities<dim> velocities = corner_velocities(mesh, state);
      for (Index c = 0; c < mesh.n_owned; ++c)
        if (const ConservedTotals<dim> cell = cell_totals<dim>(state, velocities, c); cell.mass > 0)
          visit(cell);
    }
  } // namespace

  template <int dim>
  double
  flight_angle(const ConservedTotals<dim> &cell)
  {
    double across = 0;
    for (int d = 0; d < dim; ++d)
      if (d != flight_axis<dim>)
        across = std::hypot(across, cell.momentum[d]);
    return std::atan2(across, cell.momentum[flight_axis<dim>]) * 180. / std::numbers::pi;
  }

  template <int dim>
  double
  axial_velocity(const ConservedTotals<dim> &cell)
  {
    return cell.momentum[flight_axis<dim>] / cell.mass;
  }

  template <int dim>
  Spectrum<dim>
  spectrum(const FlatMesh<dim> &mesh, const State<dim> &state, std::vector<double> edges,
           const CellQuantity<dim> &quantity, MPI_Comm communicator, const WaitingDebris<dim> *waiting)
  {
    std::vector<ExactTotals<dim>> sums(edges.size() - 1);
    for_each_cell(mesh, state, waiting, communicator, [&](const ConservedTotals<dim> &cell) {
      const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, quantity(cell));
      sums[above - edges.begin() - 1].add(cell);
    });
    Spectrum<dim> result{std::move(edges), {}};
    for (ExactTotals<dim> &bin : sums)
      {
        ExactSum::reduce(bin.sum, communicator);
        result.bin.push_back(bin.amounts());
      }
    return result;
  }

  template <int dim>
  std::vector<double>
  velocity_edges(const FlatMesh<dim> &mesh, const State<dim> &state, double width, MPI_Comm communicator,
                 const WaitingDebris<dim> *waiting)
  {
    double fastest = 0, slowest = 0;
    for_each_cell(mesh, state, waiting, communicator, [&](const ConservedTotals<dim> &cell) {
      fastest = std::max(fastest, axial_velocity(cell));
      slowest = std::min(slowest, axial_velocity(cell));
    });
    fastest = max_over_ranks(fastest, communicator);
    slowest = -max_over_ranks(-slowest, communicator);
    double first, last;
    for (;; width *= 2.)
      {
        first = std::floor(slowest / width);
        last  = std::max(std::ceil(fastest / width), first + 1.);
        if (last - first <= most_bins)
          break;
      }
    std::vector<double> edges;
    for (double i = first; i <= last; ++i)
      edges.push_back(i * width);
    return edges;
  }

  std::vector<double>
  equal_edges(double low, double high, int bins)
  {
    std::vector<double> edges;
    for (int i = 0; i <= bins; ++i)
      edges.push_back(low + (high - low) * i / bins);
    return edges;
  }

  template double
  flight_angle(const ConservedTotals<2> &);
  template double
  axial_velocity(const ConservedTotals<2> &);
  template Spectrum<2>
  spectrum(const FlatMesh<2> &, const State<2> &, std::vector<double>, const CellQuantity<2> &, MPI_Comm,
           const WaitingDebris<2> *);
  template std::vector<double>
  velocity_edges(const FlatMesh<2> &, const State<2> &, double, MPI_Comm, const WaitingDebris<2> *);
} // namespace whipple
