// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/hydro/trace.h>
#include <whipple/initial/painted_bodies.h>
#include <whipple/initial/painting.h>
#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/collective.h>
#include <whipple/projection/debris_selection.h>
#include <whipple/projection/element.h>
#include <whipple/projection/intact_cells.h>
#include <whipple/projection/to_eulerian.h>
#include <whipple/projection/to_lagrangian.h>
#include <whipple/run/handover.h>
#include <whipple/state/conversion.h>

#include <algorithm>
#include <array>

namespace whipple
{
  namespace
  {
    const ConversionRegistration registration({60, laid_down::projection}, ConversionListed::at_end);

    /// Bounding box of an element.
    template <int dim>
    std::array<Vector<dim>, 2>
    bounding_box(const Element<dim> &element)
    {
      std::array<Vector<dim>, 2> box;
      for (int d = 0; d < dim; ++d)
        {
          const auto [low, high] = std::minmax_element(element.position[d].begin(), element.position[d].end());
          box[0][d]              = *low;
          box[1][d]              = *high;
        }
      return box;
    }

    /// Move the nodes of a fresh state to where the scene's mesh map starts them.
    template <int dim>
    void
    map_nodes(const Scene<dim> &scene, Domain<dim> &domain)
    {
      const FlatMesh<dim> &mesh  = domain.view->mesh;
      State<dim>          &state = domain.state;
      for (Index n = 0; n < mesh.n_nodes; ++n)
        {
          Vector<dim> x;
          for (int d = 0; d < dim; ++d)
            x[d] = mesh.node_point[d][n];
          x = mapped_point(scene.mesh_map, scene.lattice.origin, scene.upper_corner(), x);
          for (int d = 0; d < dim; ++d)
            state.position[d][n] = x[d];
        }
      for (auto &x : state.position)
        mesh.hang(x);
      agree(domain.communicator(), [&] { initialise_geometry(mesh, state); });
    }

    /// How the elements hold together that the cells become: bonds of the forest's leaves.
    template <int dim>
    Bonds
    element_bonds(const LagrangianStage &stage, const Domain<dim> &domain)
    {
      if (stage.cohesion != Cohesion::graded)
        return stage.cohesion;
      const std::vector<std::uint8_t> whole = intact_cells(domain.view->mesh, domain.state, stage.breaking);
      std::vector<std::uint8_t>       intact(domain.forest.leaves().size(), 0);
      for (std::size_t c = 0; c < whole.size(); ++c)
        intact[domain.view->leaf_of_cell[c]] = whole[c];
      return Bonds(std::move(intact));
    }

    /// Layers of neighbours that elements need: fragments have no neighbours.
    template <int dim>
    int
    element_halo(const LagrangianStage &stage)
    {
      return stage.cohesion == Cohesion::fragments ? 0 : halo_width<dim>;
    }

    /// Share of a cell below which it does not become an element when all is laid anew.
    constexpr double sliver_of_element = 1e-3;
    /// Part of the domain that solid may fill for that.
    constexpr double fullest_domain = 0.99;

    /// True volume of the domain, cm^3.
    template <int dim>
    double
    volume(const Scene<dim> &scene)
    {
      const Vector<dim> upper = scene.upper_corner();
      return cell_volume<dim>(scene.lattice.symmetry, CellShape<dim>::box(scene.lattice.origin, upper));
    }

    template <int dim>
    double
    solid_fraction(const CellPacketLayout<dim> &layout, const CellPacket &packet)
    {
      double volume = 0;
      for (int m = 0; m < layout.n_materials(); ++m)
        volume += packet[layout.volume(m)];
      return volume > 0 ? solid_volume(layout, packet) / volume : 1.;
    }
  } // namespace

  template <int dim>
  Handover<dim>::Handover(const Problem<dim> &problem, const Regridding<dim> &regridding)
    : problem_(problem)
    , scene_(problem.scene)
    , layout_(problem.layout)
    , regridding_(regridding)
  {
  }

