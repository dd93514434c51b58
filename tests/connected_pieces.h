// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <queue>
#include <vector>

namespace whipple
{
  /// Number of pieces in which the cells that hold more than a fraction of material 0 hang together across faces.
  inline int
  connected_pieces(const FlatMesh<2> &mesh, const State<2> &state, double fraction)
  {
    std::vector<bool> seen(mesh.n_cells, false);
    const auto holds = [&](Index c) { return c != none && state.material[0].volume[c] > fraction * state.volume[c]; };
    int        count = 0;
    for (Index start = 0; start < mesh.n_cells; ++start)
      if (holds(start) && !seen[start])
        {
          ++count;
          std::queue<Index> queue({start});
          seen[start] = true;
          for (; !queue.empty(); queue.pop())
            for (int side = 0; side < 4; ++side)
              for (int s = 0; s < 2; ++s)
                if (const Index f = mesh.cell_face[side][2 * queue.front() + s]; f != none)
                  if (const Index c = mesh.faces[side / 2].cell[side & 1][f]; holds(c) && !seen[c])
                    {
                      seen[c] = true;
                      queue.push(c);
                    }
        }
    return count;
  }
} // namespace whipple
