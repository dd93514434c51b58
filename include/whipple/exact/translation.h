// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/outline.h>

namespace whipple::exact
{
  /// Bodies in free flight through the vacuum: each keeps its shape, density, energy and velocity V, and is displaced
  /// by V t. Exact if nothing acts on them: no pressure in them, none outside, and they do not meet.
  class Translation : public ExactSolution<2>
  {
  public:
    struct FlyingBody
    {
      Outline   outline;
      Vector<2> velocity{};   ///< cm/us
      double    density  = 0; ///< g/cm^3
      double    pressure = 0; ///< Mbar
      double    energy   = 0; ///< Mbar cm^3/g
    };

    Translation(std::string name, std::vector<FlyingBody> bodies, double start);

    /// Density 0 in the vacuum.
    PointState<2>
    at(const Vector<2> &x, double time) const override;

  private:
    std::vector<FlyingBody> bodies_;
    double                  start_;
  };

  ExactKind
  translation_kind();

  /// All bodies of the scene.
  std::unique_ptr<const ExactSolution<2>>
  make_translation(const ExactRequest<2> &request);
} // namespace whipple::exact
