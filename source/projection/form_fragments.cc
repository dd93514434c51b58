// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/cell_tree.h>
#include <whipple/projection/form_fragments.h>
#include <whipple/projection/group_parcels.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace whipple::projection
{
  namespace
  {
    /// A fragment is seen if it is this many cells wide, and this many times as wide as the solid of one element.
    constexpr double least_width = 2;

    /// The cell that an element came from.
    Parcel
    parcel_of(const Lattice<2> &lattice, CellKey key)
    {
      Parcel parcel;
      CellTree<2>::box(lattice, key_level(key), key_point<2>(key), parcel.lower, parcel.upper);
      return parcel;
    }

    double
    middle(const Parcel &parcel, int axis)
    {
      return 0.5 * (parcel.lower[axis] + parcel.upper[axis]);
    }

    /// Length of the circle that a parcel stands for, 1 cm in planar geometry.
    double
    circumference(Symmetry symmetry, double r)
    {
      return symmetry == Symmetry::planar ? 1. : 2. * std::numbers::pi * r;
    }

    /// One group of elements on its way to become a piece.
    class Piece
    {
    public:
      Piece(const LandingView &view, Rings rings, std::span<const Parcel> parcels,
            std::span<const std::size_t> element_of, const ParcelGroup &group)
        : view_(view)
        , rings_(rings)
        , parcels_(parcels)
        , element_of_(element_of)
        , group_(group)
        , mixture_(view.layout.size(), 0.)
      {
      }

      /// Add up, and see where the piece lies. @returns false if it would reach across the axis
      bool
      settle(const std::vector<Element<2>> &elements)
      {
        add_up(elements);
        const bool ring = view_.lattice.symmetry == Symmetry::axisymmetric && !on_axis_;
        double     area = 0, volume = 0, least = parcels_[group_[0]].lower[0];
        Vector<2>  centroid{}; // of the area
        for (const Index i : group_)
          {
            const Parcel &p = parcels_[i];
            area += p.area();
            volume += circumference(view_.lattice.symmetry, middle(p, 0)) * p.area();
            for (int d = 0; d < 2; ++d)
              centroid[d] += (middle(p, d) - centroid[d]) * (p.area() / area);
            least = std::min(least, p.lower[0]);
          }
        from_ = centroid;
        to_   = total_.mean_x;
        if (on_axis_)
          {
            scale_   = std::cbrt(solid_ / volume);
            from_[0] = to_[0] = 0.;
          }
        else
          {
            if (ring && rings_ == Rings::thinned)
              solid_within_ = from_[0];
            const double r = std::min(to_[0], solid_within_);
            scale_         = std::sqrt(solid_ / (circumference(view_.lattice.symmetry, r) * area));
            if (r < to_[0])
              void_fraction_ = 1. - r / to_[0];
          }
        if (ring && to_[0] + scale_ * (least - from_[0]) < 0)
          return false;
        // along z the centre of mass stays: a ring's volume does not change when it is moved
        double mean = 0, sum = 0;
        for (const Index i : group_)
          {
            const double v = volume_of(i);
            sum += v;
            mean += (place(1, middle(parcels_[i], 1)) - mean) * (v / sum);
          }
        to_[1] += total_.mean_x[1] - mean;
        return true;
      }

      /// Make its elements parts of it.
      void
      write(std::vector<Element<2>> &elements, FragmentReport &report)
      {
        double volume = 0;
        for (const Index i : group_)
          volume += volume_of(i);
        const double lost = lost_kinetic();
        for (const Index i : group_)
          {
            write_part(volume_of(i) / volume, parcels_[i], lost, elements[element_of_[i]]);
            elements[element_of_[i]].piece        = report.pieces;
            elements[element_of_[i]].solid_within = solid_within_;
          }
        report.kinetic_loss += lost;
        if (on_axis_)
          report.axis_impulse += total_.mass * total_.mean_u[0];
        report.mass += total_.mass;
        ++report.pieces;
      }

    private:
      void
      add_up(const std::vector<Element<2>> &elements)
      {
        const CellPacketLayout<2> &layout = view_.layout;
        for (const Index i : group_)
          {
            const Element<2> &element = elements[element_of_[i]];
            total_.add(corners_of(view_.lattice.symmetry, layout, element).motion);
            solid_ += solid_volume(layout, element.packet);
            mix(element.packet);
            on_axis_ = on_axis_ || (view_.lattice.symmetry == Symmetry::axisymmetric && parcels_[i].lower[0] <= 0.);
          }
      }

      /// Mean values of the materials, by increments: values that agree keep their bits.
      void
      mix(const CellPacket &packet)
      {
        const CellPacketLayout<2> &layout = view_.layout;
        for (int m = 0; m < layout.n_materials(); ++m)
          {
            const double mass  = packet[layout.mass(m)];
            const double solid = (1. - packet[layout.void_fraction(m)]) * packet[layout.volume(m)];
            if (!(mass > 0) || !(solid > 0))
              continue;
            mixture_[layout.mass(m)] += mass;
            mixture_[layout.volume(m)] += solid;
            const double by_mass = mass / mixture_[layout.mass(m)], by_volume = solid / mixture_[layout.volume(m)];
            const auto   approach = [&](int entry, double weight, double target) {
              mixture_[entry] += weight * (target - mixture_[entry]);
            };
            approach(layout.energy(m), by_mass, packet[layout.energy(m)]);
            approach(layout.density(m), by_volume, mass / solid);
            for (int f = 0; f < layout.n_fields(); ++f)
              approach(layout.field(m, f), layout.carrier[f] == Carrier::mass ? by_mass : by_volume,
                       packet[layout.field(m, f)]);
          }
      }

      /// Kinetic energy that the piece does not have, Mbar cm^3: of the motion inside, and across the axis.
      double
      lost_kinetic() const
      {
        return total_.kinetic + (on_axis_ ? 0.5 * total_.mass * total_.mean_u[0] * total_.mean_u[0] : 0.);
      }

      double
      place(int axis, double x) const
      {
        return to_[axis] + scale_ * (x - from_[axis]);
      }

      double
      volume_of(Index i) const
      {
        const Parcel &p = parcels_[i];
        return circumference(view_.lattice.symmetry, place(0, middle(p, 0))) * scale_ * scale_ * p.area();
      }

      void
      write_part(double share, const Parcel &parcel, double lost, Element<2> &element) const
      {
        const CellPacketLayout<2> &layout = view_.layout;
        element.packet                    = mixture_;
        for (int m = 0; m < layout.n_materials(); ++m)
          {
            element.packet[layout.mass(m)] *= share;
            element.packet[layout.volume(m)] *= share / (1. - void_fraction_);
            element.packet[layout.void_fraction(m)] = void_fraction_;
            if (view_.loss == KineticLoss::heat && element.packet[layout.mass(m)] > 0)
              element.packet[layout.energy(m)] += lost / total_.mass;
          }
        for (int k = 0; k < 4; ++k)
          {
            element.corner_mass[k] = 0.25 * share * total_.mass;
            for (int d = 0; d < 2; ++d)
              {
                element.position[d][k]                = place(d, (k >> d & 1) ? parcel.upper[d] : parcel.lower[d]);
                element.packet[layout.velocity(d, k)] = on_axis_ && d == 0 ? 0. : total_.mean_u[d];
              }
          }
      }

      const LandingView           &view_;
      const Rings                  rings_;
      std::span<const Parcel>      parcels_;
      std::span<const std::size_t> element_of_;
      const ParcelGroup           &group_;

      Motion     total_;
      CellPacket mixture_;           ///< of all its elements: masses and volumes of solid add up, the rest are means
      double     solid_   = 0;       ///< cm^3
      bool       on_axis_ = false;   ///< touches it
      Vector<2>  from_{}, to_{};     ///< what it is shrunk about: where its cells were, and where it is
      double     scale_         = 1; ///< c
      double     void_fraction_ = 0; ///< between the fragments of a thinned ring
      double     solid_within_  = std::numeric_limits<double>::infinity(); ///< Element::solid_within
    };

    /// Whether fragments of the size that an element breaks into are large enough to be shown.
    bool
    is_shown(const Lattice<2> &lattice, const Parcel &parcel)
    {
      return std::isfinite(parcel.size) &&
             parcel.size >= least_width * std::max(lattice.spacing, std::sqrt(parcel.solid));
    }
  } // namespace

  std::vector<Element<2>>
  form_fragments(const LandingView &view, std::vector<Element<2>> elements, std::span<const double> size, Rings rings,
                 FragmentReport &report)
  {
    std::vector<Parcel>      parcels;
    std::vector<std::size_t> element_of;
    for (std::size_t i = 0; i < elements.size(); ++i)
      {
        Parcel parcel = parcel_of(view.lattice, elements[i].key);
        parcel.solid =
            solid_volume(view.layout, elements[i].packet) / circumference(view.lattice.symmetry, middle(parcel, 0));
        parcel.size = size[i];
        if (parcel.solid > 0 && is_shown(view.lattice, parcel))
          {
            parcels.push_back(parcel);
            element_of.push_back(i);
          }
      }
    for (const ParcelGroup &set : touching_sets(parcels))
      for (const ParcelGroup &group : cut_into_fragments(view.lattice.symmetry, parcels, set))
        {
          Piece piece(view, rings, parcels, element_of, group);
          if (piece.settle(elements))
            piece.write(elements, report);
          else
            ++report.not_formed;
        }
    return elements;
  }
} // namespace whipple::projection
