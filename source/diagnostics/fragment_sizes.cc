// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/fragment_sizes.h>
#include <whipple/effect/effect.h>
#include <whipple/state/exact_sum.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Bins are [2^(e-1), 2^e) cm with e in this range; what is smaller or larger is in the first or last.
    constexpr int least_exponent = -20, largest_exponent = 10;

    /// What one material is in a cell or a part.
    struct Parcel
    {
      double mass   = 0; ///< g
      double share  = 0; ///< of it that has broken
      double moment = 0; ///< share times size, cm
      double solid  = 0; ///< true density, g/cm^3
    };

    /// The part of it that has broken.
    struct Broken
    {
      double mass   = 0; ///< g
      double size   = 0; ///< cm
      double number = 0; ///< of fragments, cubes of that size
    };

    Broken
    broken_part(const Parcel &p)
    {
      if (!(p.mass > 0) || !(p.share > 0))
        return {};
      Broken broken{p.share * p.mass, p.moment / p.share, 0.};
      if (!(broken.size > 0) || !std::isfinite(broken.size))
        return {};
      broken.number = broken.mass / (p.solid * broken.size * broken.size * broken.size);
      return broken;
    }

    int
    bin_of(double size)
    {
      int exponent;
      std::frexp(size, &exponent);
      return std::clamp(exponent, least_exponent, largest_exponent) - least_exponent;
    }
  } // namespace

  template <int dim>
  std::optional<FragmentSizes>
  measure_fragments(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state,
                    MPI_Comm communicator, const WaitingDebris<dim> *waiting)
  {
    const int share  = field_index(layout.fields, "fragmented share");
    const int moment = field_index(layout.fields, "fragment size moment");
    if (share < 0)
      return std::nullopt;
    constexpr int                      bins = largest_exponent - least_exponent + 1;
    std::array<ExactSum, 2 + 2 * bins> sums; // unbroken mass, mass times size, masses, numbers
    const auto                         add = [&sums](const Parcel &parcel) {
      const Broken broken = broken_part(parcel);
      sums[0].add(parcel.mass - broken.mass);
      if (!(broken.mass > 0))
        return;
      const int bin = bin_of(broken.size);
      sums[1].add(broken.mass * broken.size);
      sums[2 + bin].add(broken.mass);
      sums[2 + bins + bin].add(broken.number);
    };
    for (const MaterialState &m : state.material)
      for (Index c = 0; c < mesh.n_owned; ++c)
        add({m.mass[c], m.fields[share].value[c], m.fields[moment].value[c],
             m.density[c] / (m.has_voids() ? 1. - m.void_fraction[c] : 1.)});
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    if (waiting && rank == 0)
      for (const Waiting<dim> &part : waiting->parts)
        {
          const auto        layout_of_packet = CellPacketLayout<dim>::of(state);
          const CellPacket &packet           = part.element.packet;
          for (int m = 0; m < layout_of_packet.n_materials(); ++m)
            add({packet[layout_of_packet.mass(m)], packet[layout_of_packet.field(m, share)],
                 packet[layout_of_packet.field(m, moment)],
                 packet[layout_of_packet.density(m)] / (1. - packet[layout_of_packet.void_fraction(m)])});
        }
    ExactSum::reduce(sums, communicator);

    FragmentSizes result;
    result.unbroken_mass = sums[0].value();
    double mass          = 0;
    int    first = bins, last = -1; // bins that hold something
    for (int b = 0; b < bins; ++b)
      if (sums[2 + b].value() > 0)
        {
          first = std::min(first, b);
          last  = b;
          mass += sums[2 + b].value();
          result.number += sums[2 + bins + b].value();
        }
    if (!(mass > 0))
      return std::nullopt;
    result.mean_size = sums[1].value() / mass;
    for (int b = first; b <= last; ++b)
      {
        result.edges.push_back(std::ldexp(0.5, b + least_exponent));
        result.mass.push_back(sums[2 + b].value());
        result.number_of_bin.push_back(sums[2 + bins + b].value());
      }
    result.edges.push_back(std::ldexp(1., last + least_exponent));
    return result;
  }

  template std::optional<FragmentSizes>
  measure_fragments(const FieldLayout &, const FlatMesh<2> &, const State<2> &, MPI_Comm, const WaitingDebris<2> *);
} // namespace whipple
