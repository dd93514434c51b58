// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/run/books_cbor.h>

#include <nlohmann/json.hpp>

// How nlohmann::json reads and writes what the standard library and Whipple have and it does not know. A member that is
// missing here is lost at a restart: the test RunBooks compares the whole.
namespace nlohmann
{
  template <typename T>
  struct adl_serializer<std::optional<T>>
  {
    static void
    to_json(json &j, const std::optional<T> &value)
    {
      j = value ? json(*value) : json(nullptr);
    }
    static void
    from_json(const json &j, std::optional<T> &value)
    {
      value = j.is_null() ? std::nullopt : std::optional<T>(j.get<T>());
    }
  };

  template <>
  struct adl_serializer<whipple::summary::Result>
  {
    static void
    to_json(json &j, const whipple::summary::Result &result)
    {
      if (const double *number = std::get_if<double>(&result))
        j = *number;
      else if (const bool *verdict = std::get_if<bool>(&result))
        j = *verdict;
      else if (const std::string *text = std::get_if<std::string>(&result))
        j = *text;
      else if (const auto *numbers = std::get_if<std::vector<double>>(&result))
        j = *numbers;
      else
        j = nullptr;
    }
    static void
    from_json(const json &j, whipple::summary::Result &result)
    {
      if (j.is_boolean())
        result = j.get<bool>();
      else if (j.is_number())
        result = j.get<double>();
      else if (j.is_string())
        result = j.get<std::string>();
      else if (j.is_array())
        result = j.get<std::vector<double>>();
      else
        result = std::monostate{};
    }
  };

  template <>
  struct adl_serializer<whipple::TimeStepHistory>
  {
    static void
    to_json(json &j, const whipple::TimeStepHistory &history)
    {
      j = history.steps();
    }
    static void
    from_json(const json &j, whipple::TimeStepHistory &history)
    {
      history = whipple::TimeStepHistory(j.get<std::vector<double>>());
    }
  };

  template <>
  struct adl_serializer<whipple::ContactSchedule>
  {
    static void
    to_json(json &j, const whipple::ContactSchedule &schedule)
    {
      j = json::array({schedule.next(), schedule.clear_until()});
    }
    static void
    from_json(const json &j, whipple::ContactSchedule &schedule)
    {
      schedule = whipple::ContactSchedule(j.at(0).get<long>(), j.at(1).get<double>());
    }
  };

  template <>
  struct adl_serializer<whipple::SharedDebris<2>>
  {
    static void
    to_json(json &j, const whipple::SharedDebris<2> &waiting);
    static void
    from_json(const json &j, whipple::SharedDebris<2> &waiting);
  };

  template <>
  struct adl_serializer<whipple::Bookings<2>>
  {
    static void
    to_json(json &j, const whipple::Bookings<2> &bookings);
    static void
    from_json(const json &j, whipple::Bookings<2> &bookings);
  };

  template <>
  struct adl_serializer<whipple::Ledger<2>>
  {
    static void
    to_json(json &j, const whipple::Ledger<2> &ledger);
    static void
    from_json(const json &j, whipple::Ledger<2> &ledger);
  };
} // namespace nlohmann

