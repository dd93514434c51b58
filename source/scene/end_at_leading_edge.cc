// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/stage_end.h>

#include <algorithm>
#include <limits>

namespace whipple
{
  namespace
  {
    /// When the foremost material along axis 1 has come to the front face of a body that enters later.
    class EndAtLeadingEdge : public StageEnd
    {
    public:
      EndAtLeadingEdge(std::size_t body, std::string name, double face)
        : body_(body)
        , name_(std::move(name))
        , face_(face)
      {
      }
      double
      expected(const StageOutlook &outlook) const override
      {
        if (!(outlook.fastest > 0))
          return std::numeric_limits<double>::infinity();
        return std::max(outlook.start, (face_ - outlook.front) / outlook.fastest);
      }
      std::optional<std::size_t>
      awaited_body() const override
      {
        return body_;
      }
      Left
      time_left(const StageView &stage, std::vector<double> &) const override
      {
        // time until the fastest corner could bridge the gap; a hundredth of a cell short of the plate is there
        const double gap = face_ - stage.foremost(), fastest = stage.fastest();
        if (gap <= 0.01 * stage.finest_cell())
          return {0., stage.time()};
        if (fastest <= 0)
          return {0., stage.time(), "nothing moves on towards '" + name_ + "'"};
        return {std::max(gap, 0.1 * stage.finest_cell()) / fastest, stage.time() + gap / fastest};
      }

    private:
      std::size_t body_;
      std::string name_;
      double      face_; ///< cm
    };

    const StageEndRegistration registration("until leading edge reaches",
                                            {"'until leading edge reaches BODY'",
                                             "when the foremost material has come to the front face of that body",
                                             [](const StageEndInput &input) {
                                               const std::size_t body = input.body(input.rest);
                                               return std::make_shared<EndAtLeadingEdge>(body, input.bodies[body],
                                                                                         input.fronts[body]);
                                             }});
  } // namespace
} // namespace whipple
