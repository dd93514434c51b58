// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../figure.h"
#include "projection_fixture.h"

#include <whipple/error.h>
#include <whipple/projection/debris_selection.h>
#include <whipple/projection/to_lagrangian.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  const std::vector<std::string> names{"aluminium", "steel"};

  struct Perforation
  {
    Lattice<2>  grid  = lattice(Symmetry::axisymmetric, 6, 1);
    FlatMesh<2> mesh  = mesh_of(grid, hanging_keys(grid));
    State<2>    state = blank_state(mesh);
    Random      random{21};

    explicit Perforation(double scatter)
    {
      fill_randomly(state, random);
      set_velocities(mesh, state, scatter, random);
    }

    FlatMesh<2>
    elements(const DebrisSelection<2> &selection, Cohesion cohesion) const
    {
      std::vector<CellKey>      keys;
      std::vector<std::uint8_t> intact;
      for (Index cell = 0; cell < mesh.n_owned; ++cell)
        if (selection.kept(cell))
          {
            keys.push_back(mesh.key[cell]);
            intact.push_back(cell % 3 != 0); // which third breaks is of no concern here
          }
      return mesh_of(grid, keys, cohesion == Cohesion::graded ? Bonds(intact) : Bonds(cohesion));
    }
  };

  double
  total_energy(const ConservedTotals<2> &totals)
  {
    return totals.internal_energy + totals.kinetic_energy;
  }
} // namespace

TEST(DebrisSelection, WhatIsKeptAndDroppedIsAllThereWas)
{
  Perforation    p(0.3);
  DebrisCriteria criteria;
  criteria.void_cutoff         = 0.7;
  criteria.plane               = -0.15;
  criteria.least_velocity      = 0.5;
  const auto         selection = select_debris<2>(p.mesh, p.state, criteria);
  ConservedTotals<2> sum;
  for (const auto &amount : selection.amount)
    sum += amount;
  const auto all = node_totals(p.state);
  EXPECT_NEAR(sum.mass, all.mass, 1e-14 * all.mass);
  EXPECT_NEAR(sum.momentum[1], all.momentum[1], 1e-14 * all.momentum[1]);
  EXPECT_NEAR(sum.internal_energy, all.internal_energy, 1e-13 * all.internal_energy);
  EXPECT_NEAR(sum.kinetic_energy, all.kinetic_energy, 1e-13 * all.kinetic_energy);
  for (const Verdict verdict : {Verdict::kept, Verdict::void_cutoff, Verdict::not_debris})
    EXPECT_GT(selection.amount_of(verdict).mass, 0.) << name(verdict);
  EXPECT_EQ(selection.amount_of(Verdict::empty).mass, 0.);
}

TEST(DebrisSelection, EveryCriterionDropsWhatItShould)
{
  Perforation    p(0.);
  DebrisCriteria everything;
  everything.void_cutoff = 1.;
  DebrisCriteria behind = everything, slow = everything, backwards = everything;
  behind.plane             = 0.;
  slow.least_velocity      = 0.61;
  backwards.direction      = -1;
  backwards.least_velocity = 0.;
  const auto kept_all      = select_debris<2>(p.mesh, p.state, everything);
  const auto ahead         = select_debris<2>(p.mesh, p.state, behind);
  for (Index cell = 0; cell < p.mesh.n_owned; ++cell)
    {
      const bool is_empty = cell_mass<2>(p.state, cell) == 0;
      EXPECT_EQ(kept_all.kept(cell), !is_empty);
      EXPECT_EQ(ahead.kept(cell), !is_empty && p.mesh.lower[1][cell] + 0.5 * p.mesh.size[cell] >= 0.);
    }
  EXPECT_EQ(select_debris<2>(p.mesh, p.state, slow).amount_of(Verdict::kept).mass, 0.);
  EXPECT_EQ(select_debris<2>(p.mesh, p.state, backwards).amount_of(Verdict::kept).mass, 0.);
}

