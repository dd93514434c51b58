// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/laid_transfer.h>
#include <whipple/projection/spread_excess.h>
#include <whipple/state/exact_sum.h>

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

namespace whipple::projection
{
  namespace
  {
    constexpr double unreachable = std::numeric_limits<double>::infinity();

    /// A cell counts as a place to go to when this part of it is free.
    constexpr double worthwhile_room = 1e-3;
    /// Steps of way that a cell stands for which was full of something else before.
    constexpr double way_through_full = 64;
    /// Rounds after which something must be wrong: overlaps are some cells deep, rounds grow like the depth squared.
    constexpr int most_rounds = 20000;

    /// The pores of what was laid down in a cell give way; returns their volume.
    double
    press_out_pores(std::vector<MaterialState> &materials, Index cell)
    {
      double pores = 0;
      for (MaterialState &material : materials)
        if (material.has_voids() && material.volume[cell] > 0)
          {
            const double phi = material.void_fraction[cell];
            pores += phi * material.volume[cell];
            material.volume[cell] *= 1. - phi;
            material.density[cell] /= 1. - phi;
            material.void_fraction[cell] = 0;
          }
      return pores;
    }

    class Spread
    {
    public:
      Spread(MPI_Comm communicator, const FlatMesh<2> &mesh, const Halo<2> &halo, const State<2> &state,
             std::span<const std::uint8_t> closed, Laid &laid)
        : communicator_(communicator)
        , mesh_(mesh)
        , halo_(halo)
        , state_(state)
        , closed_(closed)
        , laid_(laid)
        , transfer_(mesh, halo, laid)
        , held_(mesh.n_cells)
        , excess_(mesh.n_cells)
        , room_(mesh.n_cells)
        , way_(mesh.n_cells)
        , share_(mesh.n_cells)
      {
        for (Index c = 0; c < mesh.n_cells; ++c)
          held_[c] = solid_volume(state.material, c);
      }

      SpreadReport
      run()
      {
        SpreadReport          report;
        std::array<double, 2> found = weigh();
        if (found[0] == 0)
          return report;
        report.moved.number = found[0];
        report.moved.size   = found[1];
        report.depth        = depth();
        ExactSum pores;
        for (; found[0] > 0; found = weigh())
          {
            if (++report.rounds > most_rounds)
              refuse(found, "still after " + std::to_string(most_rounds) + " rounds of spreading");
            for (Index c = 0; c < mesh_.n_cells; ++c)
              if (excess_[c] > 0)
                {
                  const double pressed = press_out_pores(laid_.material, c);
                  if (c < mesh_.n_owned)
                    pores.add(pressed);
                }
            find_ways(found);
            hand_over();
            transfer_.exchange();
          }
        ExactSum::reduce({&pores, 1}, communicator_);
        report.pores_squeezed = pores.value();
        return report;
      }

    private:
      /// Excess and room of every cell; returns the number of overfull cells and the volume of excess, all ranks.
      std::array<double, 2>
      weigh()
      {
        double   overfull = 0;
        ExactSum excess;
        for (Index c = 0; c < mesh_.n_cells; ++c)
          {
            const double volume = state_.volume[c], over = held_[c] + solid_volume(laid_.material, c) - volume;
            // what was there is no one's to move: a painted cell is full to round-off
            excess_[c] = over > excess_tolerance * volume && laid_.motion[c].mass > 0 ? over : 0.;
            room_[c]   = over < 0 && (closed_.empty() || !closed_[c]) ? -over : 0.;
            if (c < mesh_.n_owned && excess_[c] > 0)
              {
                overfull += 1;
                excess.add(excess_[c]);
              }
          }
        MPI_Allreduce(MPI_IN_PLACE, &overfull, 1, MPI_DOUBLE, MPI_SUM, communicator_);
        ExactSum::reduce({&excess, 1}, communicator_);
        return {overfull, excess.value()};
      }

      double
      depth() const
      {
        double deepest = 0;
        for (Index c = 0; c < mesh_.n_owned; ++c)
          if (excess_[c] > 0)
            deepest = std::max(deepest, 1. + excess_[c] / state_.volume[c]);
        MPI_Allreduce(MPI_IN_PLACE, &deepest, 1, MPI_DOUBLE, MPI_MAX, communicator_);
        return deepest;
      }

      bool
      is_place(Index c) const
      {
        return room_[c] > worthwhile_room * state_.volume[c];
      }

      /// Way from a neighbour's far side: to it, and on from there.
      double
      way_over(Index neighbour) const
      {
        const bool full_before = held_[neighbour] > 0.5 * state_.volume[neighbour] && !is_place(neighbour);
        return way_[neighbour] + (full_before ? way_through_full : 1.);
      }

