// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/reference_cell.h>

#include <whipple/output/snapshot_vtu.h>

#include <tuple>

namespace whipple::snapshot_vtu
{
  namespace
  {
    template <int dim>
    using Patch = dealii::DataOutBase::Patch<dim, dim>;

    /// A patch a cell: components 0 .. dim-1 the velocity of its corners, then the fields.
    template <int dim>
    std::vector<Patch<dim>>
    patches_of(const Snapshot<dim> &snapshot)
    {
      constexpr int           corners = Snapshot<dim>::corners;
      std::vector<Patch<dim>> patches(snapshot.n_cells());
      for (std::size_t c = 0; c < patches.size(); ++c)
        {
          Patch<dim> &patch    = patches[c];
          patch.patch_index    = static_cast<unsigned int>(c);
          patch.n_subdivisions = 1;
          patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>();
          patch.data.reinit(dim + snapshot.fields.size(), corners);
          for (int k = 0; k < corners; ++k)
            {
              const Index node = snapshot.cell_node[c * corners + k];
              for (int d = 0; d < dim; ++d)
                {
                  patch.vertices[k][d] = snapshot.position[node * dim + d];
                  patch.data(d, k)     = static_cast<float>(snapshot.velocity[node * 3 + d]);
                }
              for (std::size_t f = 0; f < snapshot.fields.size(); ++f)
                patch.data(dim + f, k) = static_cast<float>(snapshot.fields[f].value[c]);
            }
        }
      return patches;
    }

    /// What deal.II's writers ask for.
    template <int dim>
    class Writer : public dealii::DataOutInterface<dim>
    {
    public:
      explicit Writer(const Snapshot<dim> &snapshot)
        : patches_(patches_of(snapshot))
        , names_(dim, "velocity [cm/us]")
      {
        for (const CellField &field : snapshot.fields)
          names_.push_back(field.unit == "1" ? field.name : field.name + " [" + field.unit + ']');
      }

    private:
      using Range = std::tuple<unsigned int, unsigned int, std::string,
                               dealii::DataComponentInterpretation::DataComponentInterpretation>;

      const std::vector<Patch<dim>> &
      get_patches() const override
      {
        return patches_;
      }
      std::vector<std::string>
      get_dataset_names() const override
      {
        return names_;
      }
      std::vector<Range>
      get_nonscalar_data_ranges() const override
      {
        return {Range(0, dim - 1, names_.front(), dealii::DataComponentInterpretation::component_is_part_of_vector)};
      }

      std::vector<Patch<dim>>  patches_;
      std::vector<std::string> names_;
    };
  } // namespace

  template <int dim>
  void
  write(const Snapshot<dim> &snapshot, const std::string &path, MPI_Comm communicator)
  {
    Writer<dim>                   writer(snapshot);
    dealii::DataOutBase::VtkFlags flags;
    flags.time                = snapshot.time;
    flags.print_date_and_time = false; // the same run writes the same bytes
    writer.set_flags(flags);
    writer.write_vtu_in_parallel(path, communicator);
  }

  template void
  write<2>(const Snapshot<2> &, const std::string &, MPI_Comm);
} // namespace whipple::snapshot_vtu
