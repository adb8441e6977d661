#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/windows/windows.h"
#include "data/store/decision.h"

namespace slackwater::api {

/// Whether the limits of a task held from a start to the end of its work.
enum class Came {
  held,
  did_not_hold,
  not_known_yet,    ///< what was analysed or measured does not reach so far yet
  cannot_be_known,  ///< the record or the store lacks something that will not come
};
/// "held", "did_not_hold", "not_known_yet", "cannot_be_known".
[[nodiscard]] std::string_view name_of(Came came) noexcept;
[[nodiscard]] constexpr bool is_known(Came came) noexcept {
  return came == Came::held || came == Came::did_not_hold;
}

/// What came of a start.
struct WhatCame {
  Came came = Came::not_known_yet;
  std::string broken;                    ///< the limit, or the closed area, that was met first
  std::optional<UtcTime> broken_at;      ///< of the limit
  std::string why;                       ///< nothing is known; else empty
  std::vector<std::string> not_checked;  ///< limits that nobody knows anything of
};

struct DecisionAnswer {
  store::DecisionRow row;
  bool counts = true;    ///< no later record is of the same task, turbine and start
  bool is_late = false;  ///< recorded after its start
  WhatCame what;
};

/// What came of the decisions that count, and were recorded by the time that is asked about.
struct DecisionsRecord {
  std::size_t goes_known = 0;  ///< goes of which it is known what came
  std::size_t goes_held = 0;   ///< of these
  std::size_t goes_open = 0;   ///< of which it is not known, yet or ever
  /// Days, each task's by itself, on which there was a no-go and no go, though the limits held from
  /// the start of one such no-go to the end of the work.
  std::size_t days_lost = 0;
  std::size_t days_open = 0;  ///< such days of which that is not known
  std::size_t tasks = 0;      ///< that anything was decided about
};

struct DecisionsQuestion {
  WindowsQuestion windows;      ///< of the site, with nothing else asked; its `site` names it
  std::string task;             ///< empty: all
  std::optional<UtcTime> from;  ///< of the starts
  UtcTime known_by;             ///< what came is what the store knows of by then
};

struct DecisionsAnswer {
  std::string site_id;
  std::string site_name;
  std::optional<TimeZone> zone;  ///< of the site's clocks
  UtcTime known_by;
  std::vector<DecisionAnswer> decisions;  ///< in order of (start, filing)
  DecisionsRecord record;
};

/// The decisions of a site, each beside what came: the sea and the wind as they came
/// (`what_came_of` the forecast that it rests on), asked as `windows_of` asks a forecast, by the
/// task's sheet as it is now. Cost: of a decision that of `windows_of` in one future; of forty days
/// of them that of reading these days once.
/// @throws Error(not_found) for a site or a store that there is not
[[nodiscard]] DecisionsAnswer decisions_of(const DecisionsQuestion& question,
                                           const std::filesystem::path& store_folder);

/// Counts, by what came; records after `known_by` count for nothing.
[[nodiscard]] DecisionsRecord record_of(const std::vector<DecisionAnswer>& decisions,
                                        UtcTime known_by);

}  // namespace slackwater::api
