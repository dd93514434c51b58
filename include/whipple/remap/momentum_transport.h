// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/mesh/meeting_halo.h>
#include <whipple/remap/dual_flux.h>
#include <whipple/remap/node_topology.h>
#include <whipple/remap/remap_parameters.h>
#include <whipple/remap/remap_sums.h>
#include <whipple/remap/sweep_topology.h>
#include <whipple/state/fields.h>

#include <array>
#include <vector>

namespace whipple
{
  /// Momentum by dual mass fluxes between nodes (doc/theory/remap.md). Every face flux is shared out to the nodes of
  /// the face, where it stays within the node; inside a cell, fluxes along its edges restore the corners' shares of
  /// the new cell mass. Those edge fluxes carry the limited upwind velocity from node to node: momentum is exact, and
  /// with donor velocities every new velocity is a convex combination of old ones.
  template <int dim>
  class MomentumTransport
  {
  public:
    MomentumTransport(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries, const RemapParameters &parameters);

    /// Update node velocities and masses, and heat the material by the kinetic energy lost if so chosen.
    /// @param mass_flux   [face + 1] of all materials, along + axis
    /// @param mass_before, mass_after [cell] of all materials, around the sweep
    /// @param halo collective: what drained nodes give is exchanged
    void
    move(State<dim> &state, const SweepTopology<dim> &topology, const std::vector<double> &mass_flux,
         const std::vector<double> &mass_before, const std::vector<double> &mass_after, const MeetingHalo<dim> &halo,
         RemapSums<dim> &report);

  private:
    /// Sums over the fluxes F (inwards positive) of velocity u relative to the node's: F u and F u^2.
    struct Exchange
    {
      double      inflow = 0;
      Vector<dim> momentum{};
      double      square = 0;
    };

    /// What a node that gives away more than it held gives, and keeps: the mixture of all that reaches it.
    struct Mixture
    {
      Vector<dim> velocity{};
      double      excess = 0; ///< minus the kinetic energy a gram that mixing cost: the receivers are heated by it
    };

    /// New velocity of a node: reference + velocity.
    struct Change
    {
      Vector<dim> reference{};
      Vector<dim> velocity{};
      Exchange    exchange; ///< relative to the reference
    };

    void
    upwind_velocities(const State<dim> &state, int axis, const std::vector<double> &mass_after);

    /// Whether a node has a velocity: it, or both masters of a hanging one, hold mass.
    bool
    moves(const State<dim> &state, Index node) const;

    /// Velocities of what leaves a node among equal cells.
    void
    reconstruct(const State<dim> &state, int axis, Index node);

    /// The same where cells of several sizes meet: they leave through faces at different distances.
    void
    reconstruct_uneven(const State<dim> &state, int axis, Index node);

    /// The same where a line of nodes ends: as if the mirror image lay beyond a reflecting side, else without a slope.
    void
    reconstruct_at_plane(const State<dim> &state, int axis, Index node);

    /// Half the longest edge below and above a node, cm: how far the farthest face of what belongs to it is.
    std::array<double, 2>
    half_edges(int axis, Index node) const;

    /// Flatten a node's slopes until the cells around its receivers can pay its excess out of their heat.
    void
    flatten_to_heat_to_spare(const State<dim> &state, int axis, const std::vector<double> &mass_after, Index node);

    /// What the kinetic energy of slopes may take from a gram of a material, Mbar cm^3/g.
    static double
    heat_to_spare(double energy, double cold_stiffness);
    static double
    least_heat_to_spare(const RemapParameters &parameters);

    /// Largest excess a gram of inflow that a node can pay.
    double
    largest_excess(const State<dim> &state, const std::vector<double> &mass_after, Index receiver) const;

    /// Velocity of what leaves a node up or down the axis through the face at a distance `half` of its cell.
    Vector<dim>
    carried_along(Index from, bool up, double half) const;

    /// Velocity of what leaves a node across the axis.
    Vector<dim>
    carried_across(Index from) const;

    /// What leaves a node, by its velocity up the axis.
    Mixture
    given_by(const Index node) const
    {
      Mixture given{{}, excess_[node]};
      for (int d = 0; d < dim; ++d)
        given.velocity[d] = up_[d][node];
      return given;
    }
    std::vector<std::vector<double> *>
    arrays_given();

    /// Mix what a drained node held with what flows in.
    /// @returns whether it gives something else now, beyond round-off
    bool
    mix_once(const State<dim> &state, int axis, Index node, Mixture &mixed) const;
    void
    mix_drained_nodes(const State<dim> &state, int axis, const MeetingHalo<dim> &halo);
    void
    add_flux(Index from, const std::array<std::vector<double>, dim> &upwind, double flux, double excess,
             const Vector<dim> &velocity, Exchange &exchange) const;
    void
    add_flux(const Vector<dim> &carried, double flux, double excess, const Vector<dim> &velocity,
             Exchange &exchange) const;
    void
    gather_interior(int axis, Index node, const Vector<dim> &velocity, Exchange &exchange) const;
    void
    gather_special(int axis, Index node, Index corner_node, double share, const Vector<dim> &velocity,
                   Exchange &exchange) const;
    void
    gather(const State<dim> &state, int axis, Index node, const Vector<dim> &velocity, Exchange &exchange) const;
    void
    gather_drained(const State<dim> &state, int axis, Index node, const Vector<dim> &velocity,
                   Exchange &exchange) const;
    Vector<dim>
    first_velocity(int axis, Index node) const;
    void
    change_of(const State<dim> &state, int axis, Index node, bool drained, Change &change) const;
    void
    constrain(Index node, double time, Change &change, RemapSums<dim> &report) const;
    void
    update_nodes(State<dim> &state, int axis, RemapSums<dim> &report);
    void
    book_boundaries(const State<dim> &state, const SweepTopology<dim> &topology, const std::vector<double> &mass_flux,
                    RemapSums<dim> &report) const;
    void
    heat_cells(State<dim> &state, const std::vector<double> &mass_after, RemapSums<dim> &report) const;

    /// Whether this rank counts the node in sums over all nodes.
    bool
    counts(const Index node) const
    {
      return mesh_->node_corner[mesh_->node_corner_begin[node]] / FlatMesh<dim>::corners < mesh_->n_owned;
    }

    /// Whether this rank finds all that flows into the node.
    bool
    at_owned_cell(const Index node) const
    {
      for (Index i = mesh_->node_corner_begin[node]; i < mesh_->node_corner_begin[node + 1]; ++i)
        if (mesh_->node_corner[i] / FlatMesh<dim>::corners < mesh_->n_owned)
          return true;
      return false;
    }

    const FlatMesh<dim>  *mesh_;
    const Boundaries<dim> boundaries_;
    const RemapParameters parameters_;
    const double          least_heat_to_spare_; ///< an excess below this can always be paid, Mbar cm^3/g

    const NodeTopology<dim> nodes_;
    DualFlux<dim>           dual_;

    std::array<std::vector<double>, dim> up_, down_; ///< velocity of what leaves a node along + axis, - axis; of an
                                                     ///< uneven node without gradient_ times the distance of the face
    std::array<std::vector<double>, dim> gradient_;  ///< of uneven nodes, along the axis, 1/us; others 0
    std::vector<double>                  excess_;    ///< kinetic energy a gram that what leaves does not carry on
    std::vector<Index>                   drained_;   ///< nodes that give away more than they held
    std::vector<Mixture>                 mixed_;     ///< what they give after mixing with the inflow
    std::vector<double>                  specific_loss_; ///< [node] kinetic energy lost a gram of the node
  };
} // namespace whipple