  template <int dim>
  void
  Handover<dim>::enter(const Stage &stage, const Stage *previous, Domain<dim> &domain, Ledger<dim> &ledger,
                       SharedDebris<dim> &waiting) const
  {
    if (!previous)
      start(stage, domain, ledger);
    else if (previous->mode() == StageMode::lagrangian)
      {
        Bookings<dim> gathered;
        auto          elements = gather(stage, domain, gathered);
        if (stage.mode() == StageMode::eulerian)
          elements = let_wait(stage, domain, std::move(elements), waiting);
        lay_down(stage, elements, 0., gathered, domain, ledger);
      }
    else if (!stage.introduces.empty())
      {
        ledger.enter(Regridding<dim>::cause, regridding_.regrid(domain, stage.lost_kinetic_energy, stage.introduces));
        paint(stage, domain, ledger);
      }
    if (stage.mode() == StageMode::lagrangian)
      {
        const bool select = previous && previous->mode() == StageMode::eulerian;
        judge_waiting(debris_criteria(*stage.lagrangian, select), domain, ledger, waiting);
        take_up(stage, select, domain, ledger);
      }
  }

  template <int dim>
  bool
  Handover<dim>::lay_anew(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const
  {
    double solid = 0;
    for (const MaterialState &m : domain.state.material)
      for (Index c = 0; c < domain.view->mesh.n_owned; ++c)
        solid += m.volume[c] * (m.has_voids() ? 1. - m.void_fraction[c] : 1.);
    if (sum_over_ranks(solid, domain.communicator()) > fullest_domain * volume(scene_))
      return false;
    Stage between = stage;
    between.introduces.clear();
    between.representation = RepresentationRegistry::make("distended");
    Bookings<dim> gathered;
    const auto    elements = gather(between, domain, gathered);
    lay_down(between, elements, sliver_of_element, gathered, domain, ledger);
    take_up(between, false, domain, ledger);
    spread(between, domain, ledger);
    return true;
  }

  template <int dim>
  void
  Handover<dim>::start(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const
  {
    RefinementMap<dim> map(scene_.lattice);
    request_bodies(scene_, stage.mode() == StageMode::eulerian ? &regridding_.need() : nullptr,
                   std::span<const std::size_t>(stage.introduces), map);
    map.synchronise(domain.communicator());
    regridding_.build(domain, map);
    if (scene_.mesh_map != MeshMap::identity)
      map_nodes(scene_, domain);
    paint(stage, domain, ledger);
  }

  template <int dim>
  void
  Handover<dim>::paint(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const
  {
    const FlatMesh<dim>               &mesh   = domain.view->mesh;
    const ConservedTotals<dim>         before = totals(mesh, domain.state, domain.communicator());
    const std::span<const std::size_t> bodies(stage.introduces);
    const Booking<dim>                 painted = sum_over_ranks(
                        paint_bodies(problem_, bodies, mesh, domain.communicator(), domain.state), domain.communicator());
    ConservedTotals<dim> entered = totals(mesh, domain.state, domain.communicator());
    entered.mass -= before.mass;
    entered.internal_energy -= before.internal_energy;
    entered.kinetic_energy -= before.kinetic_energy;
    for (int d = 0; d < dim; ++d)
      entered.momentum[d] -= before.momentum[d];
    ledger.introduce(entered);
    for (int d = 0; d < dim; ++d)
      entered.momentum[d] += painted.left->momentum[d];
    check_entered(scene_, bodies, entered);
  }

  template <int dim>
  void
  Handover<dim>::request(const std::vector<Element<dim>> &elements, const CellPacketLayout<dim> &layout, int buffer,
                         RefinementMap<dim> &map) const
  {
    const Vector<dim> upper = scene_.upper_corner();
    for (const Element<dim> &element : elements)
      {
        const auto box    = bounding_box(element);
        bool       inside = true;
        for (int d = 0; d < dim; ++d)
          inside = inside && box[1][d] > scene_.lattice.origin[d] && box[0][d] < upper[d];
        if (inside)
          map.request(regridding_.need().of_solid_fraction(solid_fraction(layout, element.packet)), box[0], box[1],
                      buffer);
      }
  }

  template <int dim>
  void
  Handover<dim>::build_around(const std::vector<Element<dim>> &elements, const CellPacketLayout<dim> &layout,
                              const Stage &stage, int buffer, Domain<dim> &domain) const
  {
    RefinementMap<dim> map(scene_.lattice);
    request(elements, layout, buffer, map);
    request_bodies(scene_, &regridding_.need(), std::span<const std::size_t>(stage.introduces), map);
    map.synchronise(domain.communicator());
    regridding_.build(domain, map);
  }

  template <int dim>
  std::vector<Element<dim>>
  Handover<dim>::gather(const Stage &stage, const Domain<dim> &domain, Bookings<dim> &bookings) const
  {
    const auto layout = CellPacketLayout<dim>::of(domain.state);
    return stage.representation->gather(
        {scene_.lattice, layout, stage.lost_kinetic_energy, field_index(layout_.fields, "fragmented share"),
         field_index(layout_.fields, "fragment size moment")},
        gather_elements(domain.communicator(), layout, elements_of(layout, domain.view->mesh, domain.state)), bookings);
  }

  template <int dim>
  void
  Handover<dim>::lay_down(const Stage &stage, const std::vector<Element<dim>> &elements, double sliver,
                          const Bookings<dim> &gathered, Domain<dim> &domain, Ledger<dim> &ledger) const
  {
    const auto        layout = CellPacketLayout<dim>::of(domain.state);
    const Ledger<dim> before = ledger;
    Bookings<dim>     laid   = lay_where_there_is_room(stage, elements, layout, sliver, domain, [&](int buffer) {
      build_around(elements, layout, stage, buffer, domain);
      ledger = before;
      paint(stage, domain, ledger);
    });
    laid += gathered;
    ledger.enter(laid);
  }

  template <int dim>
  Bookings<dim>
  Handover<dim>::lay_where_there_is_room(const Stage &stage, const std::vector<Element<dim>> &elements,
                                         const CellPacketLayout<dim> &layout, double sliver, Domain<dim> &domain,
                                         const std::function<void(int buffer)> &make_mesh) const
  {
    for (int buffer = scene_.mesh.buffer;; buffer *= 2)
      {
        make_mesh(buffer);
        try
          {
            const std::vector<std::uint8_t> edge = Regridding<dim>::edge_flags(*domain.view);
            return to_eulerian(domain.communicator(), scene_.lattice, layout, elements, *stage.representation,
                               domain.view->mesh, domain.view->halo, LayDownLimits{edge, sliver}, scene_.boundaries,
                               stage.lost_kinetic_energy, domain.state)
                .bookings;
          }
        catch (const NoRoomError &)
          {
            if (buffer > largest_buffer)
              throw;
          }
      }
  }

  template <int dim>
  DebrisCriteria
  Handover<dim>::debris_criteria(const LagrangianStage &stage, bool select) const
  {
    DebrisCriteria criteria;
    criteria.void_cutoff = 1.;
    if (select)
      {
        criteria.void_cutoff    = stage.debris.void_cutoff;
        criteria.least_velocity = stage.debris.minimum_axial_velocity;
        if (stage.debris.behind)
          criteria.plane = extent(scene_.bodies[*stage.debris.behind].shape).upper[flight_axis<dim>];
      }
    return criteria;
  }

  template <int dim>
  void
  Handover<dim>::take_up(const Stage &stage, bool select, Domain<dim> &domain, Ledger<dim> &ledger) const
  {
    const MPI_Comm       communicator = domain.communicator();
    const FlatMesh<dim> &cells        = domain.view->mesh;
    DebrisCriteria       criteria     = debris_criteria(*stage.lagrangian, select);
    // an element made of a trace would be nothing but void, phi = 1
    criteria.void_cutoff                 = std::min(criteria.void_cutoff, 1. - trace::share);
    const DebrisSelection<dim> selection = select_debris(cells, domain.state, criteria);
    Bookings<dim>              dropped; // booked once the elements are there
    for (const Verdict verdict : {Verdict::void_cutoff, Verdict::not_debris})
      if (const auto amount = cell_sum(
              cells, domain.state, [&](Index c) { return selection.verdict[c] == verdict; }, communicator);
          amount.mass > 0)
        dropped.drop(std::string(name(verdict)), amount);

    std::vector<std::uint8_t> active(domain.forest.leaves().size(), 0);
    for (Index c = 0; c < cells.n_owned; ++c)
      active[domain.view->leaf_of_cell[c]] = selection.kept(c);
    auto view =
        domain.forest.flatten(active, element_halo<dim>(*stage.lagrangian), element_bonds(*stage.lagrangian, domain));

    TakenUp<dim> taken_up;
    State<dim>   state;
    agree(communicator, [&] {
      state = to_lagrangian(cells, domain.state, view->mesh, scene_.boundaries, stage.lost_kinetic_energy,
                            std::span<const std::string>(layout_.material_names), taken_up);
    });
    ledger.enter(dropped);
    state.time   = domain.state.time;
    domain.state = std::move(state);
    domain.view  = std::move(view);
    exchange_cells(layout_, domain.view->halo, domain.state);
    domain.view->halo.exchange_corners(std::vector<std::vector<double> *>{&domain.state.corner_weight});
    domain.view->halo.exchange(
        {}, std::vector<std::vector<double> *>{&domain.state.velocity[0], &domain.state.velocity[1]});
    ledger.enter(laid_down::projection, sum_over_ranks(taken_up.booking, communicator));
    if (select)
      spread(stage, domain, ledger);
  }

  template <int dim>
  void
  Handover<dim>::spread(const Stage &stage, Domain<dim> &domain, Ledger<dim> &ledger) const
  {
    const auto              layout = CellPacketLayout<dim>::of(domain.state);
    std::vector<CellPacket> packets(domain.forest.leaves().size());
    {
      const FlatMesh<dim>        &mesh    = domain.view->mesh;
      const CornerVelocities<dim> corners = corner_velocities(mesh, domain.state);
      InterfaceNormals<dim>       normals(layout.n_materials()); // elements have no interfaces
      for (auto &material : normals)
        for (auto &component : material)
          component.assign(mesh.n_owned, 0.);
      for (Index c = 0; c < mesh.n_owned; ++c)
        {
          CellPacket &packet = packets[domain.view->leaf_of_cell[c]];
          packet             = pack<dim>(layout, domain.state, c, corners, normals);
          packet.push_back(mesh.intact[c]); // travels behind what the layout knows
        }
    }
    // whatever the number of empty leaves, it is the elements that count
    domain.forest.repartition(packets, [](const CellPacket &packet) { return packet.empty() ? 1u : 1000u; });

    std::vector<std::uint8_t> active(packets.size(), 0), intact(packets.size(), 0);
    for (std::size_t i = 0; i < packets.size(); ++i)
      if (!packets[i].empty())
        {
          active[i] = 1;
          intact[i] = packets[i].back() != 0;
          packets[i].pop_back();
        }
    domain.view = domain.forest.flatten(active, element_halo<dim>(*stage.lagrangian), Bonds(std::move(intact)));
    clear_state(layout_, domain);
    ledger.enter(laid_down::projection,
                 unpack_leaves(layout_, layout, packets, scene_.boundaries, stage.lost_kinetic_energy, domain));
  }

  template class Handover<2>;
} // namespace whipple
