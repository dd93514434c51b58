// SPDX-License-Identifier: LGPL-2.1-or-later
#include "figure.h"
#include "remap_case.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

namespace
{
  using namespace remap_case;
  using whipple::BoundaryKind;

  /// A domain and the half or quarter of it above the planes at 0.
  struct Pair
  {
    std::array<bool, 2> halved;
    Mesh                whole, part;
    std::vector<Index>  node, cell; ///< of the part that is the mirror image of one of the whole

    Pair(const Symmetry symmetry, const std::array<bool, 2> halved, const bool graded)
      : halved(halved)
    {
      // fine cells around a point on the planes: lines between levels meet them
      const auto distance = [=](const Point &x) {
        return graded ? std::max(std::abs(x[0] - (halved[0] ? 0. : 0.4)), std::abs(x[1] - (halved[1] ? 0. : 0.3))) : 0.;
      };
      const auto mesh = [&](const std::array<bool, 2> cut) {
        Lattice lattice{symmetry, {-1., -1.}, 1. / 16., {8, 8}, graded ? 2 : 0};
        if (!graded)
          lattice.roots = {16, 16}, lattice.spacing = 1. / 8.;
        for (int d = 0; d < 2; ++d)
          if (cut[d] || (d == 0 && symmetry == Symmetry::axisymmetric))
            {
              lattice.origin[d] = 0.;
              lattice.roots[d] /= 2;
            }
        return graded_mesh(lattice, distance);
      };
      whole = mesh({false, false});
      part  = mesh(halved);
      node.resize(whole.n_nodes);
      cell.resize(whole.n_cells);
      std::map<std::pair<double, double>, Index> found;
      for (Index n = 0; n < part.n_nodes; ++n)
        found[{part.node_point[0][n], part.node_point[1][n]}] = n;
      for (Index n = 0; n < whole.n_nodes; ++n)
        node[n] = found.at(folded({whole.node_point[0][n], whole.node_point[1][n]}));
      found.clear();
      for (Index c = 0; c < part.n_cells; ++c)
        found[{part.lower[0][c] + 0.5 * part.size[c], part.lower[1][c] + 0.5 * part.size[c]}] = c;
      for (Index c = 0; c < whole.n_cells; ++c)
        cell[c] = found.at(folded({whole.lower[0][c] + 0.5 * whole.size[c], whole.lower[1][c] + 0.5 * whole.size[c]}));
    }

    std::pair<double, double>
    folded(const Point &x) const
    {
      return {halved[0] ? std::abs(x[0]) : x[0], halved[1] ? std::abs(x[1]) : x[1]};
    }

    /// Sign of component d of a vector, or with d = 2 of the shear stress, beyond the planes.
    double
    sign(const Point &x, const int d) const
    {
      double s = 1.;
      for (int axis = 0; axis < 2; ++axis)
        if (halved[axis] && x[axis] < 0 && (d == 2 || d == axis))
          s = -s;
      return s;
    }

    Point
    node_point(const Index n) const
    {
      return {whole.node_point[0][n], whole.node_point[1][n]};
    }

    Point
    centre(const Index c) const
    {
      return {whole.lower[0][c] + 0.5 * whole.size[c], whole.lower[1][c] + 0.5 * whole.size[c]};
    }
  };

  constexpr int shear = 1; ///< place among the fields

  /// Random velocities and materials, with open void and void cells between them; sparse ones give nodes that give away
  /// more than they held.
  State<2>
  random_state(const Mesh &mesh, const int n_materials, const bool sparse, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> unit(-1., 1.);
    State<2>                               state = empty_state(mesh, n_materials);
    state.index.stress[2]                        = shear;
    for (Index n = 0; n < mesh.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        state.velocity[d][n] = mesh.node_side[n] >> 2 * d & 3 ? 0. : unit(random);
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        double     left = 1.;
        const bool full = unit(random) > (sparse ? 0.8 : -0.4);
        for (whipple::MaterialState &m : state.material)
          {
            const bool   last  = &m == &state.material.back();
            const double share = full && last         ? left
                                 : unit(random) > 0.5 ? 0.
                                                      : left * std::pow(std::abs(unit(random)), 3);
            left -= share;
            if (share < 0.01)
              continue; // what is next to empty is given away whole or not as round-off decides
            m.volume[c]          = share * state.volume[c];
            m.density[c]         = 2. + unit(random);
            m.mass[c]            = m.density[c] * m.volume[c];
            m.energy[c]          = 1. + 0.5 * unit(random);
            m.void_fraction[c]   = 0.3 + 0.2 * unit(random);
            m.fields[0].value[c] = unit(random);
            m.fields[1].value[c] = unit(random);
          }
      }
    return state;
  }

