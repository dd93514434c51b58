// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>

#include <map>
#include <set>

namespace whipple
{
  namespace
  {
    // The table is typed in the units of its sources.
    constexpr double kg_per_m3  = 1e-3; // in g/cm^3
    constexpr double m_per_s    = 1e-4; // in cm/us
    constexpr double GPa        = 1e-2; // in Mbar
    constexpr double J_per_kg_K = 1e-8; // in Mbar cm^3/(g K)
    const char      *steinberg  = "Steinberg, UCRL-MA-106439, as typed in the Uintah material files";

    std::vector<MaterialConstants>
    make_library()
    {
      return {
          {"aluminium 1100-O", 2707. * kg_per_m3, 5386. * m_per_s, 1.339, 1.97, 27.1 * GPa, 0.04 * GPa,
           884. * J_per_kg_K, 1220., steinberg,
           "yield stress 0.04 GPa: the Uintah file has 0.40, almost certainly a slip (pyBLOSSUM lists 34 MPa)"},
          {"aluminium 2024-T4", 2785. * kg_per_m3, 5328. * m_per_s, 1.338, 2.00, 28.6 * GPa, 0.26 * GPa,
           863. * J_per_kg_K, 1220., steinberg, ""},
          {"aluminium 6061-T6", 2703. * kg_per_m3, 5240. * m_per_s, 1.40, 1.97, 27.6 * GPa, 0.29 * GPa,
           885. * J_per_kg_K, 1220., steinberg, ""},
          {"aluminium 7075-T6", 2803. * kg_per_m3, 5200. * m_per_s, 1.36, 2.20, 26.7 * GPa, 0.42 * GPa,
           848. * J_per_kg_K, 1220., steinberg, ""},
          {"beryllium S-200", 1850. * kg_per_m3, 8000. * m_per_s, 1.124, 1.11, 151. * GPa, 0.33 * GPa,
           1820. * J_per_kg_K, 1820., steinberg, ""},
          {"cadmium", 8639. * kg_per_m3, 2480. * m_per_s, 1.64, 2.50, 24. * GPa, 0.04 * GPa, 231. * J_per_kg_K, 770.,
           steinberg, ""},
          {"copper OFHC", 8930. * kg_per_m3, 3940. * m_per_s, 1.489, 2.02, 47.7 * GPa, 0.12 * GPa, 383. * J_per_kg_K,
           1790., steinberg, ""},
          {"lead", 11350. * kg_per_m3, 2051. * m_per_s, 1.46, 2.77, 8.6 * GPa, 0.008 * GPa, 124. * J_per_kg_K, 760.,
           "density, c0, s, Gamma0: Thompson and Lauson, SC-RR-71 0714 (1972); the rest: Steinberg, UCRL-MA-106439",
           "Steinberg's own Hugoniot of lead is cubic (s1 1.429, s2 0.8506, s3 -1.64) and cannot be used in part"},
          {"stainless steel 304", 7900. * kg_per_m3, 4570. * m_per_s, 1.49, 1.93, 77. * GPa, 0.34 * GPa,
           423. * J_per_kg_K, 2380., steinberg, "specific heat from memory, unverified"},
          {"tantalum", 16690. * kg_per_m3, 3410. * m_per_s, 1.20, 1.67, 69. * GPa, 0.77 * GPa, 135. * J_per_kg_K, 4340.,
           steinberg, ""},
          {"zinc", 7139. * kg_per_m3, 3030. * m_per_s, 1.55, 2.24, 39.5 * GPa, 0.15 * GPa, 389. * J_per_kg_K, 900.,
           steinberg, ""},
      };
    }
  } // namespace

  const std::vector<MaterialConstants> &
  material_library()
  {
    static const std::vector<MaterialConstants> library = make_library();
    return library;
  }

  std::optional<double>
  MaterialConstants::find(const std::string &key) const
  {
    static const std::map<std::string, double MaterialConstants::*> members{
        {"Density", &MaterialConstants::density},
        {"Sound speed", &MaterialConstants::sound_speed},
        {"Hugoniot slope", &MaterialConstants::hugoniot_slope},
        {"Grueneisen coefficient", &MaterialConstants::grueneisen},
        {"Shear modulus", &MaterialConstants::shear_modulus},
        {"Yield stress", &MaterialConstants::yield_stress},
        {"Specific heat", &MaterialConstants::specific_heat},
        {"Melt temperature", &MaterialConstants::melt_temperature},
    };
    const auto member = members.find(key);
    return member == members.end() ? std::nullopt : std::optional<double>(this->*member->second);
  }

  const MaterialConstants *
  find_in_library(const std::string &name)
  {
    for (const MaterialConstants &constants : material_library())
      if (constants.name == name)
        return &constants;
    return nullptr;
  }

  const MaterialConstants &
  find_material(const std::string &name)
  {
    if (const MaterialConstants *constants = find_in_library(name))
      return *constants;
    std::string list;
    for (const std::string &known : material_names())
      list += (list.empty() ? "" : ", ") + known;
    throw InputError("no material '" + name + "' in the library; there are: " + list);
  }

  std::vector<std::string>
  material_names()
  {
    std::set<std::string> names;
    for (const MaterialConstants &constants : material_library())
      names.insert(constants.name);
    for (const ModelFamily &family : model_families())
      for (const ModelDescription &model : family.models)
        for (const PublishedConstants &published : model.published)
          names.insert(published.material);
    return {names.begin(), names.end()};
  }

  double
  temperature_rise(const MaterialConstants &constants, double energy_rise)
  {
    return energy_rise / constants.specific_heat;
  }
} // namespace whipple
