// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/hydro/trace.h>
#include <whipple/problem/field_layout.h>

namespace whipple
{
  namespace
  {
    /// Bulk density up to which a material is a trace: a small share of the least at which it is normally there.
    template <int dim>
    double
    trace_density(const Scene<dim> &scene, const Material &model, std::size_t material)
    {
      double least = model.eos->reference_density();
      for (const Body<dim> &body : scene.bodies)
        if (body.material == material && body.density > 0)
          least = std::min(least, body.density);
      return trace::share * least;
    }

    /// The carried arrays of a state's cells, in an order that is always the same.
    template <typename Array, typename AnyState>
    std::vector<Array *>
    arrays_of(AnyState &state)
    {
      std::vector<Array *> arrays{&state.volume};
      for (auto &m : state.material)
        {
          for (auto *array : {&m.volume, &m.mass, &m.density, &m.energy})
            arrays.push_back(array);
          if (m.has_voids())
            arrays.push_back(&m.void_fraction);
          for (auto &field : m.fields)
            arrays.push_back(&field.value);
        }
      return arrays;
    }
  } // namespace

  template <int dim>
  FieldLayout::FieldLayout(const Scene<dim> &scene, const std::vector<MaterialModels> &models)
  {
    for (const MaterialModels &material : models)
      materials.push_back(material.model);
    for (const SceneMaterial &material : scene.materials)
      material_names.push_back(material.name);
    for (const EffectDescription &effect : effect_descriptions())
      if (scene.has_effect(effect.name))
        fields.insert(fields.end(), effect.fields.begin(), effect.fields.end());

    for (std::size_t m = 0; m < materials.size(); ++m)
      materials[m].trace_density = trace_density(scene, materials[m], m);

    std::vector<int> bodies_of_material(materials.size(), 0);
    for (const Body<dim> &body : scene.bodies)
      {
        body_material.push_back(static_cast<Index>(body.material));
        ++bodies_of_material[body.material];
      }
    body_tag.assign(scene.bodies.size(), -1);
    bodies_separable = true;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      if (--bodies_of_material[scene.bodies[b].material] > 0)
        {
          if (scene.has_effect("body tags"))
            {
              body_tag[b] = static_cast<int>(fields.size());
              fields.push_back({"body " + scene.bodies[b].name, "1", Carrier::mass});
            }
          else
            bodies_separable = false;
        }
  }

  FieldLayout
  FieldLayout::of_stage(const Stage &stage) const
  {
    FieldLayout layout = *this;
    if (stage.void_growth)
      for (Material &material : layout.materials)
        if (auto law = material.void_law ? material.void_law->with_growth(*stage.void_growth) : nullptr)
          material.void_law = law;
    return layout;
  }

  template <int dim>
  State<dim>
  FieldLayout::allocate(const FlatMesh<dim> &mesh) const
  {
    const std::size_t n_cells = mesh.n_cells, n_nodes = mesh.n_nodes;
    State<dim>        state;
    for (int d = 0; d < dim; ++d)
      {
        state.position[d] = mesh.node_point[d];
        state.velocity[d].assign(n_nodes, 0.);
      }
    state.node_mass.assign(n_nodes, 0.);
    state.volume.assign(n_cells, 0.);
    state.corner_weight.assign(n_cells * FlatMesh<dim>::corners, 0.);
    for (std::size_t i = 0; i < state.index.stress.size(); ++i)
      state.index.stress[i] = field_index(fields, DeviatorStorage<dim>::field[i]);
    state.index.plastic_strain = field_index(fields, "plastic strain");
    state.index.damage         = field_index(fields, "damage");
    for (const Material &model : materials)
      {
        MaterialState m;
        for (auto *array : {&m.volume, &m.mass, &m.density, &m.energy})
          array->assign(n_cells, 0.);
        m.carries_voids = model.void_law != nullptr;
        if (m.carries_voids)
          m.void_fraction.assign(n_cells, 0.);
        for (const FieldDescription &description : fields)
          m.fields.push_back({description, std::vector<double>(n_cells, 0.)});
        state.material.push_back(std::move(m));
      }
    return state;
  }

  template <int dim>
  std::vector<std::vector<double> *>
  FieldLayout::cell_arrays(State<dim> &state) const
  {
    return arrays_of<std::vector<double>>(state);
  }

  template <int dim>
  std::vector<const std::vector<double> *>
  FieldLayout::cell_arrays(const State<dim> &state) const
  {
    return arrays_of<const std::vector<double>>(state);
  }

  template FieldLayout::FieldLayout(const Scene<2> &, const std::vector<MaterialModels> &);
  template State<2>
  FieldLayout::allocate(const FlatMesh<2> &) const;
  template std::vector<std::vector<double> *>
  FieldLayout::cell_arrays(State<2> &) const;
  template std::vector<const std::vector<double> *>
  FieldLayout::cell_arrays(const State<2> &) const;
} // namespace whipple
