// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/cell_kernels.h>
#include <whipple/hydro/hydro_parameters.h>
#include <whipple/hydro/material_passes.h>
#include <whipple/hydro/node_motion.h>
#include <whipple/hydro/time_step.h>
#include <whipple/material/material.h>
#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/bookings.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <span>
#include <vector>

namespace whipple
{
  /// What one Lagrange step transformed and exchanged, summed over owned cells; energies in Mbar cm^3. bookings() is
  /// how it goes into the ledger.
  template <int dim>
  struct LagrangeSums
  {
    double      viscous_work   = 0;  ///< kinetic energy turned into heat by the artificial viscosity
    double      hourglass_work = 0;  ///< kinetic energy turned into heat by the hourglass resistance
    double      plastic_work   = 0;  ///< work of the deviatoric stress on the plastic strain rate
    double      boundary_work  = 0;  ///< energy that the sides gave to the material
    Vector<dim> boundary_momentum{}; ///< g cm/us that the sides gave; radial entry without meaning in r, z

    Bookings<dim>
    bookings() const;
  };

  /// Set state.volume [n_cells] and state.corner_weight [n_cells * corners] from state.position.
  /// @throws StateError if an owned cell has no positive volume.
  template <int dim>
  void
  initialise_geometry(const FlatMesh<dim> &mesh, State<dim> &state);

  /// The compatible staggered Lagrange step on a FlatMesh: the nodes move with the material, internal energy
  /// comes from the work of the very forces that accelerate them, so total energy holds to round-off.
  ///
  /// One object belongs to one mesh; it owns all work arrays, so a step allocates nothing. What a method does depends
  /// on its arguments alone, never on what was called before. All methods run over owned and halo cells; only owned
  /// cells are reported and can throw.
  template <int dim>
  class LagrangeStep
  {
  public:
    /// mesh and materials are kept by reference and must outlive the object.
    LagrangeStep(const FlatMesh<dim> &mesh, const std::vector<Material> &materials, const Boundaries<dim> &boundaries,
                 const HydroParameters &parameters);

    /// Lumped node masses, g: corner weights times the mass of the cell; hanging nodes give theirs to
    /// their masters.
    void
    update_node_mass(State<dim> &state) const;

    /// All that follows from a state, in every cell: pressures, sound speeds, shear moduli, yield stresses, and strain
    /// rates if a strength model asks for them. Nothing is allocated but in the first call for a Derived.
    /// @throws StateError if a material has strength but the state lacks its fields.
    void
    evaluate(const State<dim> &state, Derived &derived);

    /// The parts of evaluate(): pressures and sound speeds alone; then, from those of the same state, the rest.
    void
    evaluate_pressure(const State<dim> &state, Derived &derived);
    void
    evaluate_strength(const State<dim> &state, Derived &derived);

    /// The largest time step that the owned cells allow, but for those that keep their shape.
    /// @param derived of this state
    TimeStepLimit
    time_step(const State<dim> &state, const Derived &derived, std::span<const Index> exempt = {});

    /// find_slivers()
    std::vector<Index>
    slivers(const State<dim> &state, const Derived &derived, double bound) const;

    /// Move the state by dt [us]. Strong guarantee: when it throws, the state is as before.
    /// @param derived of the state before the step
    /// @param rigid elements that keep their shape
    /// @throws StateError if the volume of an owned cell or of a material in it would not stay positive.
    LagrangeSums<dim>
    advance(State<dim> &state, const Derived &derived, double dt, std::span<const RigidFragment<dim>> rigid = {});

    /// What the last advance() started from, where it has successors: volumes, densities, energies, stresses and
    /// plastic strains of the materials, positions and velocities of the nodes.
    const StepWork<dim> &
    before() const
    {
      return work_;
    }

  private:
    /// Swap the next values into the state.
    void
    commit(State<dim> &state, double dt);

    const FlatMesh<dim>         &mesh_;
    const std::vector<Material> &materials_;
    HydroParameters              parameters_;
    NodeMotion<dim>              motion_;
    StepWork<dim>                work_;
    material_passes::Scratch     scratch_;
    bool                         needs_strain_rate_; ///< a strength model does
  };
} // namespace whipple
