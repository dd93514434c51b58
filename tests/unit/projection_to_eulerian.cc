// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../figure.h"
#include "projection_fixture.h"

#include <whipple/error.h>
#include <whipple/projection/debris_selection.h>
#include <whipple/projection/to_eulerian.h>
#include <whipple/projection/to_lagrangian.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  const std::string distended = "distended", packages = "packages";

  const std::array<std::string, 2> representations{{distended, packages}};

  Boundaries<2>
  boundaries_of(Symmetry symmetry)
  {
    Boundaries<2> boundaries;
    if (symmetry == Symmetry::axisymmetric)
      boundaries[0].kind = BoundaryKind::reflecting;
    return boundaries;
  }

  /// A cloud of distorted fragments, at the axis too.
  struct Cloud
  {
    Lattice<2>  grid;
    FlatMesh<2> mesh;
    State<2>    state;
    Random      random{31};

    Cloud(Symmetry symmetry, double distortion, double scatter)
      : grid(lattice(symmetry, 6, 2))
      , mesh(mesh_of(grid, inner_keys(grid), Cohesion::fragments))
      , state(blank_state(mesh))
    {
      fill_with_both(state, random);
      set_velocities(mesh, state, scatter, random);
      for (Index node = 0; node < mesh.n_nodes; ++node)
        for (int d = 0; d < 2; ++d)
          if (d == 1 || state.position[0][node] > 0)
            state.position[d][node] += distortion * 0.1 * random(-1., 1.);
    }

    /// The middle of the domain, at the axis.
    static std::vector<CellKey>
    inner_keys(const Lattice<2> &grid)
    {
      std::vector<CellKey> keys;
      for (const CellKey key : uniform_keys(grid, 0))
        {
          const LatticePoint<2> root = key_point<2>(key);
          if (root[0] < 16 && root[1] >= 4 && root[1] < 20)
            keys.push_back(key);
        }
      return keys;
    }

    std::vector<Element<2>>
    elements() const
    {
      const auto layout = CellPacketLayout<2>::of(state);
      return gather_elements<2>(MPI_COMM_SELF, layout, elements_of<2>(layout, mesh, state));
    }
  };

  struct Target
  {
    FlatMesh<2> mesh;
    State<2>    state;
    LaidDown<2> report;

    Target(const Lattice<2> &grid, std::vector<CellKey> keys)
      : mesh(mesh_of(grid, std::move(keys)))
      , state(blank_state(mesh))
    {
    }

    void
    lay_down(const Lattice<2> &grid, const std::vector<Element<2>> &elements, const std::string &representation,
             KineticLoss loss = KineticLoss::heat)
    {
      report = to_eulerian<2>(MPI_COMM_SELF, grid, CellPacketLayout<2>::of(state), elements,
                              *RepresentationRegistry::make(representation), mesh, Halo<2>(MPI_COMM_SELF, mesh, {}), {},
                              boundaries_of(grid.symmetry), loss, state);
    }

    double
    kinetic_loss() const
    {
      return report.bookings.of(laid_down::projection).converted.value();
    }
    ConservedTotals<2>
    left_domain() const
    {
      return report.bookings.of(laid_down::beyond).left.value();
    }
    double
    number(const char *cause) const
    {
      const auto event = report.bookings.of(cause).event;
      return event ? event->number : 0.;
    }
  };

  double
  total_energy(const ConservedTotals<2> &totals)
  {
    return totals.internal_energy + totals.kinetic_energy;
  }

  /// What was there and what was laid down is in the state, has left, or went into the walls.
  /// @return largest relative change of mass, axial momentum and total energy
  double
  expect_closed(const ConservedTotals<2> &there, const Target &target)
  {
    ConservedTotals<2> sum = node_totals(target.state);
    sum += target.left_domain();
    ConservedTotals<2> all = there;
    all += target.report.elements;
    constexpr double round_off = 1e-13;
    EXPECT_NEAR(sum.mass, all.mass, round_off * all.mass);
    EXPECT_NEAR(sum.momentum[1], all.momentum[1], round_off * std::abs(all.momentum[1]));
    EXPECT_NEAR(sum.momentum[0] + target.report.bookings.of(laid_down::projection).left->momentum[0], all.momentum[0],
                round_off * std::abs(all.momentum[1]));
    EXPECT_NEAR(total_energy(sum), total_energy(all), round_off * total_energy(all));
    EXPECT_NEAR(sum.kinetic_energy + target.kinetic_loss(), all.kinetic_energy, round_off * all.kinetic_energy);
    return std::max({std::abs(sum.mass / all.mass - 1.), std::abs(sum.momentum[1] / all.momentum[1] - 1.),
                     std::abs(total_energy(sum) / total_energy(all) - 1.)});
  }
} // namespace