      /// Shortest way from every cell to one with room, over faces: whole numbers, so the same on all ranks.
      void
      find_ways(const std::array<double, 2> &found)
      {
        for (Index c = 0; c < mesh_.n_cells; ++c)
          way_[c] = is_place(c) ? 0. : unreachable;
        for (int changed = 1; changed;)
          {
            changed = 0;
            for (Index c = 0; c < mesh_.n_cells; ++c)
              {
                if (way_[c] == 0)
                  continue;
                double best = way_[c];
                for (const Index n : face_neighbours(mesh_, c))
                  if (n != none)
                    best = std::min(best, way_over(n));
                changed = changed || best < way_[c];
                way_[c] = best;
              }
            halo_.exchange(std::vector<std::vector<double> *>{&way_}, {});
            MPI_Allreduce(MPI_IN_PLACE, &changed, 1, MPI_INT, MPI_MAX, communicator_);
          }
        int stuck = 0;
        for (Index c = 0; c < mesh_.n_owned; ++c)
          stuck = stuck || (excess_[c] > 0 && way_[c] == unreachable);
        MPI_Allreduce(MPI_IN_PLACE, &stuck, 1, MPI_INT, MPI_MAX, communicator_);
        if (stuck)
          refuse(found, "and no cell around has room");
      }

      /// Part of a cell's excess that each neighbour gets; they add up to 1.
      std::array<double, 8>
      parts(const std::array<Index, 8> &around) const
      {
        std::array<double, 8> part{};
        double                sum = 0, best = unreachable;
        for (int i = 0; i < 8; ++i)
          if (around[i] != none)
            {
              part[i] = is_place(around[i]) ? room_[around[i]] : 0.;
              sum += part[i];
              best = std::min(best, way_over(around[i]));
            }
        if (sum == 0)
          for (int i = 0; i < 8; ++i)
            if (around[i] != none && way_over(around[i]) == best)
              {
                part[i] = 1.;
                sum += 1.;
              }
        for (double &p : part)
          p = sum > 0 ? p / sum : 0.; // a cell at the end of the halo may not see its neighbours
        return part;
      }

      /// One round. Every cell takes what its neighbours give up, in the order of its sides, so that sums do not depend
      /// on the partition.
      void
      hand_over()
      {
        transfer_.begin();
        const Laid &before = transfer_.before();
        for (Index c = 0; c < mesh_.n_cells; ++c)
          share_[c] = excess_[c] > 0 ? std::min(1., excess_[c] / solid_volume(before.material, c)) : 0.;
        for (Index c = 0; c < mesh_.n_cells; ++c)
          if (share_[c] > 0)
            transfer_.keep(c, 1. - share_[c]);
        for (Index c = 0; c < mesh_.n_cells; ++c)
          {
            const std::array<Index, 8> around = face_neighbours(mesh_, c);
            for (int i = 0; i < 8; ++i)
              {
                const Index giver = around[i];
                if (giver == none || share_[giver] == 0)
                  continue;
                const auto givers_around = face_neighbours(mesh_, giver);
                const auto part          = parts(givers_around);
                double     given         = 0;
                for (int j = 0; j < 8; ++j)
                  if (givers_around[j] == c && j / 2 == (i / 2 ^ 1))
                    given += part[j];
                if (given > 0)
                  transfer_.take(giver, given * share_[giver], c);
              }
          }
      }

      [[noreturn]] void
      refuse(const std::array<double, 2> &found, const std::string &why) const
      {
        std::ostringstream text;
        text << "projection onto cells: pieces overlap, " << found[1] << " cm^3 of solid in " << found[0]
             << " cells do not fit, " << why;
        throw NoRoomError(text.str());
      }

      MPI_Comm                      communicator_;
      const FlatMesh<2>            &mesh_;
      const Halo<2>                &halo_;
      const State<2>               &state_;
      std::span<const std::uint8_t> closed_;
      Laid                         &laid_;
      LaidTransfer                  transfer_;
      std::vector<double>           held_;   ///< solid that was there before, cm^3
      std::vector<double>           excess_; ///< solid beyond the cell's volume, cm^3
      std::vector<double>           room_;   ///< volume that is not solid, cm^3
      std::vector<double>           way_;    ///< cells from here to one with room
      std::vector<double>           share_;  ///< of what was laid down, given up in this round
    };
  } // namespace

  SpreadReport
  spread_excess(MPI_Comm communicator, const FlatMesh<2> &mesh, const Halo<2> &halo, const State<2> &state,
                std::span<const std::uint8_t> closed, Laid &laid)
  {
    return Spread(communicator, mesh, halo, state, closed, laid).run();
  }
} // namespace whipple::projection
