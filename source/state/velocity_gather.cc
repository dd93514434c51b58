// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/state/velocity_gather.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// One gather: the passes share these arrays.
    template <int dim>
    class Gather
    {
    public:
      static constexpr int corners = 1 << dim;

      Gather(const FlatMesh<dim> &mesh, const CornerVelocities<dim> &source, State<dim> &state)
        : mesh_(mesh)
        , source_(source)
        , state_(state)
        , corner_mass_(static_cast<std::size_t>(mesh.n_cells) * corners)
        , transfer_(mesh.n_cells, 1.)
        , is_hanging_(mesh.n_nodes, false)
        , heat_(source.kinetic_remainder)
      {
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            const auto   share = corner_shares<dim>(state, cell);
            const double mass  = cell_mass<dim>(state, cell);
            for (int k = 0; k < corners; ++k)
              corner_mass_[cell * corners + k] = share[k] * mass;
          }
        for (const Index node : mesh.hanging)
          is_hanging_[node] = true;
        for (auto *arrays : {&own_, &removed_})
          for (auto &array : *arrays)
            array.assign(mesh.n_nodes, 0.);
      }

      /// Mean over the corners of every node, hanging ones too, and the mass it stands for.
      void
      average_corners()
      {
        for (Index node = 0; node < mesh_.n_nodes; ++node)
          {
            double      mass = 0;
            Vector<dim> reference{}, sum{};
            for_corners(node, [&](Index corner) {
              const double m = corner_mass_[corner];
              if (m == 0)
                return;
              for (int d = 0; d < dim; ++d)
                {
                  if (mass == 0)
                    reference[d] = source_.velocity[d][corner];
                  sum[d] += m * (source_.velocity[d][corner] - reference[d]);
                }
              mass += m;
            });
            state_.node_mass[node] = mass;
            for (int d = 0; d < dim; ++d)
              own_[d][node] = mass == 0 ? 0. : reference[d] + sum[d] / mass;
          }
      }

      /// A master whose own cells are empty has no velocity yet: take the one that makes the hanging nodes the
      /// means of their masters.
      void
      extrapolate_to_massless_masters()
      {
        std::vector<double>      weight(mesh_.n_nodes, 0.);
        std::vector<Vector<dim>> sum(mesh_.n_nodes, Vector<dim>{});
        for (std::size_t h = 0; h < mesh_.hanging.size(); ++h)
          for (int side = 0; side < 2; ++side)
            {
              const Index  node = mesh_.hanging[h], master = mesh_.master[h][side], other = mesh_.master[h][1 - side];
              const double mass = state_.node_mass[node];
              if (state_.node_mass[master] != 0 || mass == 0)
                continue;
              weight[master] += mass;
              for (int d = 0; d < dim; ++d)
                {
                  const double end = state_.node_mass[other] == 0 ? own_[d][node] : own_[d][other];
                  sum[master][d] += mass * (2. * own_[d][node] - end);
                }
            }
        for (Index node = 0; node < mesh_.n_nodes; ++node)
          if (weight[node] > 0)
            for (int d = 0; d < dim; ++d)
              own_[d][node] = sum[node][d] / weight[node];
      }

      /// How much of its masters' velocity difference a cell's hanging corners can pass on: 1 where the
      /// kinetic remainder holds m |difference|^2/8 for each of them.
      void
      weigh_transfer()
      {
        std::vector<double> wanted(mesh_.n_cells, 0.);
        for_hanging_corners([&](Index corner, Index a, Index b) {
          wanted[corner / corners] += corner_mass_[corner] * difference_2(a, b) / 8.;
        });
        constexpr double round_off = 1e-12;
        for (Index cell = 0; cell < mesh_.n_cells; ++cell)
          if (source_.kinetic_remainder[cell] < wanted[cell] * (1. - round_off))
            transfer_[cell] = std::sqrt(std::max(0., source_.kinetic_remainder[cell]) / wanted[cell]);
      }

      /// Give the masters half of every hanging corner's mass and momentum; constrain; hang.
      void
      settle(const Boundaries<dim> &boundaries)
      {
        std::vector<double>      mass = state_.node_mass;
        std::vector<Vector<dim>> gain(mesh_.n_nodes, Vector<dim>{});
        for_hanging_corners([&](Index corner, Index a, Index b) {
          const double half = Masters<dim>::weight * corner_mass_[corner];
          for (const Index master : {a, b})
            {
              mass[master] += half;
              for (int d = 0; d < dim; ++d)
                gain[master][d] += half * (passed_on(corner, d, master, a, b) - own_[d][master]);
            }
        });
        for (Index node = 0; node < mesh_.n_nodes; ++node)
          for (int d = 0; d < dim; ++d)
            {
              double &v = state_.velocity[d][node];
              v         = mass[node] == 0 ? 0. : own_[d][node] + gain[node][d] / mass[node];
              if (is_held(boundaries, mesh_.node_side[node], d))
                {
                  removed_[d][node] = v;
                  v                 = 0;
                }
            }
        for (const Index node : mesh_.hanging)
          mass[node] = 0;
        for (auto &component : state_.velocity)
          mesh_.hang(component);
        state_.node_mass = std::move(mass);
      }

      /// Kinetic energy each cell's corners lost, on top of the remainder; and the impulse to the walls.
      Booking<dim>
      book(KineticLoss loss)
      {
        std::vector<Vector<dim>> impulse(mesh_.n_cells, Vector<dim>{});
        for (Index corner = 0; corner < mesh_.n_cells * corners; ++corner)
          {
            const Index node = mesh_.cell_node[corner];
            if (is_hanging_[node])
              continue;
            for (int d = 0; d < dim; ++d)
              {
                const double slip = source_.velocity[d][corner] - state_.velocity[d][node];
                heat_[corner / corners] += 0.5 * corner_mass_[corner] * slip * slip;
                impulse[corner / corners][d] += corner_mass_[corner] * removed_[d][node];
              }
          }
        for_hanging_corners([&](Index corner, Index a, Index b) {
          const Index  cell = corner / corners;
          const double mass = corner_mass_[corner], transfer = transfer_[cell];
          heat_[cell] -= transfer * transfer * mass * difference_2(a, b) / 8.;
          for (const Index master : {a, b})
            for (int d = 0; d < dim; ++d)
              {
                const double slip = passed_on(corner, d, master, a, b) - state_.velocity[d][master];
                heat_[cell] += 0.25 * mass * slip * slip;
                impulse[cell][d] += 0.5 * mass * removed_[d][master];
              }
        });
        double      lost = 0;
        Vector<dim> wall_impulse{};
        for (Index cell = 0; cell < mesh_.n_owned; ++cell)
          {
            lost += heat_[cell];
            for (int d = 0; d < dim; ++d)
              wall_impulse[d] += impulse[cell][d];
          }
        Booking<dim> booking            = lost_kinetic_energy<dim>(lost, loss);
        booking.left.emplace().momentum = wall_impulse;
        return booking;
      }

      void
      heat()
      {
        for (Index cell = 0; cell < mesh_.n_cells; ++cell)
          {
            const double mass = cell_mass<dim>(state_, cell);
            if (heat_[cell] == 0 || mass == 0)
              continue;
            for (MaterialState &material : state_.material)
              if (material.mass[cell] > 0)
                material.energy[cell] += heat_[cell] / mass;
          }
      }

    private:
      template <typename Visit>
      void
      for_corners(Index node, Visit visit) const
      {
        for (Index i = mesh_.node_corner_begin[node]; i < mesh_.node_corner_begin[node + 1]; ++i)
          visit(mesh_.node_corner[i]);
      }

      template <typename Visit>
      void
      for_hanging_corners(Visit visit) const
      {
        for (std::size_t h = 0; h < mesh_.hanging.size(); ++h)
          for_corners(mesh_.hanging[h], [&](Index corner) { visit(corner, mesh_.master[h][0], mesh_.master[h][1]); });
      }

      double
      difference_2(Index a, Index b) const
      {
        double sum = 0;
        for (int d = 0; d < dim; ++d)
          sum += (own_[d][a] - own_[d][b]) * (own_[d][a] - own_[d][b]);
        return sum;
      }

      /// Velocity with which half of a hanging corner joins a master: the corner's own plus (for the two
      /// masters with opposite signs) what is passed on of half the masters' difference.
      double
      passed_on(Index corner, int d, Index master, Index a, Index b) const
      {
        const Index other = master == a ? b : a;
        return source_.velocity[d][corner] + transfer_[corner / corners] * 0.5 * (own_[d][master] - own_[d][other]);
      }

      static bool
      is_held(const Boundaries<dim> &boundaries, std::uint8_t sides, int axis)
      {
        const int side = ruling_side<dim>(boundaries, sides, axis);
        return side != none && boundaries[side].kind == BoundaryKind::reflecting;
      }

      const FlatMesh<dim>         &mesh_;
      const CornerVelocities<dim> &source_;
      State<dim>                  &state_;

      std::vector<double>                  corner_mass_;
      std::vector<double>                  transfer_;   ///< [n_cells] 0 ... 1
      std::vector<bool>                    is_hanging_; ///< [n_nodes]
      std::vector<double>                  heat_;       ///< [n_cells]
      std::array<std::vector<double>, dim> own_;        ///< [n_nodes] mean over the node's own corners
      std::array<std::vector<double>, dim> removed_;    ///< [n_nodes] normal velocity taken by walls
    };
  } // namespace

  template <int dim>
  Booking<dim>
  gather_velocities(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries, const CornerVelocities<dim> &corners,
                    KineticLoss loss, State<dim> &state)
  {
    Gather<dim> gather(mesh, corners, state);
    gather.average_corners();
    gather.extrapolate_to_massless_masters();
    gather.weigh_transfer();
    gather.settle(boundaries);
    const Booking<dim> booking = gather.book(loss);
    if (loss == KineticLoss::heat)
      gather.heat();
    return booking;
  }

  template <int dim>
  double
  kinetic_energy(const FlatMesh<dim> &mesh, const State<dim> &state)
  {
    constexpr int               corners = 1 << dim;
    const CornerVelocities<dim> source  = corner_velocities<dim>(mesh, state);
    double                      sum     = 0;
    for (Index cell = 0; cell < mesh.n_owned; ++cell)
      {
        const auto   share = corner_shares<dim>(state, cell);
        const double mass  = cell_mass<dim>(state, cell);
        for (int k = 0; k < corners; ++k)
          for (int d = 0; d < dim; ++d)
            {
              const double u = source.velocity[d][cell * corners + k];
              sum += 0.5 * share[k] * mass * u * u;
            }
        sum += source.kinetic_remainder[cell];
      }
    return sum;
  }

  template <int dim>
  Vector<dim>
  momentum(const FlatMesh<dim> &mesh, const State<dim> &state)
  {
    constexpr int               corners = 1 << dim;
    const CornerVelocities<dim> source  = corner_velocities<dim>(mesh, state);
    Vector<dim>                 sum{};
    for (Index cell = 0; cell < mesh.n_owned; ++cell)
      {
        const auto   share = corner_shares<dim>(state, cell);
        const double mass  = cell_mass<dim>(state, cell);
        for (int k = 0; k < corners; ++k)
          for (int d = 0; d < dim; ++d)
            sum[d] += share[k] * mass * source.velocity[d][cell * corners + k];
      }
    return sum;
  }

  template Booking<2>
  gather_velocities<2>(const FlatMesh<2> &, const Boundaries<2> &, const CornerVelocities<2> &, KineticLoss,
                       State<2> &);
  template double
  kinetic_energy<2>(const FlatMesh<2> &, const State<2> &);
  template Vector<2>
  momentum<2>(const FlatMesh<2> &, const State<2> &);
} // namespace whipple
