// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/p_alpha_void_law.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/pore_crush.h>
#include <whipple/material/void_relaxation.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace whipple
{
  namespace
  {
    using Block = std::array<double, crush_block_length>;

    std::span<double>
    first(Block &block, std::size_t n)
    {
      return std::span<double>(block).first(n);
    }

    /// Where phi exceeds phi0 by less than this share, it is phi0 that a remap has rounded, not loosened material.
    constexpr double rounding_of_remap = 1e-9;

    CrushCurve
    crush_curve(const PAlphaVoidLaw::Constants &c)
    {
      return {c.initial_porosity / (1. - c.initial_porosity), (1. + rounding_of_remap) * c.initial_porosity,
              c.full_compaction_pressure, c.full_compaction_pressure - c.elastic_crush_pressure};
    }

    /// P_s of a block of cells at the void fractions they have.
    void
    solid_pressure(const EquationOfState &eos, std::span<const double> rho, std::span<const double> energy,
                   std::span<const double> phi, Block &pressure)
    {
      const std::size_t n                 = rho.size();
      const double      reference_density = eos.reference_density(), limit = largest_trial_density(eos);
      Block             true_density, sound_speed_squared;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double g  = rho[i] / (1. - phi[i]);
          true_density[i] = rho[i] > 0. ? std::min(g, limit) : reference_density;
        }
      eos.evaluate(first(true_density, n), energy, first(pressure, n), first(sound_speed_squared, n));
    }

    /// Pores in tension beyond the threshold open to P_s = 0; what is looser than phi0 closes towards phi0.
    /// @param threshold of a cell: the pressure of the solid below which it opens.
    template <class Threshold>
    void
    open_pores(const EquationOfState &eos, double loose, double initial_porosity, const Threshold &threshold,
               std::span<const double> rho, std::span<const double> energy, const Block &pressure,
               std::span<double> phi)
    {
      Block                                       loose_rho, loose_energy, loose_phi;
      std::array<std::size_t, crush_block_length> cell;
      std::size_t                                 count = 0;
      for (std::size_t i = 0; i < rho.size(); ++i)
        if (rho[i] > 0. && (phi[i] > loose || pressure[i] < threshold(i)))
          {
            cell[count]         = i;
            loose_rho[count]    = rho[i];
            loose_energy[count] = energy[i];
            loose_phi[count++]  = phi[i];
          }
      relax_void_fraction(eos, std::numeric_limits<double>::infinity(), 0.,
                          {first(loose_rho, count), first(loose_energy, count), {}}, first(loose_phi, count));
      for (std::size_t k = 0; k < count; ++k)
        phi[cell[k]] = std::max(loose_phi[k], std::min(phi[cell[k]], initial_porosity));
    }

    /// @param threshold of a cell: the pressure of the solid below which it opens.
    template <class Threshold>
    void
    advance_block(const EquationOfState &eos, const PAlphaVoidLaw::Constants &constants, const Threshold &threshold,
                  std::span<const double> rho, std::span<const double> energy, std::span<double> phi)
    {
      const CrushCurve curve = crush_curve(constants);
      Block            pressure;
      solid_pressure(eos, rho, energy, phi, pressure);

      long opens = 0, crushes = 0;
      for (std::size_t i = 0; i < rho.size(); ++i)
        {
          opens += static_cast<long>((rho[i] > 0.) & ((phi[i] > curve.loose) | (pressure[i] < threshold(i))));
          crushes += static_cast<long>((rho[i] > 0.) & curve.crushes(phi[i], pressure[i]));
        }
      if (opens + crushes == 0)
        return;
      if (opens > 0)
        {
          open_pores(eos, curve.loose, constants.initial_porosity, threshold, rho, energy, pressure, phi);
          solid_pressure(eos, rho, energy, phi, pressure);
        }
      crush_pores(eos, curve, rho, energy, first(pressure, rho.size()), phi);
    }
  } // namespace

  PAlphaVoidLaw::PAlphaVoidLaw(const Constants &constants)
    : constants_(constants)
  {
    require_not_negative(name(), "elastic crush pressure", constants.elastic_crush_pressure, "Mbar");
    require_positive(name(), "full compaction pressure", constants.full_compaction_pressure, "Mbar");
    std::ostringstream message;
    if (!(constants.initial_porosity > 0. && constants.initial_porosity < 1.))
      message << name() << ": initial porosity = " << constants.initial_porosity << ": must be > 0 and < 1";
    else if (!(constants.full_compaction_pressure > constants.elastic_crush_pressure))
      message << name() << ": full compaction pressure = " << constants.full_compaction_pressure
              << " Mbar: must be above the elastic crush pressure, " << constants.elastic_crush_pressure << " Mbar";
    else if (!(constants.spall_strength >= 0.)) // infinity has a meaning: the pores never open
      message << name() << ": spall strength = " << constants.spall_strength << " Mbar: must be >= 0";
    else
      return;
    throw InputError(message.str());
  }

  void
  PAlphaVoidLaw::advance(const EquationOfState &eos, double, const VoidInput &state,
                         std::span<double> void_fraction) const
  {
    for (std::size_t start = 0; start < state.bulk_density.size(); start += crush_block_length)
      {
        const std::size_t n        = std::min(crush_block_length, state.bulk_density.size() - start);
        const double      strength = constants_.spall_strength;
        const auto        advance  = [&](const auto &threshold) {
          advance_block(eos, constants_, threshold, state.bulk_density.subspan(start, n),
                                state.energy.subspan(start, n), void_fraction.subspan(start, n));
        };
        if (state.soundness.empty())
          advance([negative = -strength](std::size_t) { return negative; });
        else
          advance([strength, soundness = state.soundness.subspan(start, n)](std::size_t i) {
            return opening_pressure(strength, soundness[i]);
          });
      }
  }

  double
  PAlphaVoidLaw::initial_void_fraction() const
  {
    return constants_.initial_porosity;
  }

  double
  PAlphaVoidLaw::yielding(const EquationOfState &) const
  {
    return 0.;
  }

  std::string
  PAlphaVoidLaw::name() const
  {
    return "p-alpha";
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {.name    = "p-alpha",
              .summary = "porous material that crushes along the curve alpha(P) of Herrmann",
              .documentation =
                  "Distension alpha = 1 / (1 - phi) follows the bulk pressure P along the crush curve "
                  "alpha = 1 + (alpha0 - 1) [(P_c - P) / (P_c - P_e)]^2 and never comes back under pressure; below the "
                  "curve "
                  "it is frozen, so sound in porous material is as fast as in the solid. Bodies start with the initial "
                  "porosity. Tension of the solid beyond the spall strength opens pores as the law 'equilibrium' does; "
                  "material looser than it was at first closes to its initial porosity without resistance.",
              .constants = {{"Initial porosity",
                             "pure number",
                             "phi0 of bodies that enter the scene, > 0 and < 1",
                             Range::fraction(),
                             {},
                             false},
                            {"Elastic crush pressure",
                             "pressure",
                             "P_e: bulk pressure at which pores begin to crush",
                             Range::not_negative(),
                             {},
                             false},
                            {"Full compaction pressure",
                             "pressure",
                             "P_c: bulk pressure at which no pore is left; above P_e",
                             Range::positive(),
                             {},
                             false},
                            {"Spall strength", "pressure", "tension of the solid beyond which pores open",
                             Range::not_negative_or_infinite(), std::numeric_limits<double>::infinity(), false}},
              .source    = "W. Herrmann, J. Appl. Phys. 40 (1969) 2490-2499; doc/theory/voids.md",
              .published = {}};
    }

    const Registration<VoidLaw> registration(description(), [](const ModelInput &c) {
      return std::make_shared<PAlphaVoidLaw>(PAlphaVoidLaw::Constants{
          c("Initial porosity"), c("Elastic crush pressure"), c("Full compaction pressure"), c("Spall strength")});
    });
  } // namespace
} // namespace whipple
