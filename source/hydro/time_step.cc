// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/closure.h>
#include <whipple/hydro/time_step.h>
#include <whipple/hydro/trace.h>
#include <whipple/hydro/velocity_gradient.h>
#include <whipple/hydro/viscosity.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace whipple
{
  namespace
  {
    constexpr double unlimited = std::numeric_limits<double>::infinity();

    /// What the time step needs to know of the materials in a pack of cells.
    struct Content
    {
      Pack::mask_type felt;    ///< holds material that is no trace
      Pack            wave;    ///< square of the fastest wave, cm^2/us^2
      Pack            pressed; ///< largest part of a compression that the materials may take, 1 without open void
    };

    /// Fastest of the materials: max(c^2, |P| / rho) + 4/3 (1 - phi) G / rho. The second term of the maximum is how
    /// fast a pressure drives matter apart whose law has no real sound speed (c = 0 there).
    template <int dim>
    Content
    content(const State<dim> &state, const Derived &derived, const StepWork<dim> &work, Index first)
    {
      const Pack volume = load(state.volume, first);
      Pack       fastest(0.), occupied(0.);
      auto       any = volume < 0.;
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState   &material = state.material[m];
          const DerivedMaterial &from     = derived.material[m];
          const auto             felt     = trace::has_state(material, work.material[m], volume, first);
          any                             = any || felt;
          occupied += load(material.volume, first);
          const Pack c = load(from.sound_speed, first), inverse_density = 1. / load(material.density, first);
          Pack       square = max(c * c, Pack(abs(load(from.pressure, first)) * inverse_density));
          if (!from.shear_modulus.empty())
            {
              Pack solid = inverse_density;
              if (material.has_voids())
                solid *= 1. - load(material.void_fraction, first);
              square += 4. / 3. * load(from.shear_modulus, first) * solid;
            }
          fastest = max(fastest, select(felt, square, Pack(0.)));
        }
      const Pack filled = occupied / volume;
      // compressed_share() under pressure, or once the void has closed, takes no more than this
      const Pack share = closure::compressed_share(filled, Pack(1e-300), Pack::mask_type(true));
      return {any, fastest, select(1. - filled > closure::closed_share, max(share, Pack(0.)), Pack(1.))};
    }

    /// What the cells of a pack allow.
    struct Allowed
    {
      Pack            dt, crossing, straining; ///< us; dt infinite where nothing is felt
      Pack            damping, sound;          ///< cm/us
      Pack            extent;                  ///< the smallest, cm
      Pack::mask_type there;
    };

    template <Symmetry symmetry, int dim>
    Allowed
    allowed(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
            const std::array<std::vector<double>, dim> &velocity, const HydroParameters &parameters,
            const StepWork<dim> &work, Index first)
    {
      using Cell = CellGeometry<dim, symmetry>;
      Allowed       result;
      const Content held = content(state, derived, work, first);
      // cold gas has no sound, but it too must not be squeezed through itself
      result.there = held.felt && lanes_below(first, mesh.n_owned);
      result.dt    = Pack(unlimited);
      if (none_of(result.there))
        return result;
      const CornerVectors<dim, Pack> x = gather_corners(mesh, state.position, first);
      const CornerVectors<dim, Pack> v = gather_corners(mesh, velocity, first);
      const auto gradient = velocity_gradient<dim>(Cell::volume_gradient(x), Cell::hoop_weight(x), Cell::volume(x), v);
      const Pack divergence = gradient.divergence(), c2 = held.wave, c = sqrt(c2);
      result.extent = Cell::smallest_extent(x);
      result.sound  = c;

      Pack jump(0.);
      for (int d = 0; d < dim; ++d)
        {
          const auto along = viscosity::stretch(d, x, v);
          jump += max(-along.rate * along.length, Pack(0.));
        }
      jump = max(jump, viscosity::thin_jump(x, v));
      result.damping =
          select(divergence < 0. && jump > 0.,
                 Pack(held.pressed * (2. * parameters.quadratic_viscosity * jump + parameters.linear_viscosity * c)),
                 Pack(0.));
      const Pack damping = result.damping;
      result.crossing    = parameters.courant * result.extent / (damping + sqrt(damping * damping + c2));
      result.straining   = parameters.max_volume_change / abs(divergence);
      result.dt          = select(result.there, Pack(min(result.crossing, result.straining)), Pack(unlimited));
      return result;
    }

    template <Symmetry symmetry, int dim>
    TimeStepLimit
    smallest_time_step(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                       const std::array<std::vector<double>, dim> &velocity, const HydroParameters &parameters,
                       const StepWork<dim> &work, std::span<const Index> exempt)
    {
      TimeStepLimit limit{unlimited, "sound", none};
      for (Index first = 0; first < mesh.n_owned; first += pack_size)
        {
          const Allowed a = allowed<symmetry, dim>(mesh, state, derived, velocity, parameters, work, first);
          if (none_of(a.dt < limit.dt))
            continue;
          for (Index lane = 0; lane < pack_size; ++lane)
            if (a.dt[lane] < limit.dt && !std::binary_search(exempt.begin(), exempt.end(), first + lane))
              limit = {a.dt[lane],
                       a.straining[lane] < a.crossing[lane]     ? "volume change"
                       : a.damping[lane] > 0.75 * a.sound[lane] ? "viscosity"
                                                                : "sound",
                       first + lane};
        }
      return limit;
    }

    template <Symmetry symmetry, int dim>
    std::vector<Index>
    thin_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
               const HydroParameters &parameters, const StepWork<dim> &work, double bound)
    {
      constexpr double   thin = 1. / 25; // smallest extent over the longest side
      std::vector<Index> cells;
      for (Index first = 0; first < mesh.n_owned; first += pack_size)
        {
          const Allowed a = allowed<symmetry, dim>(mesh, state, derived, state.velocity, parameters, work, first);
          if (none_of(a.dt < bound))
            continue;
          const CornerVectors<dim, Pack> x    = gather_corners(mesh, state.position, first);
          const Pack                     area = abs(CellShape<dim>::area(x));
          // the extent is the area over the longest side
          for (Index lane = 0; lane < pack_size; ++lane)
            if (a.dt[lane] < bound && a.extent[lane] * a.extent[lane] < thin * area[lane])
              cells.push_back(first + lane);
        }
      return cells;
    }
  } // namespace

  template <int dim>
  TimeStepLimit
  find_time_step(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                 const std::array<std::vector<double>, dim> &velocity, const HydroParameters &parameters,
                 const StepWork<dim> &work, std::span<const Index> exempt)
  {
    if (mesh.symmetry == Symmetry::planar)
      return smallest_time_step<Symmetry::planar, dim>(mesh, state, derived, velocity, parameters, work, exempt);
    return smallest_time_step<Symmetry::axisymmetric, dim>(mesh, state, derived, velocity, parameters, work, exempt);
  }

  template <int dim>
  std::vector<Index>
  find_slivers(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
               const HydroParameters &parameters, const StepWork<dim> &work, double bound)
  {
    if (mesh.symmetry == Symmetry::planar)
      return thin_cells<Symmetry::planar, dim>(mesh, state, derived, parameters, work, bound);
    return thin_cells<Symmetry::axisymmetric, dim>(mesh, state, derived, parameters, work, bound);
  }

  template TimeStepLimit
  find_time_step<2>(const FlatMesh<2> &, const State<2> &, const Derived &, const std::array<std::vector<double>, 2> &,
                    const HydroParameters &, const StepWork<2> &, std::span<const Index>);
  template std::vector<Index>
  find_slivers(const FlatMesh<2> &, const State<2> &, const Derived &, const HydroParameters &, const StepWork<2> &,
               double);
} // namespace whipple
