// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/phase_constants.h>
#include <whipple/material/steinberg_constants.h>

namespace whipple
{
  namespace
  {
    constexpr double MJ_per_kg = 0.01; // in Mbar cm^3/g

    struct Phases
    {
      double      melting_point, heat_of_fusion, boiling_point, heat_of_vaporisation; // K, MJ/kg
      const char *source;
      const char *caution;
    };

    constexpr const char *handbook  = "handbook values of the element";
    constexpr const char *unchecked = "from memory, not checked against a handbook";

    // Constant expressions: models register before main(), in no order.
    constexpr Phases aluminium{
        933.5,
        0.398,
        2792.,
        10.9,
        "heat of fusion: Thompson and Lauson, SC-RR-71 0714 (1972); the rest: handbook values",
        "those of the pure metal (its alloys melt over a range below, 7075 from 750 K); all but the "
        "heat of fusion from memory, not checked against a handbook"};
    constexpr Phases beryllium{
        1560., 0.876,    2742.,
        33.,   handbook, "from memory, not checked against a handbook; heats of fusion up to 1.35 MJ/kg are in use"};
    constexpr Phases cadmium{594.2, 0.0552, 1040., 0.888, handbook, unchecked};
    constexpr Phases copper{1357.8,
                            0.2055,
                            2835.,
                            4.73,
                            "heat of fusion: Thompson and Lauson, SC-RR-71 0714 (1972); the rest: handbook values",
                            "all but the heat of fusion from memory, not checked against a handbook"};
    constexpr Phases lead{600.6, 0.0230, 2022., 0.866, handbook, unchecked};
    constexpr Phases steel{1700.,
                           0.26,
                           3134.,
                           6.09,
                           "handbook values; boiling: of iron",
                           "middle of the melting range, 1670 to 1730 K; from memory, not checked against a handbook"};
    constexpr Phases tantalum{3290., 0.202, 5731., 4.05, handbook, unchecked};
    constexpr Phases zinc{692.7, 0.112, 1180., 1.76, handbook, unchecked};

    PublishedConstants
    published(const std::string &material, const Phases &phases)
    {
      return {material,
              {{"Melting point", phases.melting_point},
               {"Heat of fusion", phases.heat_of_fusion * MJ_per_kg},
               {"Boiling point", phases.boiling_point},
               {"Heat of vaporisation", phases.heat_of_vaporisation * MJ_per_kg},
               {"Grueneisen volume correction", steinberg_constants(material).volume_correction}},
              phases.source,
              phases.caution};
    }
  } // namespace

  std::vector<PublishedConstants>
  phase_constants()
  {
    return {published("aluminium 1100-O", aluminium),
            published("aluminium 2024-T4", aluminium),
            published("aluminium 6061-T6", aluminium),
            published("aluminium 7075-T6", aluminium),
            published("beryllium S-200", beryllium),
            published("cadmium", cadmium),
            published("copper OFHC", copper),
            published("lead", lead),
            published("stainless steel 304", steel),
            published("tantalum", tantalum),
            published("zinc", zinc)};
  }
} // namespace whipple
