// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/compaction_loading.h>
#include <whipple/exact/piston.h>
#include <whipple/exact/porous_piston.h>
#include <whipple/exact/solid_request.h>

namespace whipple::exact
{
  ExactKind
  porous_piston_kind()
  {
    return {
        "p-alpha piston",
        "a side of axis 1 with 'inflow' drives an elastic precursor and a compaction shock into the one body of the "
        "scene, porous, with the void law 'p-alpha' and without strength",
        {}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_porous_piston(const ExactRequest<2> &request)
  {
    const BodyState<2> &body = only_fluid(request);
    const auto         *law  = dynamic_cast<const PAlphaVoidLaw *>(body.material.void_law.get());
    if (!law)
      throw InputError("exact solution '" + request.name + "': body '" + body.name +
                       "' must have the void law 'p-alpha', and the effect 'voids' on");
    const CompactionLoading loading(body.material.eos, law->constants(), body.density, body.energy);
    return std::make_unique<ProfileSolution<2>>(request.name,
                                                std::make_unique<Piston>(loading, piston_of_scene(request, body)),
                                                Geometry::planar, request.symmetry, request.start);
  }
} // namespace whipple::exact
