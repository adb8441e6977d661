#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/history/history.h"
#include "api/door/cli/command.h"

namespace slackwater::api {

/// Where commands over a history take it from, as their options say.
struct HistoryArguments {
  std::vector<std::filesystem::path> files;
  std::string site;
  std::vector<std::string> columns;
  std::string time_column;
  bool assume_utc = false;
  std::optional<double> depth_m;
  std::vector<double> missing;
  std::optional<double> latitude;
  std::optional<double> longitude;
  std::string from;
  std::string to;
};

/// The series themselves, or `--site`.
void add_history_series(CLI::App& command, HistoryArguments& arguments);
/// What is said of them: columns, times, depth, missing values, first and last day.
void add_history_options(CLI::App& command, HistoryArguments& arguments);
/// Their place.
void add_history_place(CLI::App& command, HistoryArguments& arguments);

/// @throws Error(usage) for options that contradict each other
[[nodiscard]] HistorySource source_of(const HistoryArguments& arguments, const Context& context);

/// Prints an answer in the form that was asked for; beside words its notes, on stderr.
void print_history_answer(const nlohmann::json& document, const std::string& text,
                          const Context& context);

}  // namespace slackwater::api