TEST(ToEulerian, DistortedElementsKeepMassMomentumAndTotalEnergy)
{
  figure::Largest change("projection to Eulerian: mass, momentum, energy, relative change", "<= 1e-12");
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    for (const std::string &representation : representations)
      {
        const Cloud cloud(symmetry, 0.35, 0.2);
        Target      target(cloud.grid, hanging_keys(cloud.grid));
        target.lay_down(cloud.grid, cloud.elements(), representation);
        change(expect_closed({}, target));
        EXPECT_GT(target.kinetic_loss(), 0.);
      }
}

TEST(ToEulerian, FoldedAndMirroredElementsAreConservedToo)
{
  for (const std::string &representation : representations)
    {
      Cloud  cloud(Symmetry::axisymmetric, 1.5, 0.2);
      Target target(cloud.grid, uniform_keys(cloud.grid, 1));
      target.lay_down(cloud.grid, cloud.elements(), representation);
      EXPECT_GT(target.number(laid_down::folded), 0);
      EXPECT_GT(target.number(laid_down::mirrored), 0);
      ConservedTotals<2> sum = node_totals(target.state);
      sum += target.left_domain();
      EXPECT_NEAR(sum.mass, target.report.elements.mass, 1e-13 * sum.mass);
      EXPECT_NEAR(sum.momentum[1], target.report.elements.momentum[1], 1e-13 * sum.momentum[1]);
      EXPECT_NEAR(total_energy(sum), total_energy(target.report.elements), 1e-13 * total_energy(sum));
    }
}

TEST(ToEulerian, UniformVelocityStaysUniform)
{
  figure::Largest deviation("projection of a uniform velocity: deviation, cm/us", "uniform");
  for (const std::string &representation : representations)
    {
      const Cloud cloud(Symmetry::axisymmetric, 0.35, 0.);
      Target      target(cloud.grid, hanging_keys(cloud.grid));
      target.lay_down(cloud.grid, cloud.elements(), representation);
      for (Index node = 0; node < target.mesh.n_nodes; ++node)
        if (target.state.node_mass[node] > 0)
          {
            deviation(target.state.velocity[0][node]);
            deviation(target.state.velocity[1][node] - 0.6);
            EXPECT_NEAR(target.state.velocity[0][node], 0., 1e-15);
            EXPECT_NEAR(target.state.velocity[1][node], 0.6, 1e-15);
          }
      EXPECT_LT(std::abs(target.kinetic_loss()), 1e-14 * target.report.elements.kinetic_energy);
    }
}

TEST(ToEulerian, PackagesKeepTrueDensityExactly)
{
  const Cloud cloud(Symmetry::axisymmetric, 0.1, 0.1);
  // elements far apart, so that no cell is overfull
  auto   elements = cloud.elements();
  Target target(cloud.grid, uniform_keys(cloud.grid, 2));
  target.lay_down(cloud.grid, {elements[0], elements[3], elements[9]}, packages);
  EXPECT_EQ(target.report.solid_compressed, 0.);
  const std::array<double, 2> true_density{{2.75, 7.9}};
  for (int m = 0; m < 2; ++m)
    for (Index cell = 0; cell < target.mesh.n_cells; ++cell)
      if (target.state.material[m].mass[cell] > 0)
        {
          const MaterialState &material = target.state.material[m];
          EXPECT_EQ(material.void_fraction[cell], 0.);
          EXPECT_NEAR(material.density[cell], true_density[m], 1e-13 * true_density[m]);
          EXPECT_NEAR(material.mass[cell] / material.volume[cell], true_density[m], 1e-12 * true_density[m]);
        }
}

