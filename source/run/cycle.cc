// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/free_flight.h>
#include <whipple/mesh/collective.h>
#include <whipple/run/cycle.h>
#include <whipple/run/domain.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace whipple
{
  namespace
  {
    /// c^2 of a material that is cold and free of pressure, 0 if it has no such state.
    double
    cold_stiffness(const EquationOfState &eos)
    {
      const std::array<double, 1> density{eos.reference_density()}, energy{0.};
      std::array<double, 1>       pressure{}, sound_speed_squared{};
      eos.evaluate(density, energy, pressure, sound_speed_squared);
      return std::isfinite(sound_speed_squared[0]) ? std::max(sound_speed_squared[0], 0.) : 0.;
    }

    RemapParameters
    remap_parameters(const Numerics &numerics, const Stage &stage, const std::vector<Material> &materials)
    {
      RemapParameters parameters;
      parameters.second_order         = numerics.remap_order == 2;
      parameters.kinetic_loss_to_heat = stage.lost_kinetic_energy == KineticLoss::heat;
      parameters.advection_limit      = numerics.advection_limit;
      for (const Material &material : materials)
        parameters.cold_stiffness.push_back(cold_stiffness(*material.eos));
      return parameters;
    }
  } // namespace

  template <int dim>
  Cycle<dim>::Cycle(const Scene<dim> &scene, const Stage &stage, const FieldLayout &layout, const FlatMesh<dim> &mesh,
                    const Halo<dim> &halo, PhaseClock &phases)
    : layout_(layout)
    , mesh_(mesh)
    , halo_(halo)
    , phases_(phases)
    , lost_kinetic_energy_(stage.lost_kinetic_energy)
    , lagrange_(mesh, layout.materials, scene.boundaries, scene.numerics.hydro)
  {
    effects_ = make_passes<dim>(scene.effects, mesh, layout.materials, layout.fields, scene.effect_parameters);
    if (stage.lagrangian)
      rubble_void_ = stage.lagrangian->breaking.void_fraction;
    else
      remap_.emplace(mesh, scene.boundaries, remap_parameters(scene.numerics, stage, layout.materials));
  }

  template <int dim>
  void
  Cycle<dim>::refresh(State<dim> &state, Derived &derived)
  {
    lagrange_.update_node_mass(state);
    evaluate(state, derived);
  }

  template <int dim>
  void
  Cycle<dim>::evaluate(const State<dim> &state, Derived &derived)
  {
    lagrange_.evaluate_pressure(state, derived);
    evaluate_strength(state, derived);
  }

  template <int dim>
  void
  Cycle<dim>::evaluate_strength(const State<dim> &state, Derived &derived)
  {
    lagrange_.evaluate_strength(state, derived);
    if (rubble_void_)
      soften_rubble(mesh_, state, *rubble_void_, derived);
  }

  template <int dim>
  AgreedTimeStep
  Cycle<dim>::time_step(const State<dim> &state, const Derived &derived, std::span<const Index> exempt)
  {
    const MPI_Comm communicator = halo_.communicator();
    TimeStepLimit  limit        = lagrange_.time_step(state, derived, exempt);
    if (remap_)
      if (const AdvectionLimit own = remap_->time_step(state); own.dt < limit.dt)
        limit = {own.dt, "advection", own.cell};
    if (!effects_.pass.empty())
      agree(communicator, [&] {
        for (const auto &pass : effects_.pass)
          if (const TimeStepLimit own = pass->time_step(state); own.dt < limit.dt)
            limit = own;
      });

    struct
    {
      double dt;
      int    rank;
    } least{limit.dt, 0};
    MPI_Comm_rank(communicator, &least.rank);
    const int rank = least.rank;
    MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, communicator);

    struct
    {
      char   reason[64];
      double place[2];
    } news{"", {std::nan(""), std::nan("")}};
    if (rank == least.rank)
      {
        std::snprintf(news.reason, sizeof news.reason, "%s", limit.reason.c_str());
        if (limit.cell != none)
          for (int d = 0; d < dim; ++d)
            news.place[d] = state.position[d][mesh_.cell_node[limit.cell * FlatMesh<dim>::corners]];
      }
    MPI_Bcast(&news, sizeof news, MPI_BYTE, least.rank, communicator);
    return {least.dt, news.reason, {{news.place[0], news.place[1]}}};
  }

  template <int dim>
  std::vector<Index>
  Cycle<dim>::slivers(const State<dim> &state, const Derived &derived, double bound) const
  {
    return lagrange_.slivers(state, derived, bound);
  }

  template <int dim>
  void
  Cycle<dim>::exchange(State<dim> &state) const
  {
    std::vector<std::vector<double> *> cells = layout_.cell_arrays(state), nodes{&state.node_mass};
    for (int d = 0; d < dim; ++d)
      {
        nodes.push_back(&state.position[d]);
        nodes.push_back(&state.velocity[d]);
      }
    halo_.exchange(cells, nodes);
  }

  template <int dim>
  void
  Cycle<dim>::exchange_pressures(Derived &derived) const
  {
    std::vector<std::vector<double> *> cells;
    for (DerivedMaterial &m : derived.material)
      for (auto *array : {&m.pressure, &m.sound_speed})
        cells.push_back(array);
    halo_.exchange(cells, {});
  }

  template <int dim>
  void
  Cycle<dim>::run_passes(State<dim> &state, Derived &derived, double dt, const std::function<void()> &meet)
  {
    if (effects_.pass.empty())
      return;
    effects_.books.clear(); // of a step that failed, too
    const MeetingHalo<dim> halo(halo_, meet);
    lagrange_.evaluate_pressure(state, derived);
    bool stale = false;
    for (const auto &pass : effects_.pass)
      {
        if (stale)
          {
            meet();
            exchange(state);
            exchange_pressures(derived);
          }
        pass->advance({state, derived, lagrange_.before(), dt, halo, effects_.books});
        stale = pass->leaves_out_halo();
        if (pass->changes_energy())
          lagrange_.evaluate_pressure(state, derived);
      }
  }

  template <int dim>
  void
  Cycle<dim>::advance(State<dim> &state, Derived &derived, double dt, int sweep_first,
                      std::span<const RigidFragment<dim>> rigid, Ledger<dim> &ledger)
  {
    const MPI_Comm    communicator = halo_.communicator();
    LagrangeSums<dim> motion;
    {
      const auto phase = phases_.phase("lagrange step");
      agree_in_parts(communicator, [&](const auto &meet) {
        motion = lagrange_.advance(state, derived, dt, rigid);
        run_passes(state, derived, dt, meet);
      });
      exchange(state);
    }
    RemapSums<dim> remap;
    if (remap_)
      {
        const auto phase = phases_.phase("remap");
        remap_->begin(state);
        for (int i = 0; i < dim; ++i)
          {
            agree_in_parts(communicator, [&](const auto &meet) {
              remap += remap_->sweep(state, (sweep_first + i) % dim, MeetingHalo<dim>(halo_, meet));
            });
            exchange(state);
          }
        agree(communicator, [&] { remap_->finish(state); });
        remap.collect(communicator);
      }
    const auto phase = phases_.phase("equations of state");
    if (remap_ || effects_.pass.empty())
      lagrange_.evaluate_pressure(state, derived);
    else
      exchange_pressures(derived);
    evaluate_strength(state, derived);
    Bookings<dim> bookings = remap_ ? remap.bookings(lost_kinetic_energy_) : Bookings<dim>{};
    bookings += motion.bookings();
    bookings += effects_.books.bookings();
    ledger.enter(sum_over_ranks(bookings, communicator));
  }

  template class Cycle<2>;
} // namespace whipple
