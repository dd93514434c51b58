// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/problem/void_law_check.h>
#include <whipple/scene/body_volume.h>
#include <whipple/scene/box_shape.h>
#include <whipple/state/round_off_share.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace whipple::sections
{
  namespace
  {
    /// Part of the domain that bodies may leave free and still fill it.
    constexpr double free_part = 1e-9;

    template <int dim>
    bool
    lies_on_mesh_lines(const Scene<dim> &scene, const Body<dim> &body)
    {
      if (!body.shape->is_box())
        return false;
      const Box<dim>    box   = extent(body.shape);
      const Vector<dim> upper = scene.upper_corner();
      for (int d = 0; d < dim; ++d)
        for (const double face : {box.lower[d], box.upper[d]})
          {
            const double cells = (face - scene.lattice.origin[d]) / scene.lattice.spacing;
            if (face > scene.lattice.origin[d] && face < upper[d] &&
                std::abs(cells - std::round(cells)) > round_off_share)
              return false;
          }
      return true;
    }

    /// Whether another of these bodies may fill what a body leaves free of its cells.
    template <int dim>
    bool
    adjoins_another(const Scene<dim> &scene, const std::vector<std::size_t> &bodies, std::size_t body)
    {
      const Box<dim> box = extent(scene.bodies[body].shape);
      return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t other) {
        const Box<dim> around = extent(scene.bodies[other].shape);
        bool           meets  = other != body;
        for (int d = 0; d < dim; ++d)
          meets = meets && around.lower[d] <= box.upper[d] + scene.lattice.spacing &&
                  around.upper[d] >= box.lower[d] - scene.lattice.spacing;
        return meets;
      });
    }

    /// Elements that are filled in part at the start need pores to put the rest into.
    template <int dim>
    void
    check_first_elements(SceneParameters &parameters, const Problem<dim> &problem, const Stage &stage)
    {
      const Scene<dim> &scene = problem.scene;
      for (const std::size_t b : stage.introduces)
        {
          const Body<dim> &body = scene.bodies[b];
          if (!problem.materials[body.material].model.void_law && scene.mesh_map == MeshMap::identity &&
              !lies_on_mesh_lines(scene, body) && !adjoins_another(scene, stage.introduces, b))
            SceneSection(parameters, "Materials/" + scene.materials[body.material].name)
                .reject("Void law", "body '" + body.name +
                                        "' fills cells of the moving mesh in part at the start of stage '" +
                                        stage.name +
                                        "': needed are a void law and the effect 'voids' (Effects/List), or a box "
                                        "whose sides lie on lines of the finest mesh");
        }
    }

    /// Whether the cells that these bodies have filled may all be full still.
    template <int dim>
    bool
    can_be_full(const Scene<dim> &scene, const std::vector<std::size_t> &bodies)
    {
      const Vector<dim> &lower = scene.lattice.origin, upper = scene.upper_corner();
      const Symmetry     symmetry = scene.lattice.symmetry;
      double             filled   = 0;
      bool               stays    = true;
      for (const std::size_t b : bodies)
        {
          const Body<dim> &body = scene.bodies[b];
          filled += body_volume<dim>(symmetry, body.shape, lower, upper);
          stays = stays && body.velocity == Vector<dim>{} && !body.deposit && lies_on_mesh_lines(scene, body);
        }
      return stays || filled >= (1. - free_part) * box_volume(symmetry, lower, upper);
    }
  } // namespace

  template <int dim>
  void
  check_void_laws(SceneParameters &parameters, const Problem<dim> &problem)
  {
    const Scene<dim>        &scene = problem.scene;
    std::vector<std::size_t> entered;
    for (std::size_t s = 0; s < scene.stages.size(); ++s)
      {
        const Stage &stage = scene.stages[s];
        const auto   grows = [](const MaterialModels &material) {
          return material.model.void_law && material.model.void_law->with_growth(0.);
        };
        if (stage.void_growth && std::none_of(problem.materials.begin(), problem.materials.end(), grows))
          SceneSection(parameters, "Stages/" + stage.name)
              .reject("Alpha",
                      "no material has the void law 'rate' and the effect 'voids' (Effects/List); allowed then is "
                      "'as the materials say'");
        entered.insert(entered.end(), stage.introduces.begin(), stage.introduces.end());
        if (s == 0 && stage.mode() == StageMode::lagrangian)
          check_first_elements(parameters, problem, stage);
        if (s == 0 || stage.mode() != StageMode::lagrangian || scene.stages[s - 1].mode() != StageMode::eulerian ||
            stage.lagrangian->debris.void_cutoff < round_off_share || can_be_full(scene, entered))
          continue;
        for (const std::size_t b : entered)
          {
            const std::size_t material = scene.bodies[b].material;
            if (!problem.materials[material].model.void_law)
              SceneSection(parameters, "Materials/" + scene.materials[material].name)
                  .reject("Void law",
                          "stage '" + stage.name +
                              "' goes over from a fixed mesh to a moving one, whose "
                              "elements have no open void beside the material: needed are a void law and the "
                              "effect 'voids' (Effects/List)");
          }
      }
  }

  template void
  check_void_laws(SceneParameters &, const Problem<2> &);
} // namespace whipple::sections