TEST(ToEulerian, OverlappingFragmentsLoseNothing)
{
  for (const std::string &representation : representations)
    {
      const Cloud cloud(Symmetry::axisymmetric, 0.2, 0.2);
      auto        elements = cloud.elements();
      // three copies of the cloud in one place
      const auto n = elements.size();
      for (int copy = 0; copy < 2; ++copy)
        for (std::size_t i = 0; i < n; ++i)
          elements.push_back(elements[i]);
      Target target(cloud.grid, uniform_keys(cloud.grid, 1));
      target.lay_down(cloud.grid, elements, representation);
      expect_closed({}, target);
      EXPECT_GT(target.number(laid_down::spread), 0.);
      EXPECT_LE(target.report.solid_compressed, 1e-6 * 0.36 * 0.6);
      for (Index cell = 0; cell < target.mesh.n_cells; ++cell)
        {
          double filled = 0;
          for (const MaterialState &material : target.state.material)
            {
              filled += material.volume[cell];
              EXPECT_NEAR(material.density[cell] * material.volume[cell], material.mass[cell],
                          1e-12 * material.mass[cell]);
            }
          EXPECT_LE(filled, target.state.volume[cell] * (1. + 1e-14));
        }
    }
}

TEST(ToEulerian, CornerMassesUnlikeTheGeometryMakeNoKineticEnergy)
{
  const Cloud cloud(Symmetry::axisymmetric, 0.2, 0.3);
  auto        elements = cloud.elements();
  for (Element<2> &element : elements)
    {
      // nearly all mass in one corner: its lumped relative motion is far below that of a linear field
      double mass = 0;
      for (const double m : element.corner_mass)
        mass += m;
      element.corner_mass = {{0.97 * mass, 0.01 * mass, 0.01 * mass, 0.01 * mass}};
    }
  Target target(cloud.grid, uniform_keys(cloud.grid, 2));
  target.lay_down(cloud.grid, elements, distended);
  expect_closed({}, target);
  EXPECT_GE(target.kinetic_loss(), 0.);
}

TEST(ToEulerian, PoresAreSqueezedBeforeTheSolid)
{
  const Cloud cloud(Symmetry::planar, 0., 0.);
  auto        elements = cloud.elements();
  elements.resize(1);
  const auto layout = CellPacketLayout<2>::of(cloud.state);
  auto      &packet = elements[0].packet;
  for (int m = 0; m < 2; ++m)
    {
      const double true_density       = packet[layout.density(m)] / (1. - packet[layout.void_fraction(m)]);
      packet[layout.void_fraction(m)] = 0.6;
      packet[layout.density(m)]       = 0.4 * true_density;
      packet[layout.mass(m)]          = 0.4 * true_density * packet[layout.volume(m)];
    }
  for (double &mass : elements[0].corner_mass)
    mass = 0.25 * (packet[layout.mass(0)] + packet[layout.mass(1)]);
  elements.push_back(elements[0]);
  Target target(cloud.grid, uniform_keys(cloud.grid, 0));
  target.lay_down(cloud.grid, elements, distended);
  EXPECT_NEAR(target.report.pores_squeezed, 0.01, 1e-15); // one of two cell volumes
  EXPECT_NEAR(target.report.solid_compressed, 0., 1e-15);
  for (Index cell = 0; cell < target.mesh.n_cells; ++cell)
    if (target.state.material[0].mass[cell] > 1e-10)
      {
        EXPECT_NEAR(target.state.material[0].void_fraction[cell], 0.2, 1e-12); // solid 2 x 0.4 in one volume
      }
}

TEST(ToEulerian, WhatLiesBeyondTheDomainIsBooked)
{
  Cloud cloud(Symmetry::axisymmetric, 0.3, 0.2);
  for (double &z : cloud.state.position[1])
    z += 0.25;
  for (const std::string &representation : representations)
    {
      Target target(cloud.grid, uniform_keys(cloud.grid, 1));
      target.lay_down(cloud.grid, cloud.elements(), representation);
      expect_closed({}, target);
      EXPECT_GT(target.left_domain().mass, 0.05 * target.report.elements.mass);
    }
}

