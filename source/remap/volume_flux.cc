// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/remap/volume_flux.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace whipple
{
  namespace
  {
    /// A cell this full of one material has no interface worth reconstructing.
    constexpr double full_fraction = 1. - 1e-12;

    /// A face that sweeps less than this share of the donor moves nothing: it is round-off.
    constexpr double least_share = 1e-15;

    /// Less of a material than this share of the donor's volume stays there, unless the receiver has some: a trace that
    /// would begin a state in a cell of its own (doc/theory/traces.md).
    constexpr double least_entry = 1e-10;

    /// A trace that fills less than this share of its cell stays there: handed on it would shrink to nothing.
    constexpr double least_held = 1e-30;

    /// The box of the donor that leaves through one of its sides: true volume `share` of the cell, transverse extent
    /// that of the subface, thickness to fit (a quadratic for rings, doc/theory/remap.md).
    template <int dim>
    struct DonorBox
    {
      Vector<dim> lower, upper;

      DonorBox(const FlatMesh<dim> &mesh, const Index cell, const int axis, const bool upper_side, const int part,
               const double share, const double part_share)
      {
        const double size = mesh.size[cell];
        for (int d = 0; d < dim; ++d)
          {
            lower[d] = mesh.lower[d][cell];
            upper[d] = lower[d] + size;
          }
        const int transverse = 1 - axis;
        if (part == 0)
          upper[transverse] -= 0.5 * size;
        else if (part == 1)
          lower[transverse] += 0.5 * size;

        const double fraction = std::min(share / part_share, 1.);
        double       cut      = lower[axis] + (upper_side ? 1. - fraction : fraction) * size;
        if (mesh.symmetry == Symmetry::axisymmetric && axis == 0)
          {
            const double r0 = lower[0], r1 = upper[0], ring = fraction * (r1 - r0) * (r1 + r0);
            cut = upper_side ? r1 - ring / (r1 + std::sqrt(std::max(r1 * r1 - ring, 0.)))
                             : r0 + ring / (r0 + std::sqrt(r0 * r0 + ring));
          }
        (upper_side ? lower : upper)[axis] = cut;
      }
    };

    template <int dim>
    std::string
    describe(const FlatMesh<dim> &mesh, const Index cell)
    {
      std::ostringstream text;
      text.precision(8);
      text << "cell " << cell << " of size " << mesh.size[cell] << " cm at (";
      for (int d = 0; d < dim; ++d)
        text << (d ? ", " : "") << mesh.lower[d][cell];
      text << ") cm";
      return text.str();
    }
  } // namespace

  namespace
  {
    /// Whether a material would begin a state in a cell that has none of it.
    template <int dim>
    bool
    begins(const State<dim> &state, const Index receiver, const Index m)
    {
      return receiver != none && state.material[m].volume[receiver] == 0;
    }
  } // namespace

  template <int dim>
  VolumeFlux<dim>::VolumeFlux(const FlatMesh<dim> &mesh, const RemapParameters &parameters)
    : mesh_(&mesh)
    , parameters_(parameters)
    , reconstruction_(mesh)
    , content_(mesh.n_cells, empty)
  {
  }

  template <int dim>
  void
  VolumeFlux<dim>::classify(const State<dim> &state)
  {
    mixed_cells_.clear();
    const Index n_materials = static_cast<Index>(state.material.size());
    for (Index c = 0; c < mesh_->n_cells; ++c)
      {
        Index content = empty;
        for (Index m = 0; m < n_materials; ++m)
          if (const double volume = state.material[m].volume[c]; volume > 0)
            {
              const bool full = content == empty && volume >= full_fraction * state.volume[c];
              content         = full ? first_full - m : 0;
              if (!full)
                break;
            }
        // another material beside a full one
        for (Index m = first_full - content + 1; content <= first_full && m < n_materials; ++m)
          if (state.material[m].volume[c] > 0)
            content = 0;
        if (content >= 0)
          {
            content = static_cast<Index>(mixed_cells_.size());
            mixed_cells_.push_back(c);
          }
        content_[c] = content;
      }
    reconstruction_.restart(static_cast<Index>(mixed_cells_.size()), n_materials);
  }

  template <int dim>
  void
  VolumeFlux<dim>::cut_donor_boxes(const State<dim> &state, const SweepTopology<dim> &topology,
                                   const std::vector<double> &swept)
  {
    const FlatFaces<dim> &faces       = *topology.faces;
    const Index           n_materials = static_cast<Index>(state.material.size());
    for (const Index f : mixed_faces_)
      {
        const double moved        = -swept[f]; // along + axis
        const bool   upper_side   = moved > 0; // the face is the donor's upper side
        int          side         = upper_side ? 0 : 1;
        Index        cell         = faces.cell[side][f];
        const bool   from_outside = cell == none;
        if (from_outside)
          cell = faces.cell[1 - side][f];
        const double        share = std::abs(moved) / state.volume[cell];
        const double        part  = from_outside ? 1. : topology.part_share[side][f];
        const DonorBox<dim> box(*mesh_, cell, topology.axis, upper_side, from_outside ? -1 : faces.part[side][f], share,
                                part);
        double              filled = 0; // by the materials so far
        for (Index m = 0; m < n_materials; ++m)
          {
            if (!(state.material[m].volume[cell] > 0))
              continue;
            const double up_to_here =
                from_outside ? InterfaceReconstruction<dim>::cumulated_fraction(state, cell, m)
                             : reconstruction_.filled_share(state, content_[cell], cell, m, box.lower, box.upper);
            if (up_to_here > filled)
              {
                const double own = up_to_here - filled;
                filled           = up_to_here;
                if (own * share > least_entry || !begins(state, faces.cell[upper_side ? 1 : 0][f], m))
                  flux[m][f] = moved * own;
              }
          }
      }
  }

  namespace
  {
    /// What leaves a cell in a sweep.
    template <int dim>
    double
    outflow(const SweepTopology<dim> &topology, const Index c, const std::vector<double> &flux)
    {
      double sum = 0;
      for (int s = 0; s < 2; ++s)
        sum += std::max(-flux[topology.lower[s][c]], 0.) + std::max(flux[topology.upper[s][c]], 0.);
      return sum;
    }

    /// The second largest of what leaves a cell through its (sub)faces; that of the first of equal ones is larger.
    template <int dim>
    double
    second_largest_outflow(const SweepTopology<dim> &topology, const Index c, const std::vector<double> &flux)
    {
      double largest = 0, second = 0;
      for (int s = 0; s < 2; ++s)
        for (const double out : {-flux[topology.lower[s][c]], flux[topology.upper[s][c]]})
          {
            second  = std::max(second, std::min(out, largest));
            largest = std::max(largest, out);
          }
      return second < largest ? second : 0.;
    }

    /// Nothing leaves a cell where no more than `least` would.
    template <int dim>
    void
    drop_outflow(const SweepTopology<dim> &topology, const Index c, const double least, std::vector<double> &flux)
    {
      for (int s = 0; s < 2; ++s)
        {
          double &low = flux[topology.lower[s][c]], &high = flux[topology.upper[s][c]];
          if (low < 0 && -low <= least)
            low = 0;
          if (high > 0 && high <= least)
            high = 0;
        }
    }
  } // namespace

  template <int dim>
  void
  VolumeFlux<dim>::limit_donors(const State<dim> &state, const SweepTopology<dim> &topology, RemapSums<dim> &report)
  {
    const Index n_materials = static_cast<Index>(state.material.size());
    for (const Index c : mixed_cells_)
      for (Index m = 0; m < n_materials; ++m)
        {
          const double held = state.material[m].volume[c];
          if (!(held > 0))
            continue;
          const double given = outflow(topology, c, flux[m]), left = held - given;
          if (!(given > 0))
            continue;
          if (left >= parameters_.remnant_fraction * state.volume[c])
            {
              drop_outflow(topology, c, least_share * state.volume[c], flux[m]);
              continue;
            }
          if (held < least_held * state.volume[c])
            {
              drop_outflow(topology, c, given, flux[m]);
              continue;
            }
          // a trace goes as a whole: shared out again and again it would shrink to nothing
          const double least =
              held < least_entry * state.volume[c] ? second_largest_outflow(topology, c, flux[m]) : least_share * given;
          drop_outflow(topology, c, least, flux[m]);
          const double scale = held / outflow(topology, c, flux[m]);
          for (int s = 0; s < 2; ++s)
            {
              double &low = flux[m][topology.lower[s][c]], &high = flux[m][topology.upper[s][c]];
              low  = low < 0 ? low * scale : low;
              high = high > 0 ? high * scale : high;
            }
          emptied[m].push_back(c);
          if (c < mesh_->n_owned && left > 0)
            {
              report.remnant_mass.add(left * state.material[m].density[c]);
              ++report.remnant_cells;
            }
        }
  }

  template <int dim>
  void
  VolumeFlux<dim>::check_ends(const SweepTopology<dim> &topology) const
  {
    for (const Index f : topology.end_faces)
      {
        const FlatFaces<dim> &faces = *topology.faces;
        const Index           cell  = std::max(faces.cell[0][f], faces.cell[1][f]);
        for (const std::vector<double> &values : flux)
          if (values[f] != 0 && cell < mesh_->n_owned)
            throw StateError("remap: material would cross the end of the active region at " + describe(*mesh_, cell) +
                             "; regrid first");
      }
  }

  template <int dim>
  void
  VolumeFlux<dim>::compute(const State<dim> &state, const SweepTopology<dim> &topology,
                           const std::vector<double> &swept, RemapSums<dim> &report)
  {
    const std::size_t n_materials = state.material.size();
    flux.resize(n_materials);
    emptied.resize(n_materials);
    for (std::vector<double> &values : flux)
      values.assign(topology.n_faces + 1, 0.);
    for (std::vector<Index> &cells : emptied)
      cells.clear();
    classify(state);

    const FlatFaces<dim> &faces = *topology.faces;
    mixed_faces_.clear();
    for (Index f = 0; f < topology.n_faces; ++f)
      {
        const double moved   = -swept[f];
        const int    side    = moved > 0 ? 0 : 1;
        const Index  giver   = faces.cell[side][f];
        const Index  donor   = giver != none ? giver : faces.cell[1 - side][f];
        const Index  content = content_[donor];
        if (content == empty || (giver == none && faces.side[f] < 0) ||
            !(std::abs(moved) > least_share * state.volume[donor]))
          continue;
        if (content <= first_full)
          {
            const Index m = first_full - content;
            if (std::abs(moved) > least_entry * state.volume[donor] || !begins(state, faces.cell[1 - side][f], m))
              flux[m][f] = moved;
          }
        else
          mixed_faces_.push_back(f);
        if (donor >= mesh_->n_owned)
          continue;
        if (giver != none && !(std::abs(moved) <= state.volume[donor] * topology.part_share[side][f]))
          throw StateError("remap: swept volume " + std::to_string(std::abs(moved) / state.volume[donor]) + " of " +
                           describe(*mesh_, donor) + " exceeds what lies behind the face; step too long");
      }
    cut_donor_boxes(state, topology, swept);
    check_ends(topology);
    limit_donors(state, topology, report);
  }

  template class VolumeFlux<2>;
} // namespace whipple
