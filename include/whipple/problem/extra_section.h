// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/problem/problem.h>
#include <whipple/registry.h>
#include <whipple/scene/section.h>

#include <functional>
#include <string>
#include <utility>

/// Sections of a scene that belong to something which registers itself (a measure): the scene file has them, and the
/// rooms of the scene need not know what they mean.
namespace whipple
{
  /// A section with a key `List` of names, each with its subsection.
  template <int dim>
  struct ExtraSection
  {
    std::string listed; ///< what the names are of, for the key `List`: "gauges"

    /// Declare the entries of one name's subsection.
    std::function<void(SceneSection &subsection)> declare;

    /// Understand the section of a problem that is otherwise complete. Null if it names nothing.
    /// @throws InputError
    std::function<std::shared_ptr<const SectionContent>(SceneParameters &parameters, const Problem<dim> &problem)> read;
  };

  /// All extra sections, by name ("Gauges").
  template <int dim>
  class ExtraSectionRegistry : public Registry<ExtraSectionRegistry<dim>, ExtraSection<dim>>
  {
  };

  /// Makes a section known: one line at the end of its file.
  template <int dim>
  using ExtraSectionRegistration = typename ExtraSectionRegistry<dim>::Registered;
} // namespace whipple