TEST(ToEulerian, DebrisMeetsAWallThatIsThere)
{
  const Cloud cloud(Symmetry::axisymmetric, 0.3, 0.2);
  Target      target(cloud.grid, hanging_keys(cloud.grid));
  Random      random(5);
  for (Index cell = 0; cell < target.mesh.n_cells; ++cell)
    if (target.mesh.lower[1][cell] > 0.09)
      set_material(target.state.material[1], cell, target.state.volume[cell], 7.9, 0.001, 0.);
  set_velocities(target.mesh, target.state, 0.05, random);
  for (auto &axis : target.state.velocity)
    for (double &v : axis)
      v *= -0.1;
  for (Index node = 0; node < target.mesh.n_nodes; ++node)
    if (target.mesh.node_side[node] & 1)
      target.state.velocity[0][node] = 0;
  for (std::size_t h = 0; h < target.mesh.hanging.size(); ++h)
    for (auto &axis : target.state.velocity)
      axis[target.mesh.hanging[h]] = 0.5 * (axis[target.mesh.master[h][0]] + axis[target.mesh.master[h][1]]);
  const ConservedTotals<2> wall = node_totals(target.state);
  ASSERT_GT(wall.mass, 0.);
  target.lay_down(cloud.grid, cloud.elements(), distended);
  expect_closed(wall, target);
}

TEST(ToEulerian, AMeshThatDoesNotCoverTheDebrisIsRefused)
{
  const Cloud cloud(Symmetry::axisymmetric, 0.1, 0.);
  Target      target(cloud.grid, {make_key<2>(0, {{0, 8}})});
  EXPECT_THROW(target.lay_down(cloud.grid, cloud.elements(), distended), ConservationError);
}

TEST(ToEulerian, TouchedCellsCoverTheDebris)
{
  const Cloud cloud(Symmetry::axisymmetric, 0.3, 0.1);
  const auto  elements = cloud.elements();
  Target      target(cloud.grid, touched_cells<2>(cloud.grid, elements, 2));
  target.lay_down(cloud.grid, elements, distended);
  expect_closed({}, target);
  for (Index cell = 0; cell < target.mesh.n_cells; ++cell)
    EXPECT_GT(cell_mass<2>(target.state, cell), 0.);
}

TEST(Projections, RoundTripOnTheSameCellsReturnsALinearVelocityField)
{
  const auto grid  = lattice(Symmetry::axisymmetric, 6, 0);
  const auto cells = mesh_of(grid, uniform_keys(grid, 0));
  State<2>   start = blank_state(cells);
  Random     random(41);
  const auto field = [](const FlatMesh<2> &mesh, Index node, int d) {
    return d == 0 ? 0.4 * mesh.node_point[0][node]
                  : 0.6 + 0.3 * mesh.node_point[1][node] - 0.2 * mesh.node_point[0][node];
  };
  for (Index cell = 0; cell < cells.n_cells; ++cell)
    {
      const double phi = random(0., 0.5);
      set_material(start.material[0], cell, start.volume[cell], (1. - phi) * 2.75, random(0., 0.02), phi);
    }
  CornerVelocities<2> corners(cells.n_cells);
  for (Index i = 0; i < cells.n_cells * 4; ++i)
    for (int d = 0; d < 2; ++d)
      corners.velocity[d][i] = field(cells, cells.cell_node[i], d);
  gather_velocities<2>(cells, boundaries_of(grid.symmetry), corners, KineticLoss::heat, start);

  const auto                     elements = mesh_of(grid, cells.key, Cohesion::fragments);
  const std::vector<std::string> names{"aluminium", "steel"};
  TakenUp<2>                     report;
  const State<2>                 debris =
      to_lagrangian<2>(cells, start, elements, boundaries_of(grid.symmetry), KineticLoss::heat, names, report);
  const auto layout = CellPacketLayout<2>::of(debris);
  Target     target(grid, cells.key);
  target.lay_down(grid, gather_elements<2>(MPI_COMM_SELF, layout, elements_of<2>(layout, elements, debris)), distended);
  expect_closed({}, target);
  for (Index node = 0; node < cells.n_nodes; ++node)
    for (int d = 0; d < 2; ++d)
      EXPECT_NEAR(target.state.velocity[d][node], field(cells, node, d), 1e-12);
  for (Index cell = 0; cell < cells.n_cells; ++cell)
    {
      EXPECT_NEAR(target.state.material[0].density[cell], start.material[0].density[cell], 1e-12);
      EXPECT_NEAR(target.state.material[0].energy[cell], start.material[0].energy[cell], 1e-12);
      EXPECT_NEAR(target.state.material[0].void_fraction[cell], start.material[0].void_fraction[cell], 1e-12);
    }
  EXPECT_LT(std::abs(target.kinetic_loss()), 1e-12 * target.report.elements.kinetic_energy);
}
