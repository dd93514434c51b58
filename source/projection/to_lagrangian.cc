// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/to_lagrangian.h>
#include <whipple/state/copy_cell.h>
#include <whipple/state/velocity_gather.h>

#include <whipple/error.h>
#include <whipple/projection/cell_totals.h>
#include <whipple/state/packet_layout.h>
#include <whipple/state/round_off_share.h>

#include <sstream>
#include <unordered_map>

namespace whipple
{
  namespace
  {
    template <int dim>
    std::string
    place(const FlatMesh<dim> &mesh, Index cell)
    {
      std::ostringstream text;
      text << "cell at (";
      for (int d = 0; d < dim; ++d)
        text << (d ? ", " : "") << mesh.lower[d][cell] + 0.5 * mesh.size[cell];
      text << ") cm";
      return text.str();
    }

    /// Volume fraction of all materials in a cell; 1 where it is so to round-off.
    template <int dim>
    double
    fill_fraction(const State<dim> &state, Index cell)
    {
      double filled = 0;
      for (const MaterialState &material : state.material)
        filled += material.volume[cell];
      constexpr double round_off = 1e-12;
      const double     fraction  = filled / state.volume[cell];
      return fraction > 1. - round_off && fraction < 1. + round_off ? 1. : fraction;
    }

    /// Fold open void into the voids of the materials; gamma stays.
    template <int dim>
    void
    fold_open_void(State<dim> &state, Index cell, double fraction)
    {
      if (fraction == 1.)
        return;
      for (MaterialState &material : state.material)
        if (material.volume[cell] > 0)
          {
            material.volume[cell] /= fraction;
            material.density[cell] *= fraction;
            if (material.has_voids())
              material.void_fraction[cell] = 1. - (1. - material.void_fraction[cell]) * fraction;
          }
    }

    template <int dim>
    void
    check_fraction(const FlatMesh<dim> &mesh, const State<dim> &state, Index cell, double fraction,
                   std::span<const std::string> names)
    {
      if (!(fraction > 0) || fraction > 1. + round_off_share)
        {
          std::ostringstream text;
          text << "projection onto elements: volume fraction " << fraction << " in the " << place(mesh, cell);
          throw StateError(text.str());
        }
      if (fraction >= 1. - round_off_share) // full: the materials grow by what the cell lacks
        return;
      for (std::size_t m = 0; m < state.material.size(); ++m)
        if (state.material[m].volume[cell] > 0 && !state.material[m].has_voids())
          {
            std::ostringstream text;
            text << "projection onto elements: material '" << names[m] << "' cannot take up the open void ("
                 << 1. - fraction << " of the " << place(mesh, cell)
                 << "): a Lagrangian stage needs a void law in every material";
            throw StateError(text.str());
          }
    }

    template <int dim>
    ConservedTotals<dim>
    owned_totals(const FlatMesh<dim> &mesh, const State<dim> &state, const CornerVelocities<dim> &velocities)
    {
      ConservedTotals<dim> totals;
      for (Index cell = 0; cell < mesh.n_owned; ++cell)
        totals += cell_totals<dim>(state, velocities, cell);
      return totals;
    }
  } // namespace

  template <int dim>
  State<dim>
  to_lagrangian(const FlatMesh<dim> &cells, const State<dim> &eulerian, const FlatMesh<dim> &elements,
                const Boundaries<dim> &boundaries, KineticLoss loss, std::span<const std::string> names,
                TakenUp<dim> &taken_up)
  {
    constexpr int                      corners = 1 << dim;
    std::unordered_map<CellKey, Index> cell_of_key;
    for (Index cell = 0; cell < cells.n_cells; ++cell)
      cell_of_key.emplace(cells.key[cell], cell);

    const CornerVelocities<dim> source = corner_velocities<dim>(cells, eulerian);
    CornerVelocities<dim>       target(elements.n_cells);
    State<dim>                  state = empty_state_like<dim>(eulerian, elements);
    for (Index element = 0; element < elements.n_cells; ++element)
      {
        const bool is_owned = element < elements.n_owned;
        const auto found    = cell_of_key.find(elements.key[element]);
        if (found == cell_of_key.end())
          {
            if (is_owned)
              throw StateError("projection onto elements: no Eulerian cell for the " + place(elements, element));
            continue;
          }
        const Index  cell     = found->second;
        const double fraction = fill_fraction(eulerian, cell);
        if (is_owned)
          check_fraction(cells, eulerian, cell, fraction, names);
        copy_cell(eulerian, cell, state, element);
        if (fraction > 0)
          fold_open_void(state, element, fraction);
        for (int k = 0; k < corners; ++k)
          for (int d = 0; d < dim; ++d)
            {
              target.velocity[d][element * corners + k] = source.velocity[d][cell * corners + k];
              state.position[d][elements.cell_node[element * corners + k]] =
                  eulerian.position[d][cells.cell_node[cell * corners + k]];
            }
        target.kinetic_remainder[element] = source.kinetic_remainder[cell];
      }

    taken_up.before  = owned_totals(elements, state, target);
    taken_up.booking = gather_velocities<dim>(elements, boundaries, target, loss, state);
    taken_up.after   = owned_totals(elements, state, corner_velocities<dim>(elements, state));
    return state;
  }

  template State<2>
  to_lagrangian<2>(const FlatMesh<2> &, const State<2> &, const FlatMesh<2> &, const Boundaries<2> &, KineticLoss,
                   std::span<const std::string>, TakenUp<2> &);
} // namespace whipple
