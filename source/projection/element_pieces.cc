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
    using PointAtCorner = std::array<Vector<2>, 4>;

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

    /// An element cut in two, before its materials are laid out.
    struct CutElement
    {
      ElementPieces pieces;   ///< triangles, mass, volume
      Motion        as_given; ///< of both triangles at unit density, with the velocities of the corners
      Motion        motion;   ///< of the corner masses
    };

    CutElement
    cut(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element)
    {
      const ElementCorners corners = corners_of(symmetry, layout, element);
      CutElement           result{{}, {}, corners.motion};
      ElementPieces       &pieces = result.pieces;
      pieces.mass                 = corners.motion.mass;
      pieces.mirrored_corners     = corners.mirrored_corners;

      const Bisection bisection = bisect(corners.x, corners.u);
      pieces.triangle           = bisection.triangle;
      pieces.folded             = bisection.folded;
      result.as_given           = unit_density_motion(symmetry, pieces.triangle);
      pieces.volume             = result.as_given.mass;
      if (!(pieces.volume > 0) || !(pieces.mass > 0))
        refuse(element, pieces.volume, pieces.mass);
      return result;
    }

    /// Give the triangles the mean velocity of the corner masses, and `scale` of the motion about it.
    ElementPieces
    set_in_motion(CutElement cut, double scale)
    {
      ElementPieces &pieces  = cut.pieces;
      const double   density = pieces.mass / cut.as_given.mass;
      move(pieces.triangle, cut.as_given.mean_u, cut.motion.mean_u, scale);
      pieces.unshown = std::max(0., cut.motion.kinetic - scale * scale * density * cut.as_given.kinetic) / pieces.mass;
      return std::move(pieces);
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

  CornerVectors<2>
  mirrored(Symmetry symmetry, CornerVectors<2> x)
  {
    if (symmetry == Symmetry::axisymmetric)
      for (double &r : x[0])
        r = std::abs(r);
    return x;
  }

  ElementCorners
  corners_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element)
  {
    ElementCorners result;
    PointAtCorner  position, velocity;
    result.x = mirrored(symmetry, element.position);
    for (int k = 0; k < 4; ++k)
      {
        for (int d = 0; d < 2; ++d)
          result.u[d][k] = element.packet[layout.velocity(d, k)];
        if (symmetry == Symmetry::axisymmetric && element.position[0][k] < 0)
          {
            result.u[0][k] = -result.u[0][k];
            ++result.mirrored_corners;
          }
        position[k] = {{result.x[0][k], result.x[1][k]}};
        velocity[k] = {{result.u[0][k], result.u[1][k]}};
      }
    for (int m = 0; m < layout.n_materials(); ++m)
      result.motion.mass += element.packet[layout.mass(m)];
    result.motion.mean_x  = mean_velocity<2>(element.corner_mass, position); // weights are the same
    result.motion.mean_u  = mean_velocity<2>(element.corner_mass, velocity);
    result.motion.kinetic = relative_kinetic_energy<2>(element.corner_mass, velocity, result.motion.mean_u) +
                            element.packet[layout.kinetic_remainder()];
    return result;
  }

  ElementPieces
  distended_pieces(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element)
  {
    CutElement result = cut(symmetry, layout, element);
    for (int m = 0; m < layout.n_materials(); ++m)
      {
        result.pieces.material_volume.push_back(element.packet[layout.volume(m)]);
        result.pieces.void_fraction.push_back(element.packet[layout.void_fraction(m)]);
      }
    const double energy = result.pieces.mass / result.as_given.mass * result.as_given.kinetic;
    const double scale  = energy > result.motion.kinetic ? std::sqrt(result.motion.kinetic / energy) : 1.;
    return set_in_motion(std::move(result), scale);
  }

  ElementPieces
  solid_pieces(Symmetry symmetry, const CellPacketLayout<2> &layout, const Element<2> &element)
  {
    CutElement     result = cut(symmetry, layout, element);
    ElementPieces &pieces = result.pieces;
    double         bulk = 0, solid = 0;
    for (int m = 0; m < layout.n_materials(); ++m)
      {
        const double volume = element.packet[layout.volume(m)];
        pieces.material_volume.push_back((1. - element.packet[layout.void_fraction(m)]) * volume);
        pieces.void_fraction.push_back(0.);
        bulk += volume;
        solid += pieces.material_volume.back();
      }
    for (Triangle &triangle : pieces.triangle)
      triangle = shrink(triangle, std::sqrt(solid / bulk));
    pieces.volume = unit_density_motion(symmetry, pieces.triangle).mass;
    return set_in_motion(std::move(result), 0.);
  }
} // namespace whipple::projection
