// SPDX-License-Identifier: LGPL-2.1-or-later
// A hundred thousand fragments of very different size, all over one another, laid down on a fixed mesh.
#include "../unit/projection_fixture.h"
#include "case_record.h"

#include <whipple/projection/element.h>
#include <whipple/projection/to_eulerian.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  /// Copies of the elements of a small cloud, each moved, scaled by 10^-2 ... 10^0.5 and turned over the domain.
  std::vector<Element<2>>
  many(const std::vector<Element<2>> &few, std::size_t number, double size, Random &random,
       const CellPacketLayout<2> &layout)
  {
    std::vector<Element<2>> all;
    all.reserve(number);
    for (std::size_t i = 0; i < number; ++i)
      {
        Element<2>   e     = few[i % few.size()];
        const double scale = std::pow(10., random(-2., 0.5)), x = random(0.05, size - 0.05),
                     y   = random(-0.25, -0.35 + size);
        double centre[2] = {0, 0};
        for (int d = 0; d < 2; ++d)
          for (const double p : e.position[d])
            centre[d] += 0.25 * p;
        for (int k = 0; k < 4; ++k)
          {
            e.position[0][k] = x + scale * (e.position[0][k] - centre[0]);
            e.position[1][k] = y + scale * (e.position[1][k] - centre[1]);
            e.corner_mass[k] *= scale * scale;
          }
        for (int m = 0; m < 2; ++m)
          {
            e.packet[layout.mass(m)] *= scale * scale;
            e.packet[layout.volume(m)] *= scale * scale;
          }
        e.key = static_cast<CellKey>(i + 1);
        all.push_back(e);
      }
    return all;
  }

  /// @param thin least void fraction of the fragments; what they hold together fills 0.4 of the cells
  void
  expect_nothing_lost(const std::string &name, std::size_t number, double thin)
  {
    stability::Case table(std::to_string(number) + " overlapping fragments, sizes 1 to 300, " + name,
                          "mass, momentum or energy lost where they overlap, solid squeezed", "projection alone");
    const auto      grid = lattice(Symmetry::planar, 40, 0);
    const auto small = mesh_of(grid, {uniform_keys(grid, 0)[0], uniform_keys(grid, 0)[1], uniform_keys(grid, 0)[41]},
                               Cohesion::fragments);
    State<2>   state = blank_state(small);
    Random     random(7);
    for (Index c = 0; c < small.n_cells; ++c)
      for (int m = 0; m < 2; ++m)
        {
          const double phi = random(thin, 0.5 * (1. + thin));
          set_material(state.material[m], c, 0.5 * state.volume[c], (1. - phi) * (m ? 7.9 : 2.75), random(0., 0.02),
                       phi);
        }
    set_velocities(small, state, 0.3, random);
    const auto layout   = CellPacketLayout<2>::of(state);
    const auto elements = many(gather_elements<2>(MPI_COMM_SELF, layout, elements_of<2>(layout, small, state)), number,
                               4., random, layout);
    const FlatMesh<2> mesh   = mesh_of(grid, uniform_keys(grid, 0));
    State<2>          target = blank_state(mesh);
    const auto        report =
        to_eulerian<2>(MPI_COMM_SELF, grid, layout, elements, *RepresentationRegistry::make(name), mesh,
                       Halo<2>(MPI_COMM_SELF, mesh, {}), {}, Boundaries<2>{}, KineticLoss::heat, target);
    ConservedTotals<2> sum = node_totals(target);
    sum += *report.bookings.of(laid_down::beyond).left;
    const ConservedTotals<2> &all    = report.elements;
    const auto                energy = [](const ConservedTotals<2> &t) { return t.internal_energy + t.kinetic_energy; };
    table.at_most("mass, relative change", std::abs(sum.mass / all.mass - 1.), 1e-12);
    table.at_most("axial momentum, relative change", std::abs(sum.momentum[1] / all.momentum[1] - 1.), 1e-12);
    table.at_most("total energy, relative change", std::abs(energy(sum) / energy(all) - 1.), 1e-12);
    table.at_most("kinetic energy gained / kinetic energy", sum.kinetic_energy / all.kinetic_energy - 1., 1e-12);
    double overfull = 0;
    for (Index c = 0; c < mesh.n_cells; ++c)
      overfull = std::max(overfull, (target.material[0].volume[c] + target.material[1].volume[c]) / target.volume[c]);
    table.at_most("fullest cell, less 1", overfull - 1., 1e-13);
    table.at_most("solid compressed / volume of all cells", report.solid_compressed / 16., 1e-6);
    table.report("solid moved to where there is room / volume of all cells",
                 report.bookings.of(laid_down::spread).event->size / 16.);
  }

  TEST(QuickFragments, TenThousandDistended)
  {
    expect_nothing_lost("distended", 10000, 0.9);
  }
  TEST(Fragments, HundredThousandDistended)
  {
    expect_nothing_lost("distended", 100000, 0.99);
  }
  TEST(Fragments, HundredThousandPackages)
  {
    expect_nothing_lost("packages", 100000, 0.99);
  }
} // namespace
