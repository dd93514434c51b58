// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/refinement/refinement_criterion.h>

#include <cmath>

namespace whipple
{
  namespace
  {
    constexpr int most_levels = 12;

    /// Material gives up levels where the gradient of one field is small: where |grad q| h, with h the edge of the
    /// finest cells, is less than a share of the largest |q| in the scene. The gradient is the largest difference to a
    /// face neighbour over the distance of the centres. Cells with open void, or a neighbour with any, give up nothing.
    class GradientCriterion : public RefinementCriterion
    {
    public:
      GradientCriterion(std::string field, int levels, double change)
        : field_(std::move(field))
        , levels_(levels)
        , change_(change)
      {
      }

      std::vector<int>
      spare_levels(const CellsToJudge &cells) const override
      {
        const FlatMesh<2>        &mesh = cells.mesh;
        std::vector<double>       value(mesh.n_cells);
        std::vector<std::uint8_t> full(mesh.n_cells);
        double                    largest = 0;
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            value[c] = mean(cells, c, full[c]);
            if (c < mesh.n_owned)
              largest = std::max(largest, std::abs(value[c]));
          }
        MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, cells.communicator);

        std::vector<double> steepest(mesh.n_owned, 0.);
        for (const FlatFaces<2> &faces : mesh.faces)
          for (Index f = 0; f < faces.size(); ++f)
            for (int s = 0; s < 2; ++s)
              {
                const Index c = faces.cell[s][f], other = faces.cell[1 - s][f];
                if (c == none || c >= mesh.n_owned || (other == none && faces.side[f] >= 0))
                  continue; // across a side of the domain lies nothing, or the mirror image
                steepest[c] = other == none || !full[c] || !full[other]
                                  ? HUGE_VAL
                                  : std::max(steepest[c], std::abs(value[other] - value[c]) * 2. /
                                                              (mesh.size[c] + mesh.size[other]));
              }
        std::vector<int> spare(mesh.n_owned);
        for (Index c = 0; c < mesh.n_owned; ++c)
          {
            const double change = largest > 0 ? steepest[c] * cells.finest_cell / largest : 0.;
            spare[c] = full[c] && std::isfinite(steepest[c]) ? levels_of_change(change, change_, levels_) : 0;
          }
        return spare;
      }

      int
      of_uniform_matter() const override
      {
        return levels_;
      }

      std::pair<std::string, std::string>
      carried_field() const override
      {
        return is_always_there(field_) ? std::pair<std::string, std::string>() : std::pair("Gradient field", field_);
      }

      /// Whether a state has this field. The others are carried by effects.
      static bool
      is_always_there(const std::string &field)
      {
        return field == "density" || field == "pressure" || field == "speed" || field == "specific internal energy" ||
               field == "void fraction";
      }

    private:
      /// Mean over a cell and whether it is full. @throws StateError if no material carries the field
      double
      mean(const CellsToJudge &cells, Index c, std::uint8_t &full) const
      {
        constexpr double round_off = 1e-9;
        const State<2>  &state     = cells.state;
        double           volume = 0, mass = 0, sum = 0;
        for (std::size_t i = 0; i < state.material.size(); ++i)
          {
            const MaterialState &m = state.material[i];
            volume += m.volume[c];
            mass += m.mass[c];
            if (field_ == "pressure")
              sum += m.volume[c] * cells.derived.material[i].pressure[c];
            else if (field_ == "void fraction")
              sum += m.has_voids() ? m.volume[c] * m.void_fraction[c] : 0.;
            else if (field_ == "specific internal energy")
              sum += m.mass[c] * m.energy[c];
            else if (!is_always_there(field_))
              sum += m.mass[c] * carried(m)[c];
          }
        full = volume > (1. - round_off) * state.volume[c];
        if (field_ == "density")
          return mass / state.volume[c];
        if (field_ == "speed")
          return speed(cells, c);
        const double over = field_ == "pressure" || field_ == "void fraction" ? volume : mass;
        return over > 0 ? sum / over : 0.;
      }

      static double
      speed(const CellsToJudge &cells, Index c)
      {
        double square = 0;
        for (int d = 0; d < 2; ++d)
          {
            double sum = 0;
            for (int k = 0; k < FlatMesh<2>::corners; ++k)
              sum += cells.state.velocity[d][cells.mesh.cell_node[c * FlatMesh<2>::corners + k]];
            square += sum * sum;
          }
        return std::sqrt(square) / FlatMesh<2>::corners;
      }

      const std::vector<double> &
      carried(const MaterialState &material) const
      {
        for (const Field &field : material.fields)
          if (field.description.name == field_)
            return field.value;
        throw StateError("refinement by the gradient of '" + field_ + "': no effect of the scene carries it");
      }

      std::string field_;
      int         levels_; ///< at most
      double      change_; ///< over a finest cell, as a part of the largest value
    };

    const RefinementCriterionRegistration
        registration("gradient",
                     {{{"Gradient field", "none",
                        "none | a field whose gradient decides where material gives up levels: density, pressure, "
                        "speed, specific internal energy, void fraction, or one that an effect carries"},
                       {"Gradient levels", "1", "levels that material gives up at most where that gradient is small"},
                       {"Gradient change", "1 %",
                        "change of the field over a finest cell, as a part of its largest value, up to which it is"}},
                      [](const SectionInput &input) -> std::shared_ptr<const RefinementCriterion> {
                        const std::string field  = input.text("Gradient field");
                        const int         levels = input.integer("Gradient levels", 1, most_levels);
                        const double      change = input.number("Gradient change", 1e-9, 1);
                        return field == "none" ? nullptr : std::make_shared<GradientCriterion>(field, levels, change);
                      }});
  } // namespace
} // namespace whipple