TEST(ToLagrangian, AnyCohesionKeepsMassMomentumAndTotalEnergy)
{
  figure::Largest change("projection to Lagrangian: mass, momentum, energy, relative change", "<= 1e-12");
  for (const Cohesion cohesion : {Cohesion::bonded, Cohesion::graded, Cohesion::fragments})
    {
      Perforation    p(0.3);
      const auto     selection = select_debris<2>(p.mesh, p.state, {});
      const auto     elements  = p.elements(selection, cohesion);
      TakenUp<2>     report;
      const State<2> debris = to_lagrangian<2>(p.mesh, p.state, elements, {}, KineticLoss::heat, names, report);
      const auto     kept   = selection.amount_of(Verdict::kept);
      const auto     end    = node_totals(debris);
      change(end.mass / kept.mass - 1.);
      change(end.momentum[1] / kept.momentum[1] - 1.);
      change(total_energy(end) / total_energy(kept) - 1.);
      EXPECT_NEAR(end.mass, kept.mass, 1e-14 * kept.mass);
      EXPECT_NEAR(end.momentum[0], kept.momentum[0], 1e-13 * kept.momentum[1]);
      EXPECT_NEAR(end.momentum[1], kept.momentum[1], 1e-13 * kept.momentum[1]);
      EXPECT_NEAR(total_energy(end), total_energy(kept), 1e-13 * total_energy(kept));
      EXPECT_NEAR(kept.kinetic_energy - end.kinetic_energy, *report.booking.converted, 1e-13 * kept.kinetic_energy);
      EXPECT_GT(*report.booking.converted, 0.); // former hanging nodes
      EXPECT_NEAR(total_energy(report.after), total_energy(report.before), 1e-13 * total_energy(kept));
    }
}

TEST(ToLagrangian, TrueDensityIsKeptAndOpenVoidFolded)
{
  Perforation    p(0.3);
  const auto     elements = p.elements(select_debris<2>(p.mesh, p.state, {}), Cohesion::fragments);
  TakenUp<2>     report;
  const State<2> debris  = to_lagrangian<2>(p.mesh, p.state, elements, {}, KineticLoss::drop, names, report);
  Index          element = 0;
  for (Index cell = 0; cell < p.mesh.n_cells; ++cell)
    {
      if (element == elements.n_cells || elements.key[element] != p.mesh.key[cell])
        continue;
      double filled = 0;
      for (int m = 0; m < 2; ++m)
        {
          const MaterialState &a = p.state.material[m], &b = debris.material[m];
          filled += b.volume[element];
          if (b.mass[element] == 0)
            continue;
          const double true_density = a.density[cell] / (1. - a.void_fraction[cell]);
          EXPECT_NEAR(b.density[element] / (1. - b.void_fraction[element]), true_density, 1e-13 * true_density);
          EXPECT_NEAR(b.density[element], b.mass[element] / b.volume[element], 1e-13 * b.density[element]);
          EXPECT_EQ(b.energy[element], a.energy[cell]);
          EXPECT_EQ(b.fields[1].value[element], a.fields[1].value[cell]);
        }
      EXPECT_NEAR(filled, debris.volume[element], 1e-12 * debris.volume[element]);
      for (int k = 0; k < 4; ++k)
        for (int d = 0; d < 2; ++d)
          EXPECT_NEAR(debris.velocity[d][elements.cell_node[4 * element + k]],
                      p.state.velocity[d][p.mesh.cell_node[4 * cell + k]], 1e-14);
      ++element;
    }
  EXPECT_EQ(element, elements.n_cells);
}

TEST(ToLagrangian, OpenVoidInAMaterialWithoutVoidLawIsRefused)
{
  Perforation p(0.);
  for (MaterialState &material : p.state.material)
    {
      material.carries_voids = false;
      material.void_fraction.clear();
    }
  const auto elements = p.elements(select_debris<2>(p.mesh, p.state, {}), Cohesion::fragments);
  TakenUp<2> report;
  try
    {
      to_lagrangian<2>(p.mesh, p.state, elements, {}, KineticLoss::heat, names, report);
      FAIL() << "accepted";
    }
  catch (const StateError &error)
    {
      EXPECT_NE(std::string(error.what()).find("void law"), std::string::npos);
      EXPECT_TRUE(std::string(error.what()).find("aluminium") != std::string::npos ||
                  std::string(error.what()).find("steel") != std::string::npos);
    }
}
