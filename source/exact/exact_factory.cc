// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/blake.h>
#include <whipple/exact/coggeshall.h>
#include <whipple/exact/entropy_wave.h>
#include <whipple/exact/exact_factory.h>
#include <whipple/exact/gas_piston.h>
#include <whipple/exact/guderley.h>
#include <whipple/exact/isentropic_vortex.h>
#include <whipple/exact/noh.h>
#include <whipple/exact/piston.h>
#include <whipple/exact/plate_impact.h>
#include <whipple/exact/porous_piston.h>
#include <whipple/exact/riemann.h>
#include <whipple/exact/rotation.h>
#include <whipple/exact/sedov.h>
#include <whipple/exact/sound_wave.h>
#include <whipple/exact/spall.h>
#include <whipple/exact/translation.h>
#include <whipple/exact/void_rate.h>

namespace whipple::exact
{
  namespace
  {
    struct Registration
    {
      ExactKind (*kind)();
      std::unique_ptr<const ExactSolution<2>> (*make)(const ExactRequest<2> &);
    };

    /// All solutions, a line each, in the order of help and manual.
    constexpr Registration registry[] = {
        {riemann_kind, make_riemann},
        {gas_piston_kind, make_gas_piston},
        {noh_kind, make_noh},
        {sedov_kind, make_sedov},
        {guderley_kind, make_guderley},
        {coggeshall_1_kind, make_coggeshall_1},
        {coggeshall_8_kind, make_coggeshall_8},
        {piston_kind, make_piston},
        {porous_piston_kind, make_porous_piston},
        {plate_impact_kind, make_plate_impact},
        {blake_kind, make_blake},
        {spall_kind, make_spall},
        {void_relaxation_kind, make_void_relaxation},
        {translation_kind, make_translation},
        {rotation_kind, make_rotation},
        {isentropic_vortex_kind, make_isentropic_vortex},
        {entropy_wave_kind, make_entropy_wave},
        {sound_wave_kind, make_sound_wave},
    };
  } // namespace

  template <>
  std::vector<ExactKind>
  exact_kinds<2>()
  {
    std::vector<ExactKind> kinds;
    for (const Registration &row : registry)
      kinds.push_back(row.kind());
    return kinds;
  }

  template <>
  std::unique_ptr<const ExactSolution<2>>
  make_exact_solution<2>(const ExactRequest<2> &request)
  {
    std::string names;
    for (const Registration &row : registry)
      {
        const std::string name = row.kind().name;
        if (name == request.name)
          return row.make(request);
        names += (names.empty() ? "" : " | ") + name;
      }
    throw InputError("exact solution '" + request.name + "': must be " + names);
  }
} // namespace whipple::exact
