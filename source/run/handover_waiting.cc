// SPDX-License-Identifier: LGPL-2.1-or-later
// Debris that waits until it arrives: doc/theory/stages.md, "Streaming hand-over".
#include <whipple/hydro/free_flight.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/ledger/totals.h>
#include <whipple/mesh/gather.h>
#include <whipple/projection/to_eulerian.h>
#include <whipple/run/arrivals.h>
#include <whipple/run/handover.h>
#include <whipple/run/rigid_walls.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    constexpr const char *landed = "debris laid down as it arrived";

    /// Keys of the elements of all ranks that fly freely now, ascending.
    template <int dim>
    std::vector<CellKey>
    free_elements(const Scene<dim> &scene, const Domain<dim> &domain)
    {
      const FlatMesh<dim>            &mesh = domain.view->mesh;
      const std::vector<std::uint8_t> flies =
          flying_cells(mesh, domain.state, domain.derived, rigid_walls(scene), scene.boundaries, 0.);
      std::vector<CellKey> own;
      for (Index c = 0; c < mesh.n_owned; ++c)
        if (flies[c])
          own.push_back(mesh.key[c]);
      std::vector<CellKey> all = gather_all(domain.communicator(), std::span<const CellKey>(own)).entry;
      std::sort(all.begin(), all.end());
      return all;
    }
  } // namespace

  template <int dim>
  SharedDebris<dim>
  Handover<dim>::waiting_of(const CellPacketLayout<dim> &layout, std::vector<Waiting<dim>> parts) const
  {
    if (parts.empty())
      return nullptr;
    WaitingDebris<dim> waiting;
    waiting.totals = totals(layout, parts);
    for (const Waiting<dim> &part : parts)
      {
        const CornerVectors<2> u = motion_at(scene_.lattice.symmetry, layout, part, part.since).second;
        for (int k = 0; k < Element<dim>::corners; ++k)
          waiting.fastest = std::max(waiting.fastest, std::sqrt(u[0][k] * u[0][k] + u[1][k] * u[1][k]));
      }
    waiting.parts = std::move(parts);
    return std::make_shared<const WaitingDebris<dim>>(std::move(waiting));
  }

  template <int dim>
  std::vector<Element<dim>>
  Handover<dim>::let_wait(const Stage &stage, const Domain<dim> &domain, std::vector<Element<dim>> elements,
                          SharedDebris<dim> &waiting) const
  {
    const auto                layout = CellPacketLayout<dim>::of(domain.state);
    std::vector<Waiting<dim>> before;
    if (waiting)
      before = waiting->parts;
    std::vector<Element<dim>> now, later;
    if (stage.landing == Landing::as_it_arrives)
      {
        const std::vector<CellKey> flying = free_elements(scene_, domain);
        for (const Element<dim> &element : elements)
          if (element.piece >= 0 || std::binary_search(flying.begin(), flying.end(), element.key))
            later.push_back(element);
          else
            now.push_back(element);
      }
    if (stage.landing == Landing::at_once || (now.empty() && stage.introduces.empty()))
      {
        const auto others = elements_at(scene_.lattice.symmetry, layout, before, domain.state.time);
        elements.insert(elements.end(), others.begin(), others.end());
        waiting.reset();
        return elements;
      }
    const auto                &index = domain.state.index;
    const std::span<const int> stress =
        index.has_stress() ? std::span<const int>(index.stress) : std::span<const int>();
    waiting = waiting_of(layout, begin_to_wait(layout, std::move(before), std::move(later), stress, domain.state.time));
    return now;
  }

  template <int dim>
  bool
  Handover<dim>::land_arrivals(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger,
                               SharedDebris<dim> &waiting) const
  {
    const MPI_Comm                  communicator = domain.communicator();
    const auto                      layout       = CellPacketLayout<dim>::of(domain.state);
    const std::vector<std::uint8_t> arrives =
        find_arrivals(scene_, layout, *waiting, rigid_walls(scene_), domain.view->mesh, domain.state, communicator);
    std::vector<Waiting<dim>> coming, rest;
    for (std::size_t i = 0; i < arrives.size(); ++i)
      (arrives[i] ? coming : rest).push_back(waiting->parts[i]);
    if (coming.empty())
      return false;
    const auto elements = elements_at(scene_.lattice.symmetry, layout, coming, domain.state.time);
    bool       stale    = false; // what follows from the state, after a try on another mesh
    ledger.enter(lay_where_there_is_room(stage, elements, layout, 0., domain, [&](int buffer) {
      if (stale)
        LagrangeStep<dim>(domain.view->mesh, layout_.materials, scene_.boundaries, scene_.numerics.hydro)
            .evaluate(domain.state, domain.derived);
      stale = true;
      ledger.enter(Regridding<dim>::cause, regridding_.regrid(domain, stage.lost_kinetic_energy, {}, [&](auto &map) {
        request(elements, layout, buffer, map);
      }));
    }));
    ledger.note(landed, 1., totals(layout, coming).mass, "g");
    waiting = waiting_of(layout, std::move(rest));
    return true;
  }

  template <int dim>
  void
  Handover<dim>::judge_waiting(const DebrisCriteria &criteria, const Domain<dim> &domain, Ledger<dim> &ledger,
                               SharedDebris<dim> &waiting) const
  {
    if (!waiting)
      return;
    const auto                      layout   = CellPacketLayout<dim>::of(domain.state);
    const Symmetry                  symmetry = scene_.lattice.symmetry;
    const double                    time     = domain.state.time;
    const std::vector<std::uint8_t> passes   = criteria.plane
                                                   ? find_passing(scene_, layout, *waiting, domain.view->mesh,
                                                                  domain.state, *criteria.plane, domain.communicator())
                                                   : std::vector<std::uint8_t>(waiting->parts.size(), 1);
    const auto                      judge    = [&](const Waiting<dim> &part, bool through) {
      const CornerVectors<2>     x     = corners_at(symmetry, layout, part, time);
      const ConservedTotals<dim> holds = totals_of(layout, part.element);
      if (!through && CellShape<dim>::middle(x)[flight_axis<dim>] < *criteria.plane)
        return Verdict::not_debris;
      if (criteria.least_velocity && holds.momentum[flight_axis<dim>] < *criteria.least_velocity * holds.mass)
        return Verdict::not_debris;
      return void_fraction_at(symmetry, layout, part, time) > criteria.void_cutoff ? Verdict::void_cutoff
                                                                                                           : Verdict::kept;
    };
    std::vector<Waiting<dim>>                    kept;
    std::map<Verdict, std::vector<Waiting<dim>>> dropped;
    for (std::size_t i = 0; i < passes.size(); ++i)
      {
        const Waiting<dim> &part    = waiting->parts[i];
        const Verdict       verdict = judge(part, passes[i]);
        (verdict == Verdict::kept ? kept : dropped[verdict]).push_back(part);
      }
    for (const auto &[verdict, parts] : dropped)
      ledger.enter(std::string(name(verdict)), {.dropped = totals(layout, parts)});
    waiting = waiting_of(layout, std::move(kept));
  }

  template std::vector<Element<2>>
  Handover<2>::let_wait(const Stage &, const Domain<2> &, std::vector<Element<2>>, SharedDebris<2> &) const;
  template bool
  Handover<2>::land_arrivals(const Stage &, Domain<2> &, Ledger<2> &, SharedDebris<2> &) const;
  template SharedDebris<2>
  Handover<2>::waiting_of(const CellPacketLayout<2> &, std::vector<Waiting<2>>) const;
  template void
  Handover<2>::judge_waiting(const DebrisCriteria &, const Domain<2> &, Ledger<2> &, SharedDebris<2> &) const;
} // namespace whipple
