// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/command/model_reference.h>
#include <whipple/effect/effect.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/scene/units.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace whipple::model_reference
{
  namespace
  {
    /// A value with its unit; "infinite" for infinity.
    std::string
    formatted(const ModelConstant &constant, double value)
    {
      if (std::isinf(value))
        return "infinite";
      return units::format(value, *units::find_quantity(constant.quantity));
    }

    /// What stands in the column "unless given".
    std::string
    otherwise(const ModelConstant &constant)
    {
      if (constant.default_value)
        return formatted(constant, *constant.default_value);
      return constant.optional ? "may be left out" : constant.quantity == "text" ? "needed" : "library, or needed";
    }

    /// Unit of a constant, as scenes may write it.
    std::string
    unit(const ModelConstant &constant)
    {
      if (constant.quantity == "text")
        return "text";
      const std::string internal = units::find_quantity(constant.quantity)->unit;
      return internal.empty() ? "1" : internal;
    }

    void
    write_constants(std::ostream &text, const std::vector<ModelConstant> &constants)
    {
      if (constants.empty())
        return;
      text << "\n| constant | unit | allowed | unless given | meaning |\n|---|---|---|---|---|\n";
      for (const ModelConstant &c : constants)
        text << "| `" << c.key << "` | " << unit(c) << " | " << (c.quantity == "text" ? "" : c.range.text()) << " | "
             << otherwise(c) << " | " << c.documentation << " |\n";
    }

    const ModelConstant *
    constant_of(const ModelDescription &model, const std::string &key)
    {
      for (const ModelConstant &constant : model.constants)
        if (constant.key == key)
          return &constant;
      return nullptr;
    }

    void
    write_published(std::ostream &text, const ModelDescription &model)
    {
      if (model.published.empty())
        return;
      text << "\n| library material | constants of its own | source |\n|---|---|---|\n";
      for (const PublishedConstants &published : model.published)
        {
          text << "| " << published.material << " | ";
          bool first = true;
          for (const auto &[key, value] : published.constants)
            if (const ModelConstant *constant = constant_of(model, key))
              {
                text << (first ? "" : ", ") << key << " " << formatted(*constant, value);
                first = false;
              }
          text << " | " << published.source << (published.caution.empty() ? "" : "; " + published.caution) << " |\n";
        }
    }

    void
    write_model(std::ostream &text, const ModelDescription &model)
    {
      text << "\n### " << model.name << "\n\n" << model.summary << ". " << model.documentation << "\n";
      write_constants(text, model.constants);
      write_published(text, model);
      if (!model.source.empty())
        text << "\nSource: " << model.source << ".\n";
    }

    std::string
    booked(const BookingDescription &booking)
    {
      switch (booking.kind)
        {
        case BookingKind::converts:
          return booking.documentation + " (converted, Mbar cm^3)";
        case BookingKind::leaves:
          return booking.documentation + " (left the problem, or came in where negative)";
        case BookingKind::drops:
          return booking.documentation + " (dropped)";
        case BookingKind::notes:
          break;
        }
      return booking.documentation + " (an event, " + booking.unit + ")";
    }

    void
    write_effect(std::ostream &text, const EffectDescription &effect)
    {
      text << "\n### " << effect.name << "\n\n" << effect.summary << ". " << effect.documentation << "\n\n";
      std::string fields;
      for (const FieldDescription &field : effect.fields)
        fields += (fields.empty() ? "" : ", ") + field.name + " (" + field.unit + ", with " +
                  (field.carrier == Carrier::mass ? "mass" : "volume") + ")";
      text << "* carries: " << (fields.empty() ? "no field" : fields) << "\n";
      if (!effect.family.empty())
        text << "* needs: a material with a model under `" << effect.family << "`\n";
      for (const std::string &other : effect.requires_on)
        text << "* needs: the effect `" << other << "`\n";
      for (const BookingDescription &booking : effect.bookings)
        text << "* enters in the books: " << booked(booking) << " under `" << booking.cause << "`\n";
      if (!effect.parameters.empty())
        text << "* parameters, section `Effects/" << effect.name << "`:\n";
      write_constants(text, effect.parameters);
    }
  } // namespace

  std::string
  overview()
  {
    std::ostringstream text;
    const auto         line = [&text](const EffectDescription &effect) {
      text << "  " << std::left << std::setw(18) << effect.name << effect.summary << '\n';
    };
    text << "What a scene can switch on (Effects/List); what is off costs nothing.\n\n"
            "Options of the step, which works with them where they are on:\n";
    for (const auto &[name, option] : StepOptionRegistry::all())
      line(option);
    text << "\nEffects, each a pass after the Lagrange step, in this order:\n";
    for (const auto &[key, entry] : EffectRegistry<2>::all())
      line(entry.description);
    for (const ModelFamily &family : model_families())
      {
        text << "\n" << family.key << ", chosen by Materials/NAME/" << family.key;
        if (!family.effect.empty())
          text << ", works with the effect '" << family.effect << "'";
        text << ":\n";
        if (!family.absence.empty())
          text << "  " << std::setw(26) << "none" << family.absence << '\n';
        for (const ModelDescription &model : family.models)
          text << "  " << std::setw(26) << model.name << model.summary << '\n';
      }
    text << "\nAll constants with units, ranges, defaults and sources: whipple help models, doc/models.md\n";
    return text.str();
  }

  std::string
  markdown()
  {
    std::ostringstream text;
    text
        << "# Effects and models\n\nGenerated by `build/whipple help models > doc/models.md` from what effects and "
           "models "
           "say of themselves; a test compares. How to add one: [adding_a_model.md](adding_a_model.md).\n\n"
           "A scene lists effects under `Effects/List`; a material chooses models under `Materials/NAME`. Values carry "
           "units (`345 MPa`); the tables give the internal ones. A constant that the scene does not give comes from "
           "what "
           "the model's own source publishes for the library material, then from the library "
           "(`whipple help materials`), then from the default.\n\n## Options of the step\n\n"
           "Listed as effects are; the Lagrange step and the models of the materials work with them where they are "
           "on.\n";
    for (const auto &[name, option] : StepOptionRegistry::all())
      write_effect(text, option);
    text << "\n## Effects\n\nEach does its work in a pass after the Lagrange step, in this order.\n";
    for (const auto &[key, entry] : EffectRegistry<2>::all())
      write_effect(text, entry.description);
    for (const ModelFamily &family : model_families())
      {
        text << "\n## " << family.key << "\n\n`Materials/NAME/" << family.key << "`";
        if (!family.absence.empty())
          text << "; `none` (default): " << family.absence;
        if (!family.effect.empty())
          text << "; works with the effect `" << family.effect << "`";
        text << ".\n";
        for (const ModelDescription &model : family.models)
          write_model(text, model);
      }
    return text.str();
  }
} // namespace whipple::model_reference