  State<2>
  unfolded(const Pair &pair, const State<2> &half)
  {
    State<2> state = empty_state(pair.whole, static_cast<int>(half.material.size()));
    state.index    = half.index;
    for (Index n = 0; n < pair.whole.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        state.velocity[d][n] = pair.sign(pair.node_point(n), d) * half.velocity[d][pair.node[n]];
    for (std::size_t m = 0; m < half.material.size(); ++m)
      for (Index c = 0; c < pair.whole.n_cells; ++c)
        {
          whipple::MaterialState       &to   = state.material[m];
          const whipple::MaterialState &from = half.material[m];
          const Index                   i    = pair.cell[c];
          to.volume[c]                       = from.volume[i];
          to.density[c]                      = from.density[i];
          to.mass[c]                         = from.mass[i];
          to.energy[c]                       = from.energy[i];
          to.void_fraction[c]                = from.void_fraction[i];
          to.fields[0].value[c]              = from.fields[0].value[i];
          to.fields[1].value[c]              = pair.sign(pair.centre(c), 2) * from.fields[1].value[i];
        }
    return state;
  }

  /// Nodes move, materials keep their share of the cell and their mass.
  void
  move(const Mesh &mesh, State<2> &state, const double dt)
  {
    const std::vector<double> before = state.volume;
    move_nodes(mesh, state, dt);
    for (whipple::MaterialState &m : state.material)
      for (Index c = 0; c < mesh.n_cells; ++c)
        if (m.volume[c] > 0)
          {
            m.volume[c] *= state.volume[c] / before[c];
            m.density[c] = m.mass[c] / m.volume[c];
          }
  }

  /// Largest difference of anything between the whole and the part.
  double
  difference(const Pair &pair, const State<2> &whole, const State<2> &part)
  {
    double     largest = 0;
    const auto compare = [&](const double a, const double b) { largest = std::max(largest, std::abs(a - b)); };
    for (Index n = 0; n < pair.whole.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        compare(whole.velocity[d][n], pair.sign(pair.node_point(n), d) * part.velocity[d][pair.node[n]]);
    for (std::size_t m = 0; m < part.material.size(); ++m)
      for (Index c = 0; c < pair.whole.n_cells; ++c)
        {
          const whipple::MaterialState &a = whole.material[m], &b = part.material[m];
          const Index                   i = pair.cell[c];
          // what fills next to nothing is known as well as the cell, not as itself
          const double share = a.volume[c] / whole.volume[c];
          compare(share, b.volume[i] / part.volume[i]);
          compare(share * a.density[c], share * b.density[i]);
          compare(share * a.energy[c], share * b.energy[i]);
          compare(share * a.void_fraction[c], share * b.void_fraction[i]);
          compare(share * a.fields[0].value[c], share * b.fields[0].value[i]);
          compare(share * a.fields[1].value[c], pair.sign(pair.centre(c), 2) * share * b.fields[1].value[i]);
        }
    return largest;
  }

  double
  largest_difference(const Symmetry symmetry, const std::array<bool, 2> halved, const bool graded,
                     const int n_materials)
  {
    const Pair                   pair(symmetry, halved, graded);
    const whipple::Boundaries<2> sides = boundaries(BoundaryKind::reflecting);
    std::mt19937                 random(7 + n_materials);
    double                       largest = 0;
    for (int sample = 0; sample < 8; ++sample)
      {
        State<2> part = random_state(pair.part, n_materials, sample % 2, random);
        State<2> whole;
        lump(pair.part, part);
        whole = unfolded(pair, part);
        lump(pair.whole, whole);
        whipple::DirectionalRemap<2> remap_part(pair.part, sides, {}), remap_whole(pair.whole, sides, {});
        for (int step = 0; step < 5; ++step)
          {
            // both move alike: what differs by round-off may not grow by other means than the remap
            const double dt = 0.2 / 16.;
            move(pair.part, part, dt);
            move(pair.whole, whole, dt);
            remap(remap_part, part, (step + sample) % 2);
            remap(remap_whole, whole, (step + sample) % 2);
            largest = std::max(largest, difference(pair, whole, part));
          }
      }
    return largest;
  }

  struct Error
  {
    double largest = 0, mean = 0; ///< cm/us; mean by mass
  };

  /// Error near the plane of a velocity (sin 2x, cos 2x) that a steady flow away from x = 0 carries for 0.5 us: planar
  /// (x, -y), axisymmetric (r, -2 z).
  Error
  error_near_plane(const Symmetry symmetry, const int n, const BoundaryKind kind)
  {
    const Mesh             mesh  = uniform_mesh(symmetry, 1. / n, {n, n / 4});
    whipple::Boundaries<2> sides = boundaries(BoundaryKind::transmitting);
    sides[0].kind                = kind; // nothing moves there whatever it is
    whipple::DirectionalRemap<2> remap(mesh, sides, {});
    State<2>                     state   = empty_state(mesh, 1);
    whipple::MaterialState      &m       = state.material[0];
    const double                 squeeze = symmetry == Symmetry::planar ? 1. : 2.;
    for (Index k = 0; k < mesh.n_nodes; ++k)
      {
        state.velocity[0][k] = std::sin(2. * mesh.node_point[0][k]);
        state.velocity[1][k] = std::cos(2. * mesh.node_point[0][k]);
      }
    m.energy.assign(mesh.n_cells, 1.);
    const double end = 0.5, dt = 0.2 / n;
    const int    steps = static_cast<int>(std::round(end / dt));
    for (int step = 0; step < steps; ++step)
      {
        for (Index k = 0; k < mesh.n_nodes; ++k)
          {
            state.position[0][k] = mesh.node_point[0][k] * std::exp(dt);
            state.position[1][k] = mesh.node_point[1][k] * std::exp(-squeeze * dt);
          }
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            state.volume[c] = cell_volume(mesh, state, c);
            m.volume[c]     = state.volume[c];
            m.density[c]    = 1.;
            m.mass[c]       = state.volume[c];
          }
        lump(mesh, state);
        remap_case::remap(remap, state, step % 2);
      }
    Error  error;
    double mass = 0;
    for (Index k = 0; k < mesh.n_nodes; ++k)
      if (mesh.node_point[0][k] < 0.3 && mesh.node_point[1][k] < 0.1)
        {
          const double x = 2. * mesh.node_point[0][k] * std::exp(-end);
          const double off =
              std::max(std::abs(state.velocity[0][k] - std::sin(x)), std::abs(state.velocity[1][k] - std::cos(x)));
          error.largest = std::max(error.largest, off);
          error.mean += state.node_mass[k] * off;
          mass += state.node_mass[k];
        }
    error.mean /= mass;
    return error;
  }
} // namespace

TEST(RemapSymmetryPlane, PartIsTheWholeToRoundOff)
{
  whipple::figure::Largest reached("half or quarter against full domain, random states, 5 steps, largest difference",
                                   "<= 1e-11");
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    for (const std::array<bool, 2> halved :
         {std::array<bool, 2>{true, false}, std::array<bool, 2>{false, true}, std::array<bool, 2>{true, true}})
      for (const bool graded : {false, true})
        for (const int n_materials : {1, 2})
          {
            if (halved[0] && symmetry == Symmetry::axisymmetric)
              continue;
            const double difference = largest_difference(symmetry, halved, graded, n_materials);
            reached(difference);
            EXPECT_LE(difference, 1e-11) << (symmetry == Symmetry::planar ? "planar" : "axisymmetric") << " halved "
                                         << halved[0] << halved[1] << " graded " << graded << " materials "
                                         << n_materials;
          }
}

TEST(RemapSymmetryPlane, VelocityNextToItIsSecondOrder)
{
  const Error  middle = error_near_plane(Symmetry::planar, 32, BoundaryKind::reflecting);
  const Error  fine   = error_near_plane(Symmetry::planar, 64, BoundaryKind::reflecting);
  const double order  = std::log2(middle.largest / fine.largest);
  whipple::figure::record("order of momentum next to a symmetry plane, largest error", order, ">= 1.8");
  EXPECT_GE(order, 1.8) << middle.largest << ", " << fine.largest;
  // without a mirror image the plane is first order
  EXPECT_GT(error_near_plane(Symmetry::planar, 64, BoundaryKind::transmitting).largest, 20. * fine.largest);
}

TEST(RemapSymmetryPlane, VelocityNextToTheAxisIsSecondOrderInTheMean)
{
  // a node's mass lies farther out than the node, by h^2/(8 r): the first ones off the axis are first order, the goal
  // of 1.8 in the largest error is not reached (doc/limitations.md)
  const Error  middle = error_near_plane(Symmetry::axisymmetric, 32, BoundaryKind::reflecting);
  const Error  fine   = error_near_plane(Symmetry::axisymmetric, 64, BoundaryKind::reflecting);
  const double mean = std::log2(middle.mean / fine.mean), largest = std::log2(middle.largest / fine.largest);
  whipple::figure::record("order of momentum next to the axis, mean error", mean, ">= 1.8");
  whipple::figure::record("order of momentum next to the axis, largest error", largest, ">= 0.95");
  EXPECT_GE(mean, 1.8) << middle.mean << ", " << fine.mean;
  EXPECT_GE(largest, 0.95) << middle.largest << ", " << fine.largest;
  EXPECT_GT(error_near_plane(Symmetry::axisymmetric, 64, BoundaryKind::transmitting).largest, 1.4 * fine.largest);
}
