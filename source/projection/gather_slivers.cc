// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/gather_slivers.h>
#include <whipple/projection/laid_transfer.h>

namespace whipple::projection
{
  namespace
  {
    /// A neighbour that takes a sliver has this part of its volume free: more than eight slivers.
    constexpr double least_room = 0.01;
    /// A row of slivers hands on one cell a round.
    constexpr int most_rounds = 100;

    /// Who takes a cell's sliver; `none` if it stays.
    Index
    taker(const FlatMesh<2> &mesh, const State<2> &state, const std::vector<double> &solid, Index cell)
    {
      double most = solid[cell];
      Index  best = none;
      for (const Index n : face_neighbours(mesh, cell))
        if (n != none && solid[n] > most && solid[n] < (1. - least_room) * state.volume[n])
          {
            most = solid[n];
            best = n;
          }
      return best;
    }
  } // namespace

  Event
  gather_slivers(MPI_Comm communicator, const FlatMesh<2> &mesh, const Halo<2> &halo, const State<2> &state,
                 double share, Laid &laid)
  {
    Event               joined{0, 0, "g"};
    LaidTransfer        transfer(mesh, halo, laid);
    std::vector<double> solid(mesh.n_cells);
    std::vector<Index>  to(mesh.n_cells);
    for (int round = 0; round < most_rounds; ++round)
      {
        for (Index c = 0; c < mesh.n_cells; ++c)
          solid[c] = solid_volume(state.material, c) + solid_volume(laid.material, c);
        std::array<double, 2> given{};
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            const bool sliver = solid[c] > 0 && solid[c] < share * state.volume[c] && laid.motion[c].mass > 0 &&
                                solid_volume(state.material, c) == 0;
            to[c] = sliver ? taker(mesh, state, solid, c) : none;
            if (to[c] != none && c < mesh.n_owned)
              {
                given[0] += 1;
                given[1] += laid.motion[c].mass;
              }
          }
        MPI_Allreduce(MPI_IN_PLACE, given.data(), 2, MPI_DOUBLE, MPI_SUM, communicator);
        if (given[0] == 0)
          break;
        joined.number += given[0];
        joined.size += given[1];
        transfer.begin();
        for (Index c = 0; c < mesh.n_cells; ++c)
          if (to[c] != none)
            transfer.keep(c, 0.);
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            Index last = none; // a coarse giver shows at two subfaces, one after the other
            for (const Index giver : face_neighbours(mesh, c))
              if (giver != none && giver != last && to[giver] == c)
                {
                  transfer.take(giver, 1., c);
                  last = giver;
                }
          }
        transfer.exchange();
      }
    return joined;
  }
} // namespace whipple::projection
