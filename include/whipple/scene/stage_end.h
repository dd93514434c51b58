// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/registry.h>
#include <whipple/scene/units.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// When a stage is over. Each way to say it is a class that registers itself, in a file of its own (doc/extending.md).
namespace whipple
{
  /// What can be told of a stage before the run.
  struct StageOutlook
  {
    double start   = 0; ///< us
    double front   = 0; ///< foremost point of the fastest body at the start of the run, cm
    double fastest = 0; ///< velocity of that body along the line of flight, cm/us
  };

  /// What a stage end may ask of a running stage. Every question is collective.
  class StageView
  {
  public:
    virtual ~StageView() = default;

    virtual double
    time() const = 0; ///< us
    virtual double
    start() const = 0; ///< of the stage, us
    virtual double
    finest_cell() const = 0; ///< cm
    /// Foremost corner of material along the line of flight, cm.
    virtual double
    foremost() const = 0;
    /// Largest velocity of a node along the line of flight, cm/us.
    virtual double
    fastest() const = 0;
    struct Debris
    {
      double mass     = 0; ///< g
      double momentum = 0; ///< along the line of flight, g cm/us

      double kinetic_energy = 0; ///< Mbar cm^3
    };
    /// Material beyond a plane across the line of flight [cm] that is faster along it than `velocity` [cm/us].
    virtual Debris
    beyond(double plane, double velocity) const = 0;
    /// Momentum along axis 1 of debris that is faster along it than `velocity`, has not been laid down yet and will
    /// arrive, g cm/us. beyond() counts it, too.
    virtual double
    coming(double velocity) const = 0;
    /// What there is to watch, by name: kinetic energy of each body, and of each plate its hole, its crater (what is
    /// gone of its thickness) and its dent (the depth of that below the undisturbed front, dishing included) ... (cm,
    /// g, us, Mbar)
    virtual std::map<std::string, double>
    watched() const = 0;
  };

  /// Share of the momentum along axis 1 that may still be coming when a stage ends.
  inline constexpr double share_still_coming = 0.01;

  /// Velocity along the line of flight from which on something is debris that counts, as a share of the fastest.
  inline constexpr double debris_share = 0.1;

  /// One way for a stage to end.
  class StageEnd
  {
  public:
    virtual ~StageEnd() = default;

    /// Time at which the stage will end as far as it can be told, us; infinity if it will not.
    virtual double
    expected(const StageOutlook &outlook) const = 0;

    /// Whether expected() will be the time.
    virtual bool
    is_known() const
    {
      return false;
    }

    /// The time itself, if it does not depend on when the stage starts, us.
    virtual std::optional<double>
    fixed_time() const
    {
      return std::nullopt;
    }

    /// Body that the stage waits for: a later stage must introduce it.
    virtual std::optional<std::size_t>
    awaited_body() const
    {
      return std::nullopt;
    }

    struct Left
    {
      double time; ///< us; the largest step that may still be made. 0: the stage is over
      double end;  ///< us; when it will be, estimated
      /// Why later stages would have nothing to do, if so; then the time is 0, and the run is complete with this stage.
      std::optional<std::string> chain_over = std::nullopt;
    };

    /// Asked before every step. @param memory of this stage, empty at its start; part of the run state
    /// @throws StateError if the end cannot come
    virtual Left
    time_left(const StageView &stage, std::vector<double> &memory) const = 0;
  };

  /// What a scene says after the words that name a stage end, and what it needs to be understood.
  struct StageEndInput
  {
    std::string              rest;              ///< the text after the phrase
    std::vector<std::string> bodies;            ///< names
    std::vector<double>      fronts;            ///< lower face of each along the line of flight, cm
    std::vector<double>      rears;             ///< upper face, cm
    double                   largest_speed = 0; ///< of the bodies, cm/us

    /// Velocity along the line of flight from which on something is debris that counts, cm/us.
    double
    debris_velocity() const
    {
      return debris_share * largest_speed;
    }

    /// A part of the text as a value in internal units. Throws InputError that names file, key and value.
    std::function<double(const std::string &text, const units::Quantity &quantity)> value;
    /// A part of the text as an index into bodies. Throws InputError likewise.
    std::function<std::size_t(const std::string &text)> body;
    /// Throws InputError: what is allowed.
    std::function<void(const std::string &allowed)> reject;
  };

  /// A stage end as scenes know it.
  struct StageEndKind
  {
    std::string                                                           usage; ///< "for TIME"
    std::string                                                           help;  ///< one line
    std::function<std::shared_ptr<const StageEnd>(const StageEndInput &)> make;
  };

  /// All stage ends there are, by the phrase they begin with; the empty one is taken for what no other fits.
  class StageEndRegistry : public Registry<StageEndRegistry, StageEndKind>
  {
  public:
    /// Understand what a scene says. @param input with the whole text as its rest
    /// @throws InputError
    static std::shared_ptr<const StageEnd>
    read(StageEndInput input);

    /// "a time such as '1.5 us' | 'for TIME' | ..."
    static std::string
    usage();
  };

  /// Makes a stage end known: one line at the end of its file.
  using StageEndRegistration = StageEndRegistry::Registered;

  /// The end "until holes have settled": no hole or crater has grown by more than 2 % in the last third of the time.
  /// @param latest us since the start of the stage
  std::shared_ptr<const StageEnd>
  until_holes_have_settled(double latest);
} // namespace whipple
