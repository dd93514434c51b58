// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/refinement/refinement_criterion.h>
#include <whipple/refinement/smoothness.h>

namespace whipple
{
  namespace
  {
    constexpr int most_levels = 12;

    /// Material gives up levels where density, pressure and momentum density hardly change over a cell
    /// (doc/theory/refinement.md, "Which level where").
    class SmoothCriterion : public RefinementCriterion
    {
    public:
      SmoothCriterion(int levels, double change)
        : levels_(levels)
        , change_(change)
      {
      }

      std::vector<int>
      spare_levels(const CellsToJudge &cells) const override
      {
        const std::vector<double> change =
            change_over_cells(cells.mesh, cells.state, cells.derived, cells.boundaries, cells.communicator);
        std::vector<int> spare(change.size());
        for (std::size_t c = 0; c < change.size(); ++c)
          // a cell twice as large sees twice the change
          spare[c] = levels_of_change(change[c] * cells.finest_cell / cells.mesh.size[c], change_, levels_);
        return spare;
      }

      int
      of_uniform_matter() const override
      {
        return levels_;
      }

    private:
      int    levels_; ///< at most
      double change_; ///< as a part of the largest value
    };

    const RefinementCriterionRegistration registration(
        "smooth", {{{"Smooth levels", "0", "levels that material gives up where its state hardly changes over a cell"},
                    {"Smooth change", "1 %",
                     "change of density, pressure, momentum density over a cell, as a part of the largest in the "
                     "scene, that is hardly one"}},
                   [](const SectionInput &input) -> std::shared_ptr<const RefinementCriterion> {
                     const int    levels = input.integer("Smooth levels", 0, most_levels);
                     const double change = input.number("Smooth change", 1e-9, 1);
                     return levels > 0 ? std::make_shared<SmoothCriterion>(levels, change) : nullptr;
                   }});
  } // namespace
} // namespace whipple
