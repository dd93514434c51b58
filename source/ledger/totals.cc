// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/ledger/exact_sum.h>
#include <whipple/ledger/totals.h>
#include <whipple/projection/cell_totals.h>

#include <array>

namespace whipple
{
  namespace
  {
    /// Amounts being summed: mass, internal, kinetic, momentum.
    template <int dim>
    struct Sums
    {
      std::array<ExactSum, 3 + dim> sum;

      void
      add_corner(double mass, const Vector<dim> &velocity)
      {
        double square = 0;
        for (int d = 0; d < dim; ++d)
          {
            square += velocity[d] * velocity[d];
            sum[3 + d].add(mass * velocity[d]);
          }
        sum[2].add(0.5 * mass * square);
      }

      ConservedTotals<dim>
      amounts() const
      {
        ConservedTotals<dim> result;
        result.mass            = sum[0].value();
        result.internal_energy = sum[1].value();
        result.kinetic_energy  = sum[2].value();
        for (int d = 0; d < dim; ++d)
          result.momentum[d] = sum[3 + d].value();
        return result;
      }
    };

    template <int dim>
    Vector<dim>
    node_velocity(const State<dim> &state, Index n)
    {
      Vector<dim> v;
      for (int d = 0; d < dim; ++d)
        v[d] = state.velocity[d][n];
      return v;
    }
  } // namespace

  template <int dim>
  ConservedTotals<dim>
  totals(const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator)
  {
    Sums<dim> sums;
    for (const MaterialState &m : state.material)
      for (Index c = 0; c < mesh.n_owned; ++c)
        if (m.mass[c] != 0.)
          {
            sums.sum[0].add(m.mass[c]);
            sums.sum[1].add(m.mass[c] * m.energy[c]);
          }
    // a node belongs to the rank that owns the first cell around it
    for (Index n = 0; n < mesh.n_nodes; ++n)
      if (state.node_mass[n] != 0. &&
          mesh.node_corner[mesh.node_corner_begin[n]] < mesh.n_owned * FlatMesh<dim>::corners)
        sums.add_corner(state.node_mass[n], node_velocity(state, n));
    ExactSum::reduce(sums.sum, communicator);
    return sums.amounts();
  }

  template <int dim>
  ConservedTotals<dim>
  cell_sum(const FlatMesh<dim> &mesh, const State<dim> &state, const std::function<bool(Index cell)> &belongs,
           MPI_Comm communicator)
  {
    const CornerVelocities<dim> velocities = corner_velocities(mesh, state);
    Sums<dim>                   sums;
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (belongs(c))
        {
          const ConservedTotals<dim> cell = cell_totals<dim>(state, velocities, c);
          sums.sum[0].add(cell.mass);
          sums.sum[1].add(cell.internal_energy);
          sums.sum[2].add(cell.kinetic_energy);
          for (int d = 0; d < dim; ++d)
            sums.sum[3 + d].add(cell.momentum[d]);
        }
    ExactSum::reduce(sums.sum, communicator);
    return sums.amounts();
  }

  template <int dim>
  std::vector<ConservedTotals<dim>>
  body_totals(const FlatMesh<dim> &mesh, const State<dim> &state, const std::vector<int> &tag,
              const std::vector<Index> &material, MPI_Comm communicator)
  {
    constexpr int          corners  = FlatMesh<dim>::corners;
    const std::size_t      n_bodies = tag.size();
    std::vector<Sums<dim>> sums(n_bodies);
    std::vector<double>    part(n_bodies);
    for (Index c = 0; c < mesh.n_owned; ++c)
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material_state = state.material[m];
          const double         mass           = material_state.mass[c];
          if (mass == 0.)
            continue;
          double rest = 1.;
          for (std::size_t b = 0; b < n_bodies; ++b)
            {
              part[b] =
                  tag[b] >= 0 && material[b] == static_cast<Index>(m) ? material_state.fields[tag[b]].value[c] : 0.;
              rest -= part[b];
            }
          for (std::size_t b = 0; b < n_bodies; ++b)
            {
              const double share = tag[b] < 0 && material[b] == static_cast<Index>(m) ? rest : part[b];
              if (share == 0.)
                continue;
              sums[b].sum[0].add(share * mass);
              sums[b].sum[1].add(share * mass * material_state.energy[c]);
              for (int k = 0; k < corners; ++k)
                sums[b].add_corner(share * mass * state.corner_weight[c * corners + k],
                                   node_velocity(state, mesh.cell_node[c * corners + k]));
            }
        }
    std::vector<ConservedTotals<dim>> result;
    for (Sums<dim> &s : sums)
      {
        ExactSum::reduce(s.sum, communicator);
        result.push_back(s.amounts());
      }
    return result;
  }

  template ConservedTotals<2>
  totals(const FlatMesh<2> &, const State<2> &, MPI_Comm);
  template ConservedTotals<2>
  cell_sum(const FlatMesh<2> &, const State<2> &, const std::function<bool(Index)> &, MPI_Comm);
  template std::vector<ConservedTotals<2>>
  body_totals(const FlatMesh<2> &, const State<2> &, const std::vector<int> &, const std::vector<Index> &, MPI_Comm);
} // namespace whipple
