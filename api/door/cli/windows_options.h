#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/windows/fly_windows.h"
#include "api/ask/windows/windows.h"
#include "api/door/cli/command.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// What a user may say of windows, at `windows` and at `report`.
struct WindowsArguments {
  std::string site, day;
  std::filesystem::path forecast;
  std::vector<std::string> tasks, turbines, assume, alpha;
  std::string from, to, contingency, every = "30min", light, shift, zone, waves = "error";
  std::string period_from = "issue";
  std::size_t members = 0;
  double go = 0.9, marginal = 0.5;
  bool verdict_exit = false;
  std::string fly, fly_every = "1h";
  int threads = 0;
};

void add_windows_options(CLI::App& command, WindowsArguments& arguments);

/// @throws Error(usage) for what cannot be read
[[nodiscard]] WindowsQuestion windows_question(const WindowsArguments& arguments,
                                               const Context& context);
/// Nothing where no flights were asked for. @throws Error(usage)
[[nodiscard]] std::optional<FlyWindows> flights_wanted(const WindowsArguments& arguments);

/// The question about a site's own tasks where nothing else was said.
/// @param named  as it was named: its id, or the path of its file
[[nodiscard]] WindowsQuestion plain_question(const Site& site, const std::string& named);

/// 10 for go, 11 for marginal, 12 for no-go.
[[nodiscard]] int exit_code_of(twin::Verdict verdict) noexcept;

}  // namespace slackwater::api
