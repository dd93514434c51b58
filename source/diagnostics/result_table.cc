// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/result_table.h>
#include <whipple/problem/field_layout.h>
#include <whipple/scene/plate_shape.h>

#include <variant>

namespace whipple
{
  ResultTable
  plate_results(const std::optional<PlateMeasure> &measure, double time)
  {
    const PlateMeasure m = measure.value_or(PlateMeasure{});
    ResultTable        results{{"perforated", m.perforated},          {"perforation_margin_cm", m.perforation_margin},
                        {"hole_diameter_cm", m.hole_diameter}, {"smallest_hole_diameter_cm", m.smallest_hole_diameter},
                        {"crater_depth_cm", m.crater_depth},   {"rear_bulge_cm", m.rear_bulge},
                        {"front_lip_cm", m.front_lip},         {"least_thickness_cm", m.least_thickness},
                        {"detached_mass_g", m.detached_mass}};
    if (!measure)
      for (auto &[quantity, value] : results)
        value = std::monostate{};
    results["measured_at_us"] = time;
    return results;
  }

  ResultTable
  debris_results(const DebrisMeasure &measure, std::optional<double> inline_velocity, double time,
                 const std::string &prefix)
  {
    ResultTable results{{prefix + "mass_g", measure.mass},
                        {prefix + "axial_momentum_g_cm_per_us", measure.axial_momentum},
                        {prefix + "mass_velocity_cm_per_us", measure.mass_velocity},
                        {prefix + "leading_edge_cm", measure.leading_edge},
                        {prefix + "leading_edge_velocity_cm_per_us", measure.leading_edge_velocity},
                        {prefix + "length_cm", measure.length},
                        {prefix + "radius_cm", measure.radius},
                        {prefix + "radius_95_cm", measure.radius_95},
                        {prefix + "depth_95_cm", measure.depth_95},
                        {prefix + "cone_angle_deg", measure.cone_angle},
                        {prefix + "time_us", time}};
    if (inline_velocity)
      results[prefix + "inline_mass_velocity_cm_per_us"] = *inline_velocity;
    return results;
  }

  ResultTable
  phase_results(const PhaseMeasure &measure)
  {
    return {{"melt_share", measure.melt_share},
            {"vapour_share", measure.vapour_share},
            {"mean_temperature_K", measure.mean_temperature},
            {"temperature_99_K", measure.temperature_99}};
  }

  ResultTable
  fragment_results(std::optional<double> mean_size)
  {
    return {{"mean_fragment_size_cm", mean_size ? summary::Result(*mean_size) : summary::Result()}};
  }

  ResultTable
  shock_results(const ShockMeasure &measure)
  {
    ResultTable results{{"shock_position_exact_cm", measure.exact}, {"shock_position_cm", {}}, {"shock_spread_cm", {}}};
    if (measure.mean)
      results["shock_position_cm"] = *measure.mean;
    if (measure.spread)
      results["shock_spread_cm"] = *measure.spread;
    return results;
  }

  template <int dim>
  std::vector<std::size_t>
  measured_plates(const Scene<dim> &scene, std::size_t stage)
  {
    std::vector<std::size_t> plates;
    for (std::size_t s = stage + 1; s-- > 0 && scene.stages[s].mode == StageMode::eulerian;)
      for (const std::size_t body : scene.stages[s].introduces)
        if (scene.bodies[body].shape.template as<Plate<dim>>())
          plates.push_back(body);
    return plates;
  }

  template <int dim>
  std::map<std::string, ResultTable>
  expected_results(const Scene<dim> &scene)
  {
    std::map<std::string, ResultTable> tables;
    const std::optional<double>        inline_velocity =
        FieldLayout(scene).bodies_separable ? std::optional<double>(0.) : std::nullopt;
    for (std::size_t s = 0; s < scene.stages.size(); ++s)
      {
        for (const std::size_t plate : measured_plates(scene, s))
          tables[scene.bodies[plate].name].merge(plate_results(PlateMeasure{}, 0.));
        if (scene.has_effect("melting"))
          tables[scene.stages[s].name].merge(phase_results({}));
        if (scene.has_effect("fragment size"))
          tables[scene.stages[s].name].merge(fragment_results(0.));
        if (scene.stages[s].mode == StageMode::lagrangian)
          for (const char *prefix : {handover_prefix, ""})
            tables[scene.stages[s].name].merge(debris_results({}, inline_velocity, 0., prefix));
      }
    if (scene.exact && scene.exact->shock_position(0.))
      tables[exact_place] = shock_results({});
    return tables;
  }

  template std::vector<std::size_t>
  measured_plates(const Scene<2> &, std::size_t);
  template std::map<std::string, ResultTable>
  expected_results(const Scene<2> &);
} // namespace whipple
