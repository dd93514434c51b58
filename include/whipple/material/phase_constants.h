// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>

namespace whipple
{
  /// Melting and boiling points of the library's materials and the heats that go with them ("Melting point", "Heat of
  /// fusion", "Boiling point", "Heat of vaporisation"), with Steinberg's a of the melting law ("Grueneisen volume
  /// correction").
  std::vector<PublishedConstants>
  phase_constants();
} // namespace whipple
