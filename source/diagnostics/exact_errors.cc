// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/exact_errors.h>
#include <whipple/initial/exact_means.h>
#include <whipple/mesh/cell_corners.h>
#include <whipple/mesh/collective.h>
#include <whipple/state/exact_sum.h>

#include <array>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Error norms of one quantity being gathered.
    struct Norms
    {
      std::array<ExactSum, 4> sum; ///< V, |e| V, e^2 V, |exact| V
      double                  largest = 0;

      /// Nothing happens where the exact solution says nothing.
      void
      add(double error, double exact, double volume)
      {
        if (std::isnan(error))
          return;
        sum[0].add(volume);
        sum[1].add(std::abs(error) * volume);
        sum[2].add(error * error * volume);
        sum[3].add(std::abs(exact) * volume);
        largest = std::max(largest, std::abs(error));
      }

      std::optional<summary::Error>
      norms(MPI_Comm communicator)
      {
        ExactSum::reduce(sum, communicator);
        const double top = max_over_ranks(largest, communicator), volume = sum[0].value();
        if (!(volume > 0))
          return std::nullopt;
        return summary::Error{sum[1].value() / volume, std::sqrt(sum[2].value() / volume), top,
                              sum[3].value() / volume};
      }
    };

    /// What the materials of a cell hold together.
    struct CellValue
    {
      double mass = 0, volume = 0, pressure_volume = 0, energy = 0;
    };

    template <int dim>
    CellValue
    cell_value(const State<dim> &state, const Derived &derived, Index c)
    {
      CellValue value;
      for (std::size_t i = 0; i < state.material.size(); ++i)
        {
          const MaterialState &m = state.material[i];
          value.mass += m.mass[c];
          value.volume += m.volume[c];
          value.pressure_volume += m.volume[c] * derived.material[i].pressure[c];
          value.energy += m.mass[c] * m.energy[c];
        }
      return value;
    }

    /// Errors of the nodes at the corners of a cell.
    template <int dim>
    void
    add_velocities(const exact::ExactSolution<dim> &solution, const FlatMesh<dim> &mesh, const State<dim> &state,
                   const CornerVectors<dim> &x, Index c, Norms &norms)
    {
      const CornerValues<dim> corner = corner_volume<dim>(mesh.symmetry, x);
      for (int k = 0; k < FlatMesh<dim>::corners; ++k)
        {
          const Index       n        = mesh.cell_node[c * FlatMesh<dim>::corners + k];
          const Vector<dim> exact    = solution.at({{x[0][k], x[1][k]}}, state.time).velocity;
          double            square_2 = 0, size_2 = 0;
          for (int d = 0; d < dim; ++d)
            {
              square_2 += (state.velocity[d][n] - exact[d]) * (state.velocity[d][n] - exact[d]);
              size_2 += exact[d] * exact[d];
            }
          norms.add(std::sqrt(square_2), std::sqrt(size_2), corner[k]);
        }
    }
  } // namespace

  template <int dim>
  std::map<std::string, summary::Error>
  exact_errors(const exact::ExactSolution<dim> &solution, const FlatMesh<dim> &mesh, const State<dim> &state,
               const Derived &derived, MPI_Comm communicator)
  {
    constexpr double             round_off = 1e-10;
    std::map<std::string, Norms> norms{{"density", {}}, {"energy", {}}, {"pressure", {}}, {"velocity", {}}};
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        const CornerVectors<dim> x = cell_corners(mesh, state.position, c);
        if (!solution.counts(CellShape<dim>::middle(x), state.time))
          continue;
        const double          volume = state.volume[c];
        const ExactMeans<dim> exact =
            exact_means<dim>(solution, volume_points<dim>(solution, mesh.symmetry, x, state.time), state.time);
        const CellValue value = cell_value(state, derived, c);
        if (value.mass > 0 || exact.density > 0)
          norms["density"].add(value.mass / volume - exact.density, exact.density, volume);
        if (!(value.volume > volume * (1. - round_off)))
          continue;
        norms["pressure"].add(value.pressure_volume / value.volume - exact.pressure, exact.pressure, volume);
        norms["energy"].add(value.energy / value.mass - exact.energy, exact.energy, volume);
        add_velocities(solution, mesh, state, x, c, norms["velocity"]);
      }
    std::map<std::string, summary::Error> result;
    for (auto &[name, quantity] : norms)
      if (const auto error = quantity.norms(communicator))
        result[name] = *error;
    return result;
  }

  template std::map<std::string, summary::Error>
  exact_errors(const exact::ExactSolution<2> &, const FlatMesh<2> &, const State<2> &, const Derived &, MPI_Comm);
} // namespace whipple
