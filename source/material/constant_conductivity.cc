// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/constant_conductivity.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>

#include <algorithm>

namespace whipple
{
  ConstantConductivity::ConstantConductivity(double conductivity)
    : conductivity_(conductivity)
  {
    require_positive(name(), "heat conductivity", conductivity, "Mbar cm^2/us/K");
  }

  void
  ConstantConductivity::evaluate(std::span<const double>, std::span<const double>, std::span<double> conductivity) const
  {
    std::fill(conductivity.begin(), conductivity.end(), conductivity_);
  }

  double
  ConstantConductivity::reference_conductivity() const
  {
    return conductivity_;
  }

  std::string
  ConstantConductivity::name() const
  {
    return "constant conductivity";
  }

  namespace
  {
    constexpr double W_per_m_K = 1e-13; // in Mbar cm^2/(us K)

    PublishedConstants
    handbook(const std::string &material, double conductivity)
    {
      return {material,
              {{"Heat conductivity", conductivity * W_per_m_K}},
              "handbook value at room temperature",
              "from memory, unverified; alloys and melts conduct two to three times less than the pure metal"};
    }

    const Registration<ConductionLaw> registration(
        {.name    = "constant conductivity",
         .summary = "Fourier's law with one conductivity",
         .documentation =
             "Heat flux -k grad T. In 20 us heat diffuses (k t / (rho c))^(1/2), 0.04 mm in aluminium: less "
             "than a cell of the shield case, so conduction is off unless a scene asks for it.",
         .constants = {{"Heat conductivity", "heat conductivity", "k of Fourier's law", Range::positive(), {}, false}},
         .source    = "Fourier's law",
         .published = {handbook("aluminium 1100-O", 222.), handbook("aluminium 2024-T4", 121.),
                       handbook("aluminium 6061-T6", 167.), handbook("aluminium 7075-T6", 130.),
                       handbook("aluminium", 237.), handbook("copper OFHC", 391.), handbook("copper", 401.),
                       handbook("tantalum", 57.), handbook("lead", 35.), handbook("zinc", 116.),
                       handbook("stainless steel 304", 16.)}},
        [](const ModelInput &c) { return std::make_shared<ConstantConductivity>(c("Heat conductivity")); });
  } // namespace
} // namespace whipple
