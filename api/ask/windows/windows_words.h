#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "api/ask/windows/windows.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// What a user may say of windows: as options of a command, or in a query over HTTP.
struct WindowsWords {
  std::string site, day;
  std::filesystem::path forecast;
  std::vector<std::string> tasks, turbines, assume, alpha;
  std::string from, to, contingency, every = "30min", light, shift, zone, waves = "error";
  std::string period_from = "issue";
  std::size_t members = 0;
  double go = 0.9, marginal = 0.5;
  int threads = 0;  ///< 0: one a core
};

/// Where words were said.
struct WordsSaid {
  std::string before_names;  ///< of a word, in errors: "--" of "--from"
  std::filesystem::path store_folder;
  std::function<UtcTime()> now;  ///< what "now" means
};

/// @throws Error(usage) for what cannot be read, Error(not_found) for a site that there is not
[[nodiscard]] WindowsQuestion windows_question(const WindowsWords& words, const WordsSaid& said);

/// The question about a site's own tasks where nothing else was said.
/// @param named  as it was named: its id, or the path of its file
[[nodiscard]] WindowsQuestion plain_question(const Site& site, const std::string& named);

/// Between two starts, or of flights: 1 min to 1 day. @throws Error(usage)
[[nodiscard]] Duration positive_duration(const std::string& name, const std::string& text);

}  // namespace slackwater::api
