// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/element_pieces.h>

#include <whipple/error.h>
#include <whipple/state/momentum_restore.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace whipple::projection
{
  namespace
  {
    using CornerVectors = std::array<Vector<2>, 4>;

    [[noreturn]] void
    refuse(const Element<2> &element, double volume, double mass)
    {
      std::ostringstream text;
      text << "projection onto cells: element with key " << element.key << " has volume " << volume << " cm^3 and mass "
           << mass << " g; corners";
      for (int k = 0; k < 4; ++k)
        text << " (" << element.position[0][k] << ", " << element.position[1][k] << ")";
      throw StateError(text.str());
    }

    /// Volume, mean velocity and kinetic energy about it of both triangles together, for mass / volume = 1.
    Motion
    unit_density_motion(Symmetry symmetry, const std::array<Triangle, 2> &triangles)
    {
      Motion sum;
      for (const Triangle &triangle : triangles)
        {
          const Moments m = moments(symmetry, as_polygon(triangle));
          sum.add({m.volume, m.mean_x, m.mean_u, 0.5 * m.uu, m.xx, m.ux});
        }
      return sum;
    }

    /// Replace the velocities by target + scale (u - mean), without touching their bits more than needed.
    void
    move(std::array<Triangle, 2> &triangles, const Vector<2> &mean, const Vector<2> &target, double scale)
    {
      for (Triangle &triangle : triangles)
        for (Vertex &v : triangle)
          for (int d = 0; d < 2; ++d)
            v.u[d] = target[d] + scale * (v.u[d] - mean[d]);
    }

    /// Volume and voids of the materials once laid down; returns the share of the element's volume that they take.
    double
    lay_out_materials(const CellPacketLayout<2> &layout, const CellPacket &packet, Representation representation,
                      ElementPieces &pieces)
    {
      double bulk = 0, laid_down = 0;
      for (int m = 0; m < layout.n_materials(); ++m)
        {
          const double volume = packet[layout.volume(m)], phi = packet[layout.void_fraction(m)];
          const bool   solid = representation == Representation::packages;
          pieces.material_volume.push_back(solid ? (1. - phi) * volume : volume);
          pieces.void_fraction.push_back(solid ? 0. : phi);
          bulk += volume;
          laid_down += pieces.material_volume.back();
        }
      return laid_down / bulk;
    }
  } // namespace

  Motion
  ElementPieces::motion(const Moments &part) const
  {
    const double density = mass / volume, share = part.volume / volume;
    Motion       motion{share * mass, part.mean_x, part.mean_u, 0.5 * density * part.uu + unshown * share * mass,
                  part.xx,      part.ux};
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        {
          motion.xx[a][b] *= density;
          motion.ux[a][b] *= density;
        }
    return motion;
  }

  geometry::Quad
  mirrored(Symmetry symmetry, geometry::Quad x)
  {
    if (symmetry == Symmetry::axisymmetric)
      for (double &r : x[0])
        r = std::abs(r);
    return x;
  }

  ElementPieces
  pieces_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element,
            Representation representation)
  {
    ElementPieces  pieces;
    geometry::Quad x = element.position, u;
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        u[d][k] = element.packet[layout.velocity(d, k)];
    for (int k = 0; k < 4; ++k)
      if (symmetry == Symmetry::axisymmetric && x[0][k] < 0)
        {
          u[0][k] = -u[0][k];
          ++pieces.mirrored_corners;
        }
    x = mirrored(symmetry, x);

    CornerVectors velocity;
    for (int k = 0; k < 4; ++k)
      velocity[k] = {{u[0][k], u[1][k]}};
    const Vector<2> mean = mean_velocity<2>(element.corner_mass, velocity);
    const double    kinetic =
        relative_kinetic_energy<2>(element.corner_mass, velocity, mean) + element.packet[layout.kinetic_remainder()];
    for (int m = 0; m < layout.n_materials(); ++m)
      pieces.mass += element.packet[layout.mass(m)];

    const Bisection bisection = bisect(x, u);
    pieces.triangle           = bisection.triangle;
    pieces.folded             = bisection.folded;
    const Motion as_given     = unit_density_motion(symmetry, pieces.triangle);
    if (!(as_given.mass > 0) || !(pieces.mass > 0))
      refuse(element, as_given.mass, pieces.mass);

    const double share   = lay_out_materials(layout, element.packet, representation, pieces);
    const double density = pieces.mass / as_given.mass;
    pieces.volume        = as_given.mass;
    double scale         = 0; // packages: one velocity
    if (representation == Representation::distended)
      {
        const double energy = density * as_given.kinetic;
        scale               = energy > kinetic ? std::sqrt(kinetic / energy) : 1.;
      }
    else
      {
        for (Triangle &triangle : pieces.triangle)
          triangle = shrink(triangle, std::sqrt(share));
        pieces.volume = unit_density_motion(symmetry, pieces.triangle).mass;
      }
    move(pieces.triangle, as_given.mean_u, mean, scale);
    pieces.unshown = std::max(0., kinetic - scale * scale * density * as_given.kinetic) / pieces.mass;
    return pieces;
  }
} // namespace whipple::projection
