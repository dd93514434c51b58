// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/laid_transfer.h>

namespace whipple::projection
{
  namespace
  {
    template <typename Visit>
    void
    for_each_moment(Motion &motion, Visit visit)
    {
      int i = 0;
      visit(i++, motion.mass);
      visit(i++, motion.kinetic);
      for (int a = 0; a < 2; ++a)
        {
          visit(i++, motion.mean_x[a]);
          visit(i++, motion.mean_u[a]);
          for (int b = 0; b < 2; ++b)
            {
              visit(i++, motion.xx[a][b]);
              visit(i++, motion.ux[a][b]);
            }
        }
    }
  } // namespace

  double
  solid_volume(const std::vector<MaterialState> &materials, Index cell)
  {
    double solid = 0;
    for (const MaterialState &material : materials)
      solid += material.volume[cell] * (material.has_voids() ? 1. - material.void_fraction[cell] : 1.);
    return solid;
  }

  std::array<Index, 8>
  face_neighbours(const FlatMesh<2> &mesh, Index cell)
  {
    std::array<Index, 8> result;
    for (int side = 0; side < 4; ++side)
      for (int s = 0; s < 2; ++s)
        {
          const Index face     = mesh.cell_face[side].empty() ? none : mesh.cell_face[side][2 * cell + s];
          result[2 * side + s] = face == none ? none : mesh.faces[side / 2].cell[side % 2][face];
        }
    return result;
  }

  LaidTransfer::LaidTransfer(const FlatMesh<2> &mesh, const Halo<2> &halo, Laid &laid)
    : mesh_(mesh)
    , halo_(halo)
    , laid_(laid)
  {
  }

  void
  LaidTransfer::keep(Index cell, double rest)
  {
    for (MaterialState &material : laid_.material)
      {
        material.volume[cell] *= rest;
        material.mass[cell] *= rest;
        if (rest > 0)
          continue;
        material.density[cell] = material.energy[cell] = 0;
        if (material.has_voids())
          material.void_fraction[cell] = 0;
        for (Field &field : material.fields)
          field.value[cell] = 0;
      }
    Motion &motion = laid_.motion[cell];
    if (rest == 0)
      {
        motion = {};
        return;
      }
    motion.mass *= rest;
    motion.kinetic *= rest;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        {
          motion.xx[a][b] *= rest;
          motion.ux[a][b] *= rest;
        }
  }

  void
  LaidTransfer::take(Index giver, double share, Index cell)
  {
    const Motion &source = before_.motion[giver];
    Motion        part;
    part.mass    = share * source.mass;
    part.mean_u  = source.mean_u;
    part.kinetic = share * source.kinetic;
    for (int d = 0; d < 2; ++d)
      {
        part.mean_x[d] = mesh_.lower[d][cell] + 0.5 * mesh_.size[cell];
        part.xx[d][d]  = part.mass * mesh_.size[cell] * mesh_.size[cell] / 12.;
      }
    laid_.motion[cell].add(part);
    for (std::size_t m = 0; m < laid_.material.size(); ++m)
      add_part(before_.material[m], giver, share, laid_.material[m], cell);
  }

  void
  LaidTransfer::exchange()
  {
    std::vector<std::vector<double> *> arrays;
    for (MaterialState &m : laid_.material)
      {
        for (auto *array : {&m.volume, &m.mass, &m.density, &m.energy})
          arrays.push_back(array);
        if (m.has_voids())
          arrays.push_back(&m.void_fraction);
        for (Field &field : m.fields)
          arrays.push_back(&field.value);
      }
    std::array<std::vector<double>, 14> moments;
    for (auto &array : moments)
      {
        array.resize(mesh_.n_cells);
        arrays.push_back(&array);
      }
    for (Index c = 0; c < mesh_.n_cells; ++c)
      for_each_moment(laid_.motion[c], [&](int i, double &value) { moments[i][c] = value; });
    halo_.exchange(arrays, {});
    for (Index c = mesh_.n_owned; c < mesh_.n_cells; ++c)
      for_each_moment(laid_.motion[c], [&](int i, double &value) { value = moments[i][c]; });
  }
} // namespace whipple::projection
