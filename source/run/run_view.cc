// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/debris_measure.h>
#include <whipple/diagnostics/plate_measure.h>
#include <whipple/mesh/collective.h>
#include <whipple/run/arrivals.h>
#include <whipple/run/run_view.h>

#include <algorithm>

namespace whipple
{
  template <int dim>
  template <typename Visit>
  void
  RunView<dim>::for_each_waiting(const Visit &visit) const
  {
    if (!run_.books.waiting)
      return;
    const auto layout = CellPacketLayout<dim>::of(run_.domain.state);
    for (const Waiting<dim> &part : run_.books.waiting->parts)
      {
        const auto [x, u] = motion_at(scene_.lattice.symmetry, layout, part, time());
        visit(part, x, u);
      }
  }

  template <int dim>
  double
  RunView<dim>::time() const
  {
    return run_.domain.state.time;
  }

  template <int dim>
  double
  RunView<dim>::start() const
  {
    return run_.books.summary.stages.back().start_us;
  }

  template <int dim>
  double
  RunView<dim>::finest_cell() const
  {
    return scene_.lattice.spacing;
  }

  template <int dim>
  double
  RunView<dim>::foremost() const
  {
    double foremost = foremost_point(run_.domain.view->mesh, run_.domain.state, run_.domain.communicator());
    for_each_waiting([&](const Waiting<dim> &, const CornerVectors<2> &x, const CornerVectors<2> &) {
      foremost = std::max(foremost, *std::max_element(x[flight_axis<dim>].begin(), x[flight_axis<dim>].end()));
    });
    return foremost;
  }

  template <int dim>
  double
  RunView<dim>::fastest() const
  {
    const State<dim> &state   = run_.domain.state;
    double            fastest = 0;
    for (Index n = 0; n < state.n_nodes(); ++n)
      if (state.node_mass[n] > 0)
        fastest = std::max(fastest, state.velocity[flight_axis<dim>][n]);
    for_each_waiting([&](const Waiting<dim> &, const CornerVectors<2> &, const CornerVectors<2> &u) {
      fastest = std::max(fastest, *std::max_element(u[flight_axis<dim>].begin(), u[flight_axis<dim>].end()));
    });
    return max_over_ranks(fastest, run_.domain.communicator());
  }

  template <int dim>
  StageView::Debris
  RunView<dim>::beyond(double plane, double velocity) const
  {
    constexpr int        corners = FlatMesh<dim>::corners;
    const FlatMesh<dim> &mesh    = run_.domain.view->mesh;
    const State<dim>    &state   = run_.domain.state;
    const auto           belongs = [&](Index c) {
      double place = 0, speed = 0;
      for (int k = 0; k < corners; ++k)
        {
          const Index n = mesh.cell_node[c * corners + k];
          place += state.position[flight_axis<dim>][n] / corners;
          speed += state.velocity[flight_axis<dim>][n] / corners;
        }
      return place > plane && speed > velocity;
    };
    const ConservedTotals<dim> sum = cell_sum<dim>(mesh, state, belongs, run_.domain.communicator());
    Debris                     found{sum.mass, sum.momentum[flight_axis<dim>], sum.kinetic_energy};
    for_each_waiting([&](const Waiting<dim> &part, const CornerVectors<2> &x, const CornerVectors<2> &u) {
      if (CellShape<dim>::middle(x)[flight_axis<dim>] > plane && CellShape<dim>::middle(u)[flight_axis<dim>] > velocity)
        {
          const auto holds = totals_of(CellPacketLayout<dim>::of(state), part.element);
          found.mass += holds.mass;
          found.momentum += holds.momentum[flight_axis<dim>];
          found.kinetic_energy += holds.kinetic_energy;
        }
    });
    return found;
  }

  template <int dim>
  double
  RunView<dim>::coming(double velocity) const
  {
    if (!run_.books.waiting)
      return 0.;
    const State<dim> &state = run_.domain.state;
    double            face  = scene_.upper_corner()[flight_axis<dim>];
    for (const std::size_t body : scene_.stages[run_.books.stage].introduces)
      face = std::min(face, extent(scene_.bodies[body].shape).lower[flight_axis<dim>]);
    return momentum_that_comes(scene_, CellPacketLayout<dim>::of(state), *run_.books.waiting, state.time, face,
                               velocity);
  }

  template <int dim>
  std::map<std::string, double>
  RunView<dim>::watched() const
  {
    const Domain<dim>            &domain       = run_.domain;
    const FlatMesh<dim>          &mesh         = domain.view->mesh;
    const MPI_Comm                communicator = domain.communicator();
    std::map<std::string, double> values;
    if (layout_.bodies_separable)
      {
        const auto bodies = present_bodies(layout_, run_);
        for (std::size_t b = 0; b < bodies.size(); ++b)
          values["kinetic energy of " + scene_.bodies[b].name] = bodies[b].kinetic_energy;
      }
    else
      values["kinetic energy"] = run_.present().kinetic_energy;
    for (const std::size_t plate : measured_plates(scene_, run_.books.stage))
      {
        const std::string &name      = scene_.bodies[plate].name;
        const Box<dim>     entered   = extent(scene_.bodies[plate].shape);
        const double       thickness = entered.upper[flight_axis<dim>] - entered.lower[flight_axis<dim>];
        const auto         measure   = measure_plate(scene_, layout_, plate, mesh, domain.state, communicator);
        values["hole of " + name]    = measure ? measure->hole_diameter : 0.;
        values["dent of " + name]    = measure ? measure->crater_depth : 0.;
        values["crater of " + name]  = measure ? std::max(0., thickness - measure->least_thickness) : 0.;
      }
    return values;
  }

  template class RunView<2>;
} // namespace whipple
