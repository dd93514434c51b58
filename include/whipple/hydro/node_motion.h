// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/step_work.h>
#include <whipple/hydro/transmitting_side.h>
#include <whipple/material/material.h>
#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <array>
#include <span>
#include <vector>

namespace whipple
{
  /// What the sides of the domain gave to the nodes of owned cells in a step.
  template <int dim>
  struct BoundaryExchange
  {
    double      work = 0;   ///< Mbar cm^3
    Vector<dim> momentum{}; ///< g cm/us
  };

  /// An element that shares no node with others, all of whose corners have one velocity, and that keeps its shape in a
  /// step (doc/theory/stages.md, "Fragments").
  template <int dim>
  struct RigidFragment
  {
    Index                 cell;
    std::array<bool, dim> held{}; ///< along which axes it may not move; it has no velocity there
  };

  /// Nodes: forces from corners, sides of the domain, velocity and position.
  template <int dim>
  class NodeMotion
  {
  public:
    NodeMotion(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries, const std::vector<Material> &materials);

    /// work.half_position = x + dt/2 v.
    void
    predict(const State<dim> &state, double dt, StepWork<dim> &work) const;

    /// Whether a side gives nodes a velocity that they need not have yet.
    bool
    drives_nodes() const
    {
      return drives_nodes_;
    }

    /// Put the velocity that the sides give their nodes now in place of the one they have.
    void
    drive(const State<dim> &state, std::array<std::vector<double>, dim> &velocity) const;

    /// Force of sides on their nodes into the object's own arrays, on the material that touches them.
    /// Sides with a pressure p: -p n per unit area. Transmitting sides: the traction that an outgoing wave meets
    /// (transmitting_side.h), but no more than the force of the cell on that face where that is small beside it: what
    /// carries no stress leaves freely. Where the side keeps the ambient stress: all of it, and that stress.
    /// Needs work.corner_force.
    void
    load_sides(const State<dim> &state, const Derived &derived, double dt, const StepWork<dim> &work);

    /// Sum corner forces over nodes (hanging nodes hand theirs to their masters), accelerate, apply the sides,
    /// move: work.velocity, work.mean_velocity, work.position.
    BoundaryExchange<dim>
    move(const State<dim> &state, double dt, std::span<const RigidFragment<dim>> rigid, StepWork<dim> &work);

  private:
    /// A face of a cell on a side that absorbs or presses.
    struct LoadedFace
    {
      Index              cell;
      int                side;
      std::array<int, 2> corner; ///< corners of the cell on the face, the cell to the left of the way between them
    };
    /// Where a loaded face is in the middle of the step.
    struct Edge
    {
      std::array<Index, 2>  node;
      Vector<dim>           along;  ///< from the first node to the second, cm
      double                length; ///< cm
      std::array<double, 2> area;   ///< that each end carries, cm^2
    };
    /// A node whose velocity sides prescribe.
    struct ConstrainedNode
    {
      Index                node;
      bool                 owned; ///< first corner of the node belongs to an owned cell
      std::array<int, dim> side;  ///< that rules each component, `none` if it is free
    };

    Edge
    edge(const LoadedFace &face, const StepWork<dim> &work) const;
    void
    absorb(const LoadedFace &face, const State<dim> &state, const Derived &derived, double dt,
           const StepWork<dim> &work);
    void
    press(const LoadedFace &face, double pressure, const State<dim> &state, const StepWork<dim> &work);
    /// Velocities of the nodes of loaded faces; leaves the force of the sides in traction_.
    void
    accelerate_loaded(const State<dim> &state, double dt, StepWork<dim> &work);
    void
    sum_corner_forces(StepWork<dim> &work) const;
    /// All corners of a rigid fragment take its momentum together; what holds it takes the rest.
    void
    keep_shapes(const State<dim> &state, std::span<const RigidFragment<dim>> rigid, StepWork<dim> &work,
                BoundaryExchange<dim> &exchange) const;
    void
    constrain(const State<dim> &state, double dt, StepWork<dim> &work, BoundaryExchange<dim> &exchange) const;

    const FlatMesh<dim>         &mesh_;
    const Boundaries<dim>        boundaries_;
    std::vector<LoadedFace>      loaded_;
    std::vector<ConstrainedNode> constrained_;
    std::vector<Index>           traction_node_; ///< nodes of loaded faces, in ascending order
    /// [n_nodes] force of the sides on nodes at rest, Mbar cm^2, and what it falls by with their mean velocity in the
    /// step, g/us; empty without loaded faces.
    std::array<std::vector<double>, dim> traction_, damping_;
    std::vector<std::vector<BeyondSide>> beyond_;               ///< [side][material]
    std::vector<std::uint8_t>            node_owned_;           ///< first corner belongs to an owned cell
    bool                                 drives_nodes_ = false; ///< a side is `inflow` or `exact`
  };
} // namespace whipple
