#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "api/ask/windows/windows.h"
#include "data/store/decision.h"

namespace slackwater::api {

/// What somebody decided, to be recorded.
struct DecideQuestion {
  WindowsQuestion windows;  ///< of its site, with nothing else asked; its `site` names it
  std::string task;         ///< id of data/tasks, or the path of a sheet
  std::string turbine;      ///< empty: the first that the task can be done at
  UtcTime start;
  store::Decided decided = store::Decided::no_go;
  std::string by;         ///< the name of who decided
  std::string note;       ///< why
  std::string hand_over;  ///< for the next shift
  UtcTime recorded_at;
  bool by_clock = true;      ///< `recorded_at` was read, not stated
  std::string before_names;  ///< of a word, in errors: "--" of "--by"
};

/// A decision ready to be filed, and what there is to say beside it.
struct DecisionMade {
  store::DecisionRow row;  ///< its id is 0 until it is filed
  bool is_late = false;    ///< recorded after its start
  /// The record of the same task, turbine and start that counted until now; it stays.
  std::optional<store::DecisionRow> before;
};

/// The decision as it is recorded: with the latest forecast that had been issued by then and before
/// the start, and what `windows_of` says of that start on it. A start need not lie on the half
/// hours that `windows` asks about; where the program can say nothing of it, the record says why.
/// @throws Error(usage) for a name, a note or a hand-over that is blank, too long or no plain line
///         of text, and a start that is no whole minute; Error(not_found) for sites, tasks and
///         turbines that there are not, and where no forecast had been issued that covers the start
[[nodiscard]] DecisionMade decision_made(const DecideQuestion& question,
                                         const std::filesystem::path& store_folder);

/// Files it, in the store for good; from then on its row has its id.
void file_decision(DecisionMade& made, const std::filesystem::path& store_folder);

/// The name of a task under which it is found again from anywhere: its id, or the whole path of its
/// sheet.
[[nodiscard]] std::string lasting_name(const std::string& task);

}  // namespace slackwater::api
