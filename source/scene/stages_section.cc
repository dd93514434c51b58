// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/representation.h>
#include <whipple/scene/sections.h>

#include <algorithm>
#include <cmath>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Stages";
    /// When debris is laid down.
    const std::string landing_key = "Hand-over";

    template <int dim>
    std::vector<std::string>
    body_names(const Scene<dim> &scene)
    {
      std::vector<std::string> names;
      for (const Body<dim> &body : scene.bodies)
        names.push_back(body.name);
      return names;
    }

    template <int dim>
    double
    largest_body_speed(const Scene<dim> &scene)
    {
      double square = 0;
      for (const Body<dim> &body : scene.bodies)
        {
          double v2 = 0;
          for (const double component : body.velocity)
            v2 += component * component;
          square = std::max(square, v2);
        }
      return std::sqrt(square);
    }

    template <int dim>
    std::shared_ptr<const StageEnd>
    read_end(const SceneSection &section, const Scene<dim> &scene)
    {
      StageEndInput input;
      input.rest   = section.text("End");
      input.bodies = body_names(scene);
      for (const Body<dim> &body : scene.bodies)
        {
          input.fronts.push_back(extent(body.shape).lower[flight_axis<dim>]);
          input.rears.push_back(extent(body.shape).upper[flight_axis<dim>]);
        }
      input.largest_speed = largest_body_speed(scene);
      input.value         = [&](const std::string &text, const units::Quantity &quantity) {
        return section.parse("End", text, quantity);
      };
      input.body   = [&](const std::string &text) { return section.name_index("End", text, body_names(scene)); };
      input.reject = [&](const std::string &allowed) { section.reject("End", allowed); };
      return StageEndRegistry::read(std::move(input));
    }

    template <int dim>
    DebrisEntry
    read_debris(const SceneSection &section, const Scene<dim> &scene)
    {
      DebrisEntry debris;
      debris.void_cutoff = section.between("Void cutoff", units::number, 0, 1);

      const std::string key = "Minimum axial velocity", text = section.text(key);
      debris.minimum_axial_velocity = !text.empty() && text.back() == '%'
                                          ? section.parse(key, text, units::number) * largest_body_speed(scene)
                                          : section.quantity(key, units::velocity);
      if (!(debris.minimum_axial_velocity >= 0))
        section.reject(key, "must be >= 0; allowed is a velocity, or a part of the largest body speed such as '10 %'");
      if (section.text("Debris behind") != "none")
        debris.behind = section.name_index("Debris behind", section.text("Debris behind"), body_names(scene));
      return debris;
    }

    std::shared_ptr<const Representation>
    read_representation(const SceneSection &section)
    {
      std::vector<std::pair<std::string, std::string>> names;
      for (const auto &[name, entry] : RepresentationRegistry::all())
        names.emplace_back(name, name);
      const std::string name = section.choice<std::string>("Representation", names);
      return RepresentationRegistry::all().at(name).read(section.input());
    }

    template <int dim>
    Stage
    read_stage(const SceneSection &section, const std::string &name, const Scene<dim> &scene)
    {
      const std::vector<std::string> bodies = body_names(scene);

      Stage stage;
      stage.name = name;
      const StageMode mode =
          section.choice<StageMode>("Mode", {{"eulerian", StageMode::eulerian}, {"lagrangian", StageMode::lagrangian}});
      if (section.text("Introduces") != "none")
        for (const std::string &body : section.list("Introduces"))
          stage.introduces.push_back(section.name_index("Introduces", body, bodies));
      stage.end = read_end(section, scene);
      if (const auto step = section.optional_positive("Max time step", units::time))
        stage.max_time_step = *step;
      stage.lost_kinetic_energy = section.choice<KineticLoss>(
          "Lost kinetic energy", {{"heat", KineticLoss::heat}, {"drop", KineticLoss::drop}});
      stage.plates_measured = section.choice<PlatesMeasured>(
          "Plates measured", {{"at the end", PlatesMeasured::at_the_end}, {"settled", PlatesMeasured::settled}});
      if (section.text("Alpha") != "as the materials say")
        {
          stage.void_growth = section.quantity("Alpha", units::void_rate);
          if (!(*stage.void_growth >= 0))
            section.reject("Alpha", "allowed are 'as the materials say' and a void growth coefficient >= 0 us/cm^2");
        }
      LagrangianStage moving; // what is said must make sense in any case
      moving.cohesion = section.choice<Cohesion>(
          "Cohesion", {{"bonded", Cohesion::bonded}, {"graded", Cohesion::graded}, {"fragments", Cohesion::fragments}});
      moving.breaking.damage        = section.between("Break damage", units::number, 0, 1);
      moving.breaking.void_fraction = section.between("Break void", units::number, 0, 1);
      moving.breaking.shape         = section.between("Break shape", units::number, 0, 1);
      moving.debris                 = read_debris(section, scene);
      if (mode == StageMode::lagrangian)
        stage.lagrangian = moving;
      stage.representation = read_representation(section);
      stage.landing        = section.choice<Landing>(
          landing_key, {{"at once", Landing::at_once}, {"as it arrives", Landing::as_it_arrives}});
      return stage;
    }

    /// Without `Introduces` the first stage brings in every body that no other stage does.
    template <int dim>
    void
    introduce_the_rest(const SceneSection &section, const Scene<dim> &scene, std::vector<Stage> &stages)
    {
      std::string names;
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        {
          const auto has = [b](const Stage &stage) {
            return std::find(stage.introduces.begin(), stage.introduces.end(), b) != stage.introduces.end();
          };
          if (std::any_of(stages.begin() + 1, stages.end(), has))
            continue;
          stages[0].introduces.push_back(b);
          names += (names.empty() ? "" : ", ") + scene.bodies[b].name;
        }
      section.replace("Introduces", names.empty() ? "none" : names);
    }

    /// Each body enters once, and only where matter can be laid down beside what is there.
    template <int dim>
    void
    check_introductions(SceneParameters &parameters, const Scene<dim> &scene, const std::vector<Stage> &stages)
    {
      std::vector<std::string> introduced_by(scene.bodies.size());
      for (std::size_t s = 0; s < stages.size(); ++s)
        {
          const Stage       &stage = stages[s];
          const SceneSection section(parameters, path + "/" + stage.name);
          if (s == 0 && stage.introduces.empty())
            section.reject("Introduces", "the first stage needs at least one body");
          if (s > 0 && stage.mode() == StageMode::lagrangian && !stage.introduces.empty())
            section.reject("Introduces", "only the first stage and Eulerian stages can introduce bodies");
          for (const std::size_t b : stage.introduces)
            {
              if (!introduced_by[b].empty())
                section.reject("Introduces", "body '" + scene.bodies[b].name + "' has already entered in stage '" +
                                                 introduced_by[b] + "'; allowed is once");
              introduced_by[b] = stage.name;
            }
          if (const auto awaited = stage.end->awaited_body(); awaited && !introduced_by[*awaited].empty())
            section.reject("End", "body '" + scene.bodies[*awaited].name +
                                      "' is in the scene already; allowed is a body that a later stage introduces");
        }
    }

    /// Only elements can wait, and only for a fixed mesh.
    void
    check_landings(SceneParameters &parameters, const std::vector<Stage> &stages)
    {
      for (std::size_t s = 0; s < stages.size(); ++s)
        if (stages[s].landing == Landing::as_it_arrives &&
            (s == 0 || stages[s].mode() != StageMode::eulerian || stages[s - 1].mode() != StageMode::lagrangian))
          SceneSection(parameters, path + "/" + stages[s].name)
              .reject(landing_key, "the stage is not an Eulerian one after a Lagrangian one; allowed is 'at once'");
    }

    /// Absolute ends follow one another.
    void
    check_times(SceneParameters &parameters, const std::vector<Stage> &stages)
    {
      double earliest = 0; // start of the stage, as far as known beforehand
      for (const Stage &stage : stages)
        {
          const SceneSection section(parameters, path + "/" + stage.name);
          const auto         fixed = stage.end->fixed_time();
          if (fixed && !(*fixed > earliest))
            section.reject("End",
                           "the stage does not start before " + units::format(earliest, units::time) +
                               "; allowed is a later time (times count from the start of the run), or 'for 2 us'");
          if (stage.end->is_known())
            earliest = stage.end->expected({earliest, 0., 0.});
        }
    }
  } // namespace

  void
  declare_stages(SceneParameters &parameters, const std::vector<std::string> &names)
  {
    SceneSection(parameters, path)
        .declare("List", "",
                 "automatic (the chain that the plates ask for) | names of the stages in their order; each has its "
                 "subsection");
    for (const std::string &name : names)
      {
        SceneSection section(parameters, path + "/" + name);
        section.declare("Mode", "eulerian", "eulerian (fixed mesh) | lagrangian (the mesh moves with the material)");
        section.declare("Introduces", name == names.front() ? "" : "none",
                        "bodies that enter at the start; first stage: not given means all that no other stage lists");
        section.declare("End", "", StageEndRegistry::usage());
        section.declare("Max time step", "none", "none | a time");
        section.declare("Lost kinetic energy", "heat",
                        "what remap and projection cannot keep: heat (into the material) | drop (booked, as in 1993)");
        section.declare("Plates measured", "at the end",
                        "eulerian: at the end (of the stage) | settled (on in a copy of the state, until holes and "
                        "craters have stopped growing)");
        section.declare("Alpha", "as the materials say",
                        "as the materials say | alpha of every void law 'rate' in this stage (0.1, 1000 and 1 us/cm^2 "
                        "in 1993)");
        section.declare("Cohesion", "bonded",
                        "lagrangian: bonded | graded (bonds only where the material is intact) | fragments (every "
                        "element for itself)");
        section.declare("Break damage", "50 %", "graded: elements of more damage are broken (with the effect failure)");
        section.declare("Break void", "15 %",
                        "elements of their own with more void are rubble, without shear; graded: broken (without the "
                        "effect failure)");
        section.declare("Break shape", "20 %",
                        "graded: elements a corner of which has less than this part of their mean Jacobian are broken");
        section.declare("Void cutoff", "99 %", "lagrangian after eulerian: cells with more void are dropped");
        section.declare(
            "Minimum axial velocity", "10 %",
            "lagrangian after eulerian: slower cells are dropped; a velocity, or % of the largest body speed");
        section.declare("Debris behind", "none",
                        "lagrangian after eulerian: only material beyond the rear face of this body; none: no limit");
        section.declare("Representation", "distended", "eulerian after lagrangian: " + RepresentationRegistry::usage());
        section.declare(
            landing_key, "at once",
            "eulerian after lagrangian: at once (all debris is laid down) | as it arrives (what flies freely "
            "waits outside the mesh until it comes to what is there)");
        for (const auto &[representation, registered] : RepresentationRegistry::all())
          for (const SectionEntry &entry : registered.entries)
            section.declare(entry.key, entry.default_value, entry.documentation);
      }
  }

  template <int dim>
  std::vector<Stage>
  read_stages(SceneParameters &parameters, const Scene<dim> &scene)
  {
    const SceneSection section(parameters, path);
    std::vector<Stage> stages;
    for (const std::string &name : section.list("List"))
      stages.push_back(read_stage(SceneSection(parameters, path + "/" + name), name, scene));
    if (stages.empty())
      section.reject("List", "must be given; allowed are one or more names, each with its subsection");
    const SceneSection first(parameters, path + "/" + stages[0].name);
    if (!first.given("Introduces"))
      introduce_the_rest(first, scene, stages);
    check_introductions(parameters, scene, stages);
    check_landings(parameters, stages);
    check_times(parameters, stages);
    return stages;
  }

  template std::vector<Stage>
  read_stages(SceneParameters &, const Scene<2> &);
} // namespace whipple::sections
