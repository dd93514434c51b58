// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/flat_builder.h>
#include <whipple/output/snapshot.h>

#include <utility>

namespace whipple
{
  namespace
  {
    template <int dim>
    std::vector<Index>
    shown_cells(const FlatMesh<dim> &mesh, const State<dim> &state, bool empty_cells)
    {
      std::vector<Index> cells;
      for (Index c = 0; c < mesh.n_owned; ++c)
        {
          double mass = 0;
          for (const MaterialState &material : state.material)
            mass += material.mass[c];
          if (empty_cells || mass > 0)
            cells.push_back(c);
        }
      return cells;
    }

    /// Nodes in the order the cells first use them.
    template <int dim>
    void
    add_geometry(Snapshot<dim> &snapshot, const FlatMesh<dim> &mesh, const State<dim> &state,
                 const std::vector<Index> &cells)
    {
      constexpr int      corners = FlatMesh<dim>::corners;
      std::vector<Index> new_number(mesh.n_nodes, none);
      Index              n_nodes = 0;
      for (const Index c : cells)
        for (int k = 0; k < corners; ++k)
          {
            const Index node = mesh.cell_node[c * corners + k];
            if (new_number[node] == none)
              {
                new_number[node] = n_nodes++;
                for (int d = 0; d < dim; ++d)
                  snapshot.position.push_back(state.position[d][node]);
                for (int d = 0; d < 3; ++d)
                  snapshot.velocity.push_back(d < dim ? state.velocity[d][node] : 0.);
              }
            snapshot.cell_node.push_back(new_number[node]);
          }
    }

    template <typename Function>
    CellField
    cell_field(std::string name, std::string unit, const std::vector<Index> &cells, const Function &value_of)
    {
      CellField field{std::move(name), std::move(unit), {}};
      field.value.reserve(cells.size());
      for (const Index c : cells)
        field.value.push_back(value_of(c));
      return field;
    }

    template <int dim>
    void
    add_cell_fields(std::vector<CellField> &fields, const FlatMesh<dim> &mesh, const State<dim> &state,
                    const Derived &derived, const std::vector<Index> &cells, int rank)
    {
      const auto mean = [&state](auto &&extensive) {
        return [&state, extensive](Index c) {
          double sum = 0;
          for (std::size_t m = 0; m < state.material.size(); ++m)
            sum += extensive(m, c);
          return sum / state.volume[c];
        };
      };
      const auto mass     = [&](std::size_t m, Index c) { return state.material[m].mass[c]; };
      const auto pressure = [&](std::size_t m, Index c) {
        return state.material[m].volume[c] * derived.material[m].pressure[c];
      };
      const auto solid = [&](std::size_t i, Index c) {
        const MaterialState &m = state.material[i];
        return m.volume[c] * (m.has_voids() ? 1. - m.void_fraction[c] : 1.);
      };
      fields.push_back(cell_field("density", "g/cm^3", cells, mean(mass)));
      fields.push_back(cell_field("pressure", "Mbar", cells, mean(pressure)));
      fields.push_back(cell_field("solid fraction", "1", cells, mean(solid)));
      fields.push_back(cell_field("level", "1", cells, [&mesh](Index c) { return mesh.level[c]; }));
      fields.push_back(cell_field("rank", "1", cells, [rank](Index) { return rank; }));
    }

    template <int dim>
    void
    add_material_fields(std::vector<CellField> &fields, const State<dim> &state, const MaterialState &material,
                        const std::vector<double> &pressure, const std::string &name, const std::vector<Index> &cells)
    {
      const auto add = [&](const std::string &what, const std::string &unit, const auto &value_of) {
        fields.push_back(cell_field(name + ' ' + what, unit, cells, value_of));
      };
      const auto entry = [](const std::vector<double> &values) { return [&values](Index c) { return values[c]; }; };

      add("volume fraction", "1", [&](Index c) { return material.volume[c] / state.volume[c]; });
      add("density", "g/cm^3", entry(material.density));
      add("true density", "g/cm^3", [&material](Index c) {
        return material.has_voids() ? material.density[c] / (1. - material.void_fraction[c]) : material.density[c];
      });
      add("pressure", "Mbar", entry(pressure));
      add("energy", "Mbar cm^3/g", entry(material.energy));
      if (material.has_voids())
        add("void fraction", "1", entry(material.void_fraction));
      for (const Field &field : material.fields)
        add(field.description.name, field.description.unit, entry(field.value));
    }

    template <int dim>
    void
    add_identity(Snapshot<dim> &snapshot, const FlatMesh<dim> &mesh, const State<dim> &state,
                 const std::vector<std::string> &material_names, const std::vector<Index> &cells)
    {
      for (int d = 0; d < dim; ++d)
        snapshot.fields.push_back(cell_field("lattice point " + std::to_string(d), "1", cells,
                                             [&mesh, d](Index c) { return key_point<dim>(mesh.key[c])[d]; }));
      snapshot.fields.push_back(cell_field("volume", "cm^3", cells, [&](Index c) { return state.volume[c]; }));
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material = state.material[m];
          snapshot.fields.push_back(
              cell_field(material_names[m] + " volume", "cm^3", cells, [&](Index c) { return material.volume[c]; }));
          snapshot.fields.push_back(
              cell_field(material_names[m] + " mass", "g", cells, [&](Index c) { return material.mass[c]; }));
        }
    }
  } // namespace

  template <int dim>
  std::vector<CellField>
  fields_of_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                  const std::vector<std::string> &material_names, const ExtraFields<dim> &extra,
                  const std::vector<Index> &cells, int rank)
  {
    std::vector<CellField> fields;
    add_cell_fields(fields, mesh, state, derived, cells, rank);
    for (std::size_t m = 0; m < state.material.size(); ++m)
      add_material_fields(fields, state, state.material[m], derived.material[m].pressure, material_names[m], cells);
    if (extra)
      for (CellField &field : extra(state, cells))
        fields.push_back(std::move(field));
    return fields;
  }

  template <int dim>
  std::vector<std::int32_t>
  walked_cells(const Snapshot<dim> &snapshot, std::uint64_t first_node)
  {
    constexpr std::size_t     corners = Snapshot<dim>::corners;
    std::vector<std::int32_t> nodes(snapshot.cell_node.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes[i] = static_cast<std::int32_t>(first_node) +
                 snapshot.cell_node[i - i % corners + Snapshot<dim>::walk[i % corners]];
    return nodes;
  }

  template <int dim>
  Snapshot<dim>
  take_snapshot(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                const std::vector<std::string> &material_names, const ExtraFields<dim> &extra,
                const SnapshotOptions &options)
  {
    Snapshot<dim> snapshot;
    snapshot.time                  = state.time;
    const std::vector<Index> cells = shown_cells(mesh, state, options.empty_cells);
    add_geometry(snapshot, mesh, state, cells);
    snapshot.fields = fields_of_cells(mesh, state, derived, material_names, extra, cells, options.rank);
    if (options.everything)
      add_identity(snapshot, mesh, state, material_names, cells);
    return snapshot;
  }

  template std::vector<CellField>
  fields_of_cells<2>(const FlatMesh<2> &, const State<2> &, const Derived &, const std::vector<std::string> &,
                     const ExtraFields<2> &, const std::vector<Index> &, int);
  template std::vector<std::int32_t>
  walked_cells(const Snapshot<2> &, std::uint64_t);
  template Snapshot<2>
  take_snapshot<2>(const FlatMesh<2> &, const State<2> &, const Derived &, const std::vector<std::string> &,
                   const ExtraFields<2> &, const SnapshotOptions &);
} // namespace whipple