namespace whipple
{
  namespace summary
  {
    NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Stage, name, mode, start_us, end_us, steps, active_cells_max,
                                       finest_equivalent_cells, elements, dropped_mass_g, wall_s, cpu_s, cell_steps,
                                       cell_steps_per_s_per_rank, dt_limits)
    NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Event, number, size, unit)
    NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Counts, retries, releases, breaks, rezones, warnings, events)
    NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Performance, wall_s, cpu_s, peak_rss_bytes, ranks, active_cell_steps, phases)
    NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Summary, scene, stages, results, counts, performance)
  } // namespace summary

  using Amounts       = ConservedTotals<2>;
  using OneBooking    = Booking<2>;
  using LedgerBooks   = Ledger<2>::Books;
  using LedgerClosure = Ledger<2>::Closure;
  using Books         = RunBooks<2>;
  using Piece         = Element<2>;
  using Part          = Waiting<2>;
  using Debris        = WaitingDebris<2>;

  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Amounts, mass, momentum, internal_energy, kinetic_energy)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Event, number, size, unit)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OneBooking, left, dropped, converted, event)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FieldSeries, grids, shown, stage, time)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ReportProgress, next_fields, next_statistics, fields, statistics_bytes,
                                     table_bytes, events_warned)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StageProgress, begun, next_arrivals, memory_of_end, last_time_step, ceiling,
                                     failed_until, retries, since_regrid, spare_after_regrid, locked, locked_noted,
                                     history, contacts)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Piece, key, position, corner_mass, packet, piece, solid_within)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Part, element, since, centre, reach)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Debris, parts, totals, fastest)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Books, stage, progress, ledger, summary, report, watches, waiting)

  // classes in a class are found by their own namespace only through their members
  namespace
  {
    nlohmann::json
    json_of(const LedgerBooks &books)
    {
      return {{"introduced", books.introduced},
              {"momentum_scale", books.momentum_scale},
              {"left", books.left},
              {"bookings", books.bookings},
              {"energy_seen", books.energy_seen},
              {"last", {books.last.mass, books.last.axial_momentum, books.last.energy}}};
    }

    LedgerBooks
    ledger_books(const nlohmann::json &j)
    {
      LedgerBooks books;
      j.at("introduced").get_to(books.introduced);
      j.at("momentum_scale").get_to(books.momentum_scale);
      j.at("left").get_to(books.left);
      j.at("bookings").get_to(books.bookings);
      j.at("energy_seen").get_to(books.energy_seen);
      books.last = LedgerClosure{j.at("last").at(0), j.at("last").at(1), j.at("last").at(2)};
      return books;
    }
  } // namespace

  std::vector<std::uint8_t>
  to_cbor(const RunBooks<2> &books)
  {
    return nlohmann::json::to_cbor(nlohmann::json(books));
  }

  RunBooks<2>
  books_from_cbor(const std::vector<std::uint8_t> &bytes)
  {
    try
      {
        return nlohmann::json::from_cbor(bytes).get<RunBooks<2>>();
      }
    catch (const nlohmann::json::exception &error)
      {
        throw StateError(std::string("the books of a checkpoint cannot be read: ") + error.what());
      }
  }
} // namespace whipple

namespace nlohmann
{
  void
  adl_serializer<whipple::SharedDebris<2>>::to_json(json &j, const whipple::SharedDebris<2> &waiting)
  {
    j = waiting ? json(*waiting) : json(nullptr);
  }
  void
  adl_serializer<whipple::SharedDebris<2>>::from_json(const json &j, whipple::SharedDebris<2> &waiting)
  {
    waiting =
        j.is_null() ? nullptr : std::make_shared<const whipple::WaitingDebris<2>>(j.get<whipple::WaitingDebris<2>>());
  }
  void
  adl_serializer<whipple::Bookings<2>>::to_json(json &j, const whipple::Bookings<2> &bookings)
  {
    j = bookings.by_cause();
  }
  void
  adl_serializer<whipple::Bookings<2>>::from_json(const json &j, whipple::Bookings<2> &bookings)
  {
    for (const auto &[cause, booking] : j.get<std::map<std::string, whipple::Booking<2>>>())
      bookings.enter(cause, booking);
  }
  void
  adl_serializer<whipple::Ledger<2>>::to_json(json &j, const whipple::Ledger<2> &ledger)
  {
    j = whipple::json_of(ledger.books());
  }
  void
  adl_serializer<whipple::Ledger<2>>::from_json(const json &j, whipple::Ledger<2> &ledger)
  {
    ledger = whipple::Ledger<2>(whipple::ledger_books(j));
  }
} // namespace nlohmann
