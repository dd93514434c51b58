// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/hydro/solid_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace whipple
{
  namespace
  {
    /// Under which the books have the heat that went from one cell to another.
    constexpr const char *cause = "conducted heat";

    /// Explicit heat conduction between cells that share a face, doc/theory/heat_conduction.md.
    class ConductionPass : public EffectPass<2>
    {
    public:
      explicit ConductionPass(const EffectSetup<2> &setup)
        : mesh_(setup.mesh)
        , materials_(setup.materials)
        , share_(setup.parameter("Share of the stable step"))
        , true_density_(setup.mesh.n_cells)
        , material_temperature_(setup.mesh.n_cells)
        , melt_fraction_(setup.mesh.n_cells)
        , material_conductivity_(setup.mesh.n_cells)
        , temperature_(setup.mesh.n_cells)
        , conductivity_(setup.mesh.n_cells)
        , capacity_(setup.mesh.n_cells)
        , gained_(setup.mesh.n_owned)
      {
        for (int axis = 0; axis < 2; ++axis)
          heat_[axis].resize(setup.mesh.faces[axis].size());
        for (auto *array : {&conductance_, &difference_})
          array->resize(std::max(heat_[0].size(), heat_[1].size()));
      }

      bool
      changes_energy() const override
      {
        return true;
      }

      bool
      leaves_out_halo() const override
      {
        return true;
      }

      void
      advance(const EffectStep<2> &step) override
      {
        State<2> &state = step.state;
        evaluate_cells(state);
        for (int axis = 0; axis < 2; ++axis)
          find_fluxes(state, axis, step.dt);
        double moved = 0;
        for (Index cell = 0; cell < mesh_.n_owned; ++cell)
          {
            gained_[cell] = gain(cell);
            moved += std::max(gained_[cell], 0.);
          }
        step.books.convert(cause, moved);
        for (std::size_t m = 0; m < materials_.size(); ++m)
          if (materials_[m].conduction)
            {
              // all materials of a cell warm alike: energy goes by heat capacity
              const double         c = materials_[m].thermal->specific_heat();
              std::vector<double> &e = state.material[m].energy;
              for (Index cell = 0; cell < mesh_.n_owned; ++cell)
                if (state.material[m].mass[cell] > 0)
                  e[cell] += gained_[cell] * c / capacity_[cell];
            }
      }

      TimeStepLimit
      time_step(const State<2> &state) const override
      {
        TimeStepLimit limit{std::numeric_limits<double>::infinity(), "heat conduction", none};
        for (Index cell = 0; cell < mesh_.n_owned; ++cell)
          {
            double capacity = 0, conductivity = 0;
            for (std::size_t m = 0; m < materials_.size(); ++m)
              if (materials_[m].conduction)
                {
                  capacity += state.material[m].mass[cell] * materials_[m].thermal->specific_heat();
                  conductivity += materials_[m].conduction->reference_conductivity() *
                                  solid_volume(state.material[m], cell) / state.volume[cell];
                }
            // a face conducts at most twice as well as this cell: harmonic mean
            const double most = 2. * conductivity * area_over_distance_of_sides(state, cell);
            if (2. * share_ * capacity < limit.dt * most)
              limit = {2. * share_ * capacity / most, "heat conduction", cell};
          }
        return limit;
      }

    private:
      double
      distance(const State<2> &state, Index a, Index b) const
      {
        return std::hypot(state.position[0][a] - state.position[0][b], state.position[1][a] - state.position[1][b]);
      }

      static double
      solid_volume(const MaterialState &m, Index cell)
      {
        return (m.has_voids() ? 1. - m.void_fraction[cell] : 1.) * m.volume[cell];
      }

      /// Sum over the faces of a cell that have a cell behind.
      double
      area_over_distance_of_sides(const State<2> &state, Index cell) const
      {
        double sum = 0;
        for (int side = 0; side < 4; ++side)
          for (int s = 0; s < FlatMesh<2>::subfaces; ++s)
            {
              const Index face = mesh_.cell_face[side][cell * FlatMesh<2>::subfaces + s];
              if (face != none && mesh_.faces[side / 2].cell[0][face] != none &&
                  mesh_.faces[side / 2].cell[1][face] != none)
                sum += area_over_distance(state, side / 2, face);
            }
        return sum;
      }

      /// Temperature, conductivity and heat capacity of every cell: means over its materials.
      void
      evaluate_cells(const State<2> &state)
      {
        for (auto *array : {&temperature_, &conductivity_, &capacity_})
          std::fill(array->begin(), array->end(), 0.);
        for (std::size_t m = 0; m < materials_.size(); ++m)
          if (materials_[m].conduction)
            add_material(state, state.material[m], materials_[m]);
        for (Index cell = 0; cell < mesh_.n_cells; ++cell)
          temperature_[cell] = capacity_[cell] > 0 ? temperature_[cell] / capacity_[cell] : 0.;
      }

      void
      add_material(const State<2> &state, const MaterialState &m, const Material &material)
      {
        solid_state::true_density(m.density, m.void_fraction, material.eos->reference_density(), true_density_);
        ThermalOutput output;
        output.temperature   = material_temperature_;
        output.melt_fraction = melt_fraction_;
        material.thermal->evaluate(true_density_, m.energy, output);
        material.conduction->evaluate(material_temperature_, melt_fraction_, material_conductivity_);
        const double specific_heat = material.thermal->specific_heat();
        for (Index c = 0; c < mesh_.n_cells; ++c)
          if (m.mass[c] > 0)
            {
              const double capacity = m.mass[c] * specific_heat;
              capacity_[c] += capacity;
              temperature_[c] += capacity * material_temperature_[c];
              conductivity_[c] += material_conductivity_[c] * solid_volume(m, c) / state.volume[c];
            }
      }

      /// Heat through all faces normal to one logical axis, k A (T_b - T_a) / d. The harmonic mean of the
      /// conductivities lets nothing through to open void; d is measured along the normal of the face.
      void
      find_fluxes(const State<2> &state, int axis, double dt)
      {
        const auto &faces = mesh_.faces[axis];
        for (Index f = 0; f < faces.size(); ++f)
          {
            conductance_[f] = difference_[f] = 0.;
            const Index a = faces.cell[0][f], b = faces.cell[1][f];
            if (a == none || b == none)
              continue;
            const double k_a = conductivity_[a], k_b = conductivity_[b];
            if (!(k_a > 0 && k_b > 0))
              continue;
            conductance_[f] = 2. * k_a * k_b / (k_a + k_b) * area_over_distance(state, axis, f);
            difference_[f]  = temperature_[b] - temperature_[a];
          }
        share_hanging_faces(axis);
        for (Index f = 0; f < faces.size(); ++f)
          heat_[axis][f] = dt * conductance_[f] * difference_[f];
      }

      double
      centre(const State<2> &state, int d, Index cell) const
      {
        double sum = 0;
        for (int k = 0; k < 4; ++k)
          sum += state.position[d][mesh_.cell_node[cell * 4 + k]];
        return 0.25 * sum;
      }

      /// Of a face between two cells; 0 if its ends have met.
      double
      area_over_distance(const State<2> &state, int axis, Index f) const
      {
        const auto  &faces = mesh_.faces[axis];
        const Index  a = faces.cell[0][f], b = faces.cell[1][f], p = faces.node[2 * f], q = faces.node[2 * f + 1];
        const double length = distance(state, p, q);
        const double area   = mesh_.symmetry == Symmetry::planar
                                  ? length
                                  : std::numbers::pi * length * (state.position[0][p] + state.position[0][q]);
        const double cross =
            (centre(state, 0, b) - centre(state, 0, a)) * (state.position[1][q] - state.position[1][p]) -
            (centre(state, 1, b) - centre(state, 1, a)) * (state.position[0][q] - state.position[0][p]);
        return length > 0 ? area * length / std::abs(cross) : 0.;
      }

      /// A face with a hanging node: the middle of the large cell lies across the middle of the face, not across those
      /// of its halves, so the mean temperature of the two small cells counts for both. Exact for a linear temperature.
      void
      share_hanging_faces(int axis)
      {
        for (Index cell = 0; cell < mesh_.n_cells; ++cell)
          for (int side = 2 * axis; side < 2 * axis + 2; ++side)
            {
              const Index *face = &mesh_.cell_face[side][cell * FlatMesh<2>::subfaces];
              if (face[0] == none || face[1] == none)
                continue;
              const double sum = conductance_[face[0]] + conductance_[face[1]];
              if (!(sum > 0))
                continue;
              const double mean =
                  (conductance_[face[0]] * difference_[face[0]] + conductance_[face[1]] * difference_[face[1]]) / sum;
              difference_[face[0]] = difference_[face[1]] = mean;
            }
      }

      /// Heat that a cell gains, its sides in fixed order: the same bits on any number of ranks.
      double
      gain(Index cell) const
      {
        double sum = 0;
        for (int side = 0; side < 4; ++side)
          for (int s = 0; s < FlatMesh<2>::subfaces; ++s)
            {
              const Index face = mesh_.cell_face[side][cell * FlatMesh<2>::subfaces + s];
              if (face != none)
                sum += side % 2 == 0 ? -heat_[side / 2][face] : heat_[side / 2][face];
            }
        return sum;
      }

      const FlatMesh<2>                 &mesh_;
      const std::vector<Material>       &materials_;
      double                             share_; ///< of the stable time step that is used
      std::vector<double>                true_density_, material_temperature_, melt_fraction_, material_conductivity_;
      std::vector<double>                temperature_;  ///< K
      std::vector<double>                conductivity_; ///< Mbar cm^2/(us K), of the cell with its voids
      std::vector<double>                capacity_;     ///< heat capacity of the cell, Mbar cm^3/K
      std::vector<double>                gained_;       ///< heat of the owned cells in this step, Mbar cm^3
      std::vector<double>                conductance_;  ///< of the faces of one axis, Mbar cm^3/(us K)
      std::vector<double>                difference_;   ///< of the temperatures across them, K
      std::array<std::vector<double>, 2> heat_; ///< through the faces of each axis, downwards along it, Mbar cm^3
    };

    /// Diffusion length / cell from which heat leaves its cell.
    constexpr double least_diffusion_cells = 0.5;

    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      double length = 0;
      for (const NamedMaterial &material : outlook.materials)
        if (const Material &m = material.model; m.conduction && m.thermal)
          length = std::max(length, std::sqrt(m.conduction->reference_conductivity() * outlook.joined_duration /
                                              (m.eos->reference_density() * m.thermal->specific_heat())));
      if (length == 0)
        return off_without_model("Conduction");
      const double cells = length / outlook.finest_cell;
      const bool   on    = cells > least_diffusion_cells;
      return {"", on, cells,
              "diffusion length in the " + rounded(outlook.joined_duration) + " us in which cells are joined / cell" +
                  (on ? ": heat crosses cells" : ": heat stays in its cell")};
    }

    const EffectRegistration<2> registration(
        30,
        {
            .name    = "heat conduction",
            .summary = "heat flows down the temperature gradient",
            .documentation =
                "Explicit, between cells that share a face; fragments that share none keep their heat. In 20 "
                "us heat diffuses 0.04 mm in aluminium, less than a cell of the shield case: off unless a "
                "scene lasts long or has thin layers. It limits the time step to a share of h^2/4 on square cells over "
                "the "
                "diffusivity, far above what sound allows on cells of more than a micrometre.",
            .family     = "Conduction",
            .parameters = {{"Share of the stable step",
                            "pure number",
                            "of the largest time step at which explicit conduction is stable on square cells; above "
                            "one half cells beside nearly empty ones may oscillate",
                            {.lower = 0., .upper = 1., .lower_excluded = true},
                            0.5}},
            .bookings   = {{BookingKind::converts, cause, "heat that went from one cell to another"}},
            .judge      = judge,
            .leave_out  = [](Material &material) { material.conduction = nullptr; },
        },
        [](const EffectSetup<2> &setup) { return std::make_unique<ConductionPass>(setup); });
  } // namespace
} // namespace whipple
