// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/material_library.h>
#include <whipple/scene/sections.h>

#include <algorithm>
#include <array>
#include <limits>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Materials";

    enum class Sign
    {
      any,
      not_negative,
      positive
    };

    /// A constant that a scene may give in place of the library's.
    struct Constant
    {
      const char           *key;
      units::Quantity       quantity;
      Sign                  sign;
      std::optional<double> MaterialRequest::*request;
      const char                             *documentation;
    };

    const std::array constants{
        Constant{"Density", units::density, Sign::positive, &MaterialRequest::density,
                 "gamma0, at zero pressure and energy"},
        Constant{"Sound speed", units::velocity, Sign::positive, &MaterialRequest::sound_speed, "c0 of Us = c0 + s up"},
        Constant{"Hugoniot slope", units::number, Sign::not_negative, &MaterialRequest::hugoniot_slope,
                 "s of Us = c0 + s up"},
        Constant{"Grueneisen coefficient", units::number, Sign::not_negative, &MaterialRequest::grueneisen, "Gamma0"},
        Constant{"Adiabatic exponent", units::number, Sign::positive, &MaterialRequest::adiabatic_exponent,
                 "gamma of a gas"},
        Constant{"C1", units::pressure, Sign::any, &MaterialRequest::c1, "linear polynomial"},
        Constant{"C2", units::pressure, Sign::any, &MaterialRequest::c2, "linear polynomial"},
        Constant{"C3", units::pressure, Sign::any, &MaterialRequest::c3, "linear polynomial"},
        Constant{"C4", units::number, Sign::any, &MaterialRequest::c4, "linear polynomial"},
        Constant{"C5", units::number, Sign::any, &MaterialRequest::c5, "linear polynomial"},
        Constant{"C6", units::number, Sign::any, &MaterialRequest::c6, "linear polynomial"},
        Constant{"Shear modulus", units::pressure, Sign::positive, &MaterialRequest::shear_modulus, "G of the solid"},
        Constant{"Yield stress", units::pressure, Sign::not_negative, &MaterialRequest::yield_stress,
                 "Y in simple tension"},
        Constant{"Hardening modulus", units::pressure, Sign::not_negative, &MaterialRequest::hardening_modulus,
                 "dY / d(plastic strain)"},
    };

    std::vector<std::string>
    names_of(const std::vector<ModelKind> &kinds)
    {
      std::vector<std::string> names;
      for (const ModelKind &kind : kinds)
        names.push_back(kind.name);
      return names;
    }

    /// "a | b | c"
    std::string
    alternatives(const std::vector<ModelKind> &kinds)
    {
      std::string text;
      for (const ModelKind &kind : kinds)
        text += (text.empty() ? "" : " | ") + kind.name;
      return text;
    }

    std::string
    read_kind(const SceneSection &section, const std::string &key, const std::vector<ModelKind> &kinds)
    {
      const std::vector<std::string> names = names_of(kinds);
      return names[section.name_index(key, section.text(key), names)];
    }

    double
    read_constant(const SceneSection &section, const Constant &constant)
    {
      if (constant.sign == Sign::positive)
        return section.positive(constant.key, constant.quantity);
      if (constant.sign == Sign::not_negative)
        return section.non_negative(constant.key, constant.quantity);
      return section.quantity(constant.key, constant.quantity);
    }

    double
    non_negative_or_infinite(const SceneSection &section, const std::string &key, const units::Quantity &quantity)
    {
      if (section.text(key) == "infinite")
        return std::numeric_limits<double>::infinity();
      return section.non_negative(key, quantity);
    }

    /// Constants that library material and chosen models determine, made explicit in request and parameters.
    void
    fill_from_library(const SceneSection &section, MaterialRequest &request)
    {
      const MaterialConstants &library = find_material(request.library);
      const auto               fill    = [&](std::optional<double> MaterialRequest::*constant, double value) {
        if (request.*constant)
          return;
        request.*constant = value;
        const auto entry =
            std::find_if(constants.begin(), constants.end(), [&](const Constant &c) { return c.request == constant; });
        section.replace(entry->key, units::format(value, entry->quantity));
      };
      if (request.equation_of_state == "mie-grueneisen")
        {
          fill(&MaterialRequest::density, library.density);
          fill(&MaterialRequest::sound_speed, library.sound_speed);
          fill(&MaterialRequest::hugoniot_slope, library.hugoniot_slope);
          fill(&MaterialRequest::grueneisen, library.grueneisen);
        }
      if (request.strength != "none")
        {
          fill(&MaterialRequest::shear_modulus, library.shear_modulus);
          fill(&MaterialRequest::yield_stress, library.yield_stress);
        }
    }

    MaterialRequest
    read_request(const SceneSection &section, const std::string &name)
    {
      MaterialRequest request;
      request.library = section.text("Library");
      if (request.library.empty())
        request.name = name;
      else
        section.name_index("Library", request.library, material_names());
      request.equation_of_state = read_kind(section, "Equation of state", equation_of_state_kinds());
      request.strength          = read_kind(section, "Strength", strength_kinds());
      request.void_law          = read_kind(section, "Void law", void_law_kinds());
      for (const Constant &constant : constants)
        if (section.given(constant.key))
          request.*constant.request = read_constant(section, constant);
      request.alpha          = non_negative_or_infinite(section, "Alpha", units::void_rate);
      request.spall_strength = non_negative_or_infinite(section, "Spall strength", units::pressure);
      request.isothermal     = section.choice<bool>("Isothermal", {{"false", false}, {"true", true}});
      return request;
    }
  } // namespace

  void
  declare_materials(SceneParameters &parameters, const std::vector<std::string> &names)
  {
    SceneSection(parameters, path).declare("List", "", "names of the materials; each has its subsection below");
    for (const std::string &name : names)
      {
        SceneSection section(parameters, path + "/" + name);
        section.declare("Library", "", "material whose published constants fill what is not given here");
        section.declare("Equation of state", "mie-grueneisen", alternatives(equation_of_state_kinds()));
        section.declare("Strength", "none", alternatives(strength_kinds()));
        section.declare("Void law", "none", alternatives(void_law_kinds()));
        for (const Constant &constant : constants)
          section.declare(constant.key, "", constant.documentation);
        section.declare("Alpha", "1000 us/cm^2", "rate of the void law; or 'infinite'");
        section.declare("Spall strength", "0 GPa", "tension below which no void opens; or 'infinite'");
        section.declare("Isothermal", "false", "true: the pressure does not feel the energy (1993)");
      }
  }

  std::vector<SceneMaterial>
  read_materials(SceneParameters &parameters, const std::vector<std::string> &effects)
  {
    const auto wanted = [&](const char *effect) {
      return std::find(effects.begin(), effects.end(), effect) != effects.end();
    };
    std::vector<SceneMaterial> materials;
    for (const std::string &name : SceneSection(parameters, path).list("List"))
      {
        const SceneSection section(parameters, path + "/" + name);
        SceneMaterial      material{name, read_request(section, name), {}};
        try
          {
            material.model = make_material(material.request);
          }
        catch (const InputError &error)
          {
            section.reject("Equation of state", error.what());
          }
        if (!material.request.library.empty())
          fill_from_library(section, material.request);
        if (!wanted("strength"))
          material.model.strength = nullptr;
        if (!wanted("voids"))
          material.model.void_law = nullptr;
        materials.push_back(material);
      }

    const SceneSection list(parameters, "Effects");
    const auto         none_has = [&](const auto &model) {
      return std::none_of(materials.begin(), materials.end(),
                                  [&](const SceneMaterial &m) { return model(m) != nullptr; });
    };
    if (wanted("strength") && none_has([](const SceneMaterial &m) { return m.model.strength.get(); }))
      list.reject("List", "'strength' needs a material with a strength model; set Materials/NAME/Strength");
    if (wanted("voids") && none_has([](const SceneMaterial &m) { return m.model.void_law.get(); }))
      list.reject("List", "'voids' needs a material with a void law; set Materials/NAME/Void law");
    return materials;
  }
} // namespace whipple::sections
