#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "api/ask/run/scenario_at_hand.h"
#include "api/door/people/token_book.h"

namespace slackwater::sessions {

/// A session that may be begun.
struct Offer {
  std::string id;    ///< letters, digits and '-'
  std::string name;  ///< of its scenario, when the operator's file was read
  std::filesystem::path file;
  bool is_mission = false;      ///< the file is a mission, else a scenario
  double real_time_factor = 1;  ///< 0: as fast as it goes
  bool begins_at_start = false;
};

/// What an operator lets people begin, and who they are:
///
///     sessions:
///       - id: night-cp
///         scenario: scenarios/night_cp.yaml   # or mission: missions/night_cp.yaml
///         real_time_factor: 1
///         begins: by_supervisor               # or at_start
///     most_at_once: 4
///     logs: logs/
///     people: [...]                           # api/door/people/token_book.h
///
/// Files and folders count from its own folder.
struct OperatorFile {
  std::vector<Offer> offers;
  std::size_t most_at_once = 4;
  std::filesystem::path logs;  ///< a folder; empty: runs leave no log
  people::TokenBook people;
};

/// Reads it, and the scenarios and missions it names: what could not be begun is refused here.
/// Forecasts are not looked for: the one that a run needs may be issued later.
/// @param store_folder  whose sites missions name
/// @throws Error(invalid_input) with file and line, Error(not_found)
[[nodiscard]] OperatorFile read_operator_file(const std::filesystem::path& file,
                                              const std::filesystem::path& store_folder);

/// Reads an offer's scenario or mission, as it is now, and finds its water.
/// @throws Error(invalid_input), Error(not_found), Error(unavailable)
[[nodiscard]] api::ScenarioAtHand at_hand(const Offer& offer,
                                          const std::filesystem::path& store_folder);

}  // namespace slackwater::sessions
