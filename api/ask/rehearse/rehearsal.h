#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "twin/rehearse/by_the_limits.h"
#include "twin/rehearse/flight.h"

namespace slackwater::api {

/// How a mission is rehearsed.
struct RehearsalPlan {
  std::vector<UtcTime> starts;
  std::size_t members = 24;  ///< at most, of each start
  double narrow_enough = 0;  ///< width of the interval at which a start needs no more; 0: all
  double level = 0.95;       ///< of the interval
  double most_wall_s = 0;    ///< of the clock: no round begins after that; 0: however long it takes
  int threads = 1;
  twin::FlightSettings flights;
  /// Why a start may not be flown at all; empty: it may.
  std::function<std::string(UtcTime start)> forbidden{};
};

/// Why flights were not done, and how many.
struct StoppedBy {
  std::string cause;
  std::size_t flights = 0;
};

/// Of how many flights something is true, with the bounds of its probability.
struct FlightCount {
  std::size_t flights = 0;
  std::size_t of = 0;        ///< that were flown
  double low = 0, high = 1;  ///< whenever the flights were stopped

  [[nodiscard]] double share() const noexcept {
    return of == 0 ? 0 : static_cast<double>(flights) / static_cast<double>(of);
  }
};

struct StartOutcome {
  UtcTime start;
  std::vector<twin::Flight> flights;  ///< by member
  FlightCount done;                   ///< P(done): the work was done in time and all came home
  std::optional<FlightCount> seen;    ///< P(seen): what is asked was covered; nothing: none is
  FlightCount success;                ///< both; where nothing is asked, done
  bool is_narrow = false;             ///< it was flown no more because the bounds are narrow enough
  twin::LimitsSay by_the_limits;
  std::string forbidden;              ///< why it was not flown at all; empty: it was
  std::vector<StoppedBy> stopped_by;  ///< of those not done, most frequent first
  std::vector<StoppedBy> unseen_by;   ///< of those that saw too little, most frequent first
};

struct Rehearsal {
  std::vector<StartOutcome> starts;
  twin::InspectionShelf inspections;  ///< of the vehicles that inspect: the same in all flights

  /// The start that a coordinator looks at first: the first of those with most successes.
  [[nodiscard]] std::size_t best() const noexcept;
  double wall_s = 0;
  double first_answer_s = 0;  ///< of the clock: until every start had been flown once
};

/// Flies a mission from each start in each member, members side by side and starts in turn, so that
/// there is a first answer for all starts early. Nothing of it depends on the number of threads,
/// unless the clock ends it.
///
/// The interval holds at its level whenever the flights are stopped (`success_interval`).
/// @param on_progress  share of all flights, and the outcome so far after each round
/// @throws Error(invalid_input) as `set_up`, also for a start outside the forecast
[[nodiscard]] Rehearsal rehearse(
    const twin::Scenario& mission, twin::Surround surround, const RehearsalPlan& plan,
    const std::function<void(double share, const Rehearsal& so_far)>& on_progress = {});

}  // namespace slackwater::api
