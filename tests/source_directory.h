// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

/// The folder with the sources, scenes and scripts. Only main.cc knows the path: no other object depends on where the
/// checkout stands.
std::string
source_directory();
