// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <memory>
#include <string>

namespace whipple
{
  /// A quantity as an expression in the coordinates of a scene: r and z, or x and y, and pi. The text is that of
  /// deal.II's FunctionParser (muParser): + - * / ^, comparisons, &&, ||, `if(a, b, c)`, sin, cos, exp, log, sqrt, abs,
  /// min, max ... What depends on more than the point (random numbers) or hides a slip of the pen (an assignment) is
  /// refused. The same point gives the same bits on every rank.
  class Expression
  {
  public:
    /// @param unit            of its values, in internal units
    /// @param coordinate_unit of the coordinates it is written in, cm
    /// @throws InputError saying what is wrong and what is allowed (without file and key: the caller adds them)
    Expression(const std::string &text, Symmetry symmetry, double unit, double coordinate_unit);

    /// Its value at a point (cm), in internal units; may be infinite or not a number.
    double
    operator()(const Vector<2> &x) const;

  private:
    class Parser;

    std::shared_ptr<const Parser> parser_;
    double                        unit_, coordinate_unit_;
  };
} // namespace whipple
