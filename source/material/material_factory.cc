// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/isothermal.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/material/model_registry.h>

#include <algorithm>
#include <sstream>

namespace whipple
{
  namespace
  {
    template <class Family>
    std::vector<ModelDescription>
    descriptions()
    {
      std::vector<ModelDescription> result;
      for (const auto &[name, entry] : ModelRegistry<Family>::all())
        result.push_back(entry.description);
      return result;
    }

    /// The chosen model of a family; null for "none". `other` are the models of the material that are made already.
    template <class Family>
    std::shared_ptr<const Family>
    make_model(const std::string &name, const MaterialRequest &request, const Material &other)
    {
      if (name == "none")
        return nullptr;
      const auto &entry = ModelRegistry<Family>::all().at(name);
      ModelInput  input(entry.description, request);
      input.equation_of_state = other.eos;
      input.thermal           = other.thermal;
      return entry.make(input);
    }

    /// The models that a request chose.
    /// @throws InputError for a name that its family does not have.
    std::vector<const ModelDescription *>
    chosen_models(const MaterialRequest &request)
    {
      std::vector<const ModelDescription *> chosen;
      for (const ModelFamily &family : model_families())
        if (const ModelDescription *model = chosen_model(family, request))
          chosen.push_back(model);
      return chosen;
    }

    /// A constant that no chosen model reads is a misunderstanding: say so instead of ignoring it.
    void
    reject_unused(const MaterialRequest &request, const std::vector<const ModelDescription *> &models)
    {
      const auto check = [&](const std::string &key, const auto &value) {
        std::string chosen;
        for (const ModelDescription *model : models)
          {
            for (const ModelConstant &constant : model->constants)
              if (constant.key == key)
                return;
            chosen += (chosen.empty() ? "'" : ", '") + model->name + "'";
          }
        std::ostringstream message;
        message << key << " = " << value << ": no use to the models chosen (" << chosen << "): leave it out";
        throw InputError(message.str());
      };
      for (const auto &[key, value] : request.constants)
        check(key, value);
      for (const auto &[key, value] : request.texts)
        check(key, value);
    }

    /// Models that need another one, or that contradict each other.
    void
    check_together(const Material &material)
    {
      if (material.failure && material.failure->needs_strength() && !material.strength)
        throw InputError("failure = '" + material.failure->name() + "': needs a strength model");
      if (material.failure && material.failure->needs_voids() && !material.void_law)
        throw InputError("failure = '" + material.failure->name() + "': needs a void law");
      if (material.fragments && !material.void_law)
        throw InputError("fragments = '" + material.fragments->name() + "': needs a void law that lets material open");
      if (material.conduction && !material.thermal)
        throw InputError("heat conduction = '" + material.conduction->name() + "': needs a thermal model");
      if (material.conduction && material.isothermal)
        throw InputError("isothermal = true with heat conduction = '" + material.conduction->name() +
                         "': a pressure that does not feel the energy leaves nothing to conduct; choose one");
    }

    /// Where the constants of a material come from.
    std::string
    sources(const MaterialRequest &request, const std::vector<const ModelDescription *> &models)
    {
      if (request.library.empty())
        return "the scene";
      std::vector<std::string> all;
      if (const MaterialConstants *general = find_in_library(request.library))
        all.push_back(general->source);
      for (const ModelDescription *model : models)
        for (const PublishedConstants &published : model->published)
          if (published.material == request.library && std::find(all.begin(), all.end(), published.source) == all.end())
            all.push_back(published.source);
      std::string text;
      for (const std::string &source : all)
        text += (text.empty() ? "" : "; ") + source;
      return text;
    }
  } // namespace

  const std::vector<ModelFamily> &
  model_families()
  {
    using Request = MaterialRequest;
    static const std::vector<ModelFamily> families{
        {"Equation of state", &Request::equation_of_state, "", "", descriptions<EquationOfState>()},
        {"Thermal model", &Request::thermal_model, "", "no temperature", descriptions<ThermalModel>()},
        {"Strength", &Request::strength, "strength", "hydrodynamic", descriptions<Strength>()},
        {"Void law", &Request::void_law, "voids", "no voids, and no field for them", descriptions<VoidLaw>()},
        {"Failure", &Request::failure, "failure", "no damage", descriptions<FailureModel>()},
        {"Fragments", &Request::fragments, "fragment size", "no fragment sizes", descriptions<FragmentModel>()},
        {"Conduction", &Request::conduction, "heat conduction", "adiabatic", descriptions<ConductionLaw>()},
    };
    return families;
  }

  const ModelDescription *
  chosen_model(const ModelFamily &family, const MaterialRequest &request)
  {
    const std::string &name = request.*family.choice;
    if (name == "none" && !family.absence.empty())
      return nullptr;
    for (const ModelDescription &model : family.models)
      if (model.name == name)
        return &model;
    std::string allowed = family.absence.empty() ? "" : "none";
    for (const ModelDescription &model : family.models)
      allowed += (allowed.empty() ? "" : " | ") + model.name;
    throw InputError(family.key + " = '" + name + "': must be " + allowed);
  }

  std::vector<ModelConstant>
  all_model_constants()
  {
    std::vector<ModelConstant> all;
    for (const ModelFamily &family : model_families())
      for (const ModelDescription &model : family.models)
        for (const ModelConstant &constant : model.constants)
          if (std::none_of(all.begin(), all.end(), [&](const ModelConstant &c) { return c.key == constant.key; }))
            all.push_back(constant);
    return all;
  }

  std::optional<double>
  published_constant(const ModelDescription &model, const std::string &material, const std::string &key)
  {
    for (const PublishedConstants &published : model.published)
      if (published.material == material)
        if (const auto found = published.constants.find(key); found != published.constants.end())
          return found->second;
    if (const MaterialConstants *general = find_in_library(material))
      return general->find(key);
    return std::nullopt;
  }

  Material
  make_material(const MaterialRequest &request)
  {
    if (!request.library.empty())
      {
        const std::vector<std::string> names = material_names();
        if (std::find(names.begin(), names.end(), request.library) == names.end())
          find_material(request.library);
      }
    const std::vector<const ModelDescription *> models = chosen_models(request);
    reject_unused(request, models);

    Material material;
    material.name       = request.name.empty() ? request.library : request.name;
    material.source     = sources(request, models);
    material.eos        = make_model<EquationOfState>(request.equation_of_state, request, material);
    material.thermal    = make_model<ThermalModel>(request.thermal_model, request, material);
    material.strength   = make_model<Strength>(request.strength, request, material);
    material.void_law   = make_model<VoidLaw>(request.void_law, request, material);
    material.failure    = make_model<FailureModel>(request.failure, request, material);
    material.fragments  = make_model<FragmentModel>(request.fragments, request, material);
    material.conduction = make_model<ConductionLaw>(request.conduction, request, material);
    material.isothermal = request.isothermal;
    check_together(material);
    if (request.isothermal)
      material.eos = std::make_shared<IsothermalEquationOfState>(material.eos);
    return material;
  }
} // namespace whipple
