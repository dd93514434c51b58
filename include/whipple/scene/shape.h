// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <concepts>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace whipple
{
  template <int dim>
  class Shape;

  /// An axis-aligned box.
  template <int dim>
  struct Box
  {
    Vector<dim> lower{}; ///< cm
    Vector<dim> upper{}; ///< cm
  };

  /// A plane x[axis] = place behind which a scene goes on as its mirror image.
  struct MirrorPlane
  {
    int    axis  = 0;
    double place = 0; ///< cm
  };

  /// A convex part of a shape: the hull of its corners, counter-clockwise, and all that is nearer to it than the
  /// radius.
  template <int dim>
  struct ConvexPart
  {
    std::vector<Vector<dim>> corner;     ///< cm
    double                   radius = 0; ///< cm
  };

  /// How a body is turned before it enters: about a point in the plane of a planar scene, or end for end.
  template <int dim>
  class Turn
  {
  public:
    /// By an angle in degrees from axis 0 towards axis 1; multiples of 90 degrees are exact.
    static Turn
    in_plane(double degrees, const Vector<dim> &center);

    /// By 180 degrees about a line across the axis of r, z: z becomes 2 z_c - z.
    static Turn
    end_for_end(const Vector<dim> &center);

    Vector<dim>
    operator()(const Vector<dim> &x) const;

  private:
    Vector<dim> center_;
    Vector<dim> image_[dim]; ///< of the unit vectors
  };

  /// A region of space with exact measures: what a body is before the run. Immutable.
  template <int dim>
  class ShapeGeometry
  {
  public:
    virtual ~ShapeGeometry() = default;

    /// Smallest axis-aligned box around it; infinite where the shape reaches over the whole domain. Along flight_axis
    /// its lower end is the front face of a wall, its upper end the rear face. cm
    virtual Box<dim>
    extent() const = 0;

    /// Exact volume of the part of it in a box: an area times 1 cm, or the volume of revolution. cm^3
    virtual double
    volume(Symmetry symmetry, const Vector<dim> &lower, const Vector<dim> &upper) const = 0;

    /// Whether a point lies in it or, to round-off, on its edge.
    virtual bool
    contains(const Vector<dim> &x) const = 0;

    /// Convex parts that make it up, at least as far as a box reaches.
    virtual std::vector<ConvexPart<dim>>
    parts(const Box<dim> &window) const = 0;

    /// Least distance through it, as far as the mesh must resolve it, cm; what touches a mirror goes on behind it.
    virtual double
    least_thickness(std::span<const MirrorPlane> mirrors) const = 0;

    /// Whether it is its own mirror image about axis 0 = 0.
    virtual bool
    is_mirrored() const = 0;

    /// Whether it is its extent.
    virtual bool
    is_box() const
    {
      return false;
    }

    /// The shape turned. What reaches over the whole domain does so afterwards.
    virtual Shape<dim>
    turned(const Turn<dim> &turn, const Box<dim> &domain) const = 0;
  };

  /// The shape of a body, of whatever kind.
  template <int dim>
  class Shape
  {
  public:
    Shape() = default;

    template <std::derived_from<ShapeGeometry<dim>> Geometry>
    Shape(Geometry geometry)
      : geometry_(std::make_shared<const Geometry>(std::move(geometry)))
    {
    }
    Shape(const Box<dim> &box);

    const ShapeGeometry<dim> *
    operator->() const
    {
      return geometry_.get();
    }

    /// The shape as one of a certain kind (Sphere, Plate ...), null if it is none.
    template <typename Geometry>
    const Geometry *
    as() const
    {
      return dynamic_cast<const Geometry *>(geometry_.get());
    }

  private:
    std::shared_ptr<const ShapeGeometry<dim>> geometry_;
  };

  template <int dim>
  Box<dim>
  extent(const Shape<dim> &shape)
  {
    return shape->extent();
  }

  /// Whether two shapes share volume; touching (to a relative 1e-12) is not sharing.
  template <int dim>
  bool
  overlap(const Shape<dim> &a, const Shape<dim> &b);
} // namespace whipple
