#include "api/ask/history/campaign_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "api/ask/history/sea_limit.h"
#include "fields/base/config.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Reads the value of a key by `parse`; its error names file, line and key.
template <typename Parse>
auto read(const Config& config, std::string_view key, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const Error& problem) {
    config.refuse(key, problem.message());
  }
}

Duration read_duration(const Config& config, std::string_view key, bool may_be_zero) {
  const Duration found = read(config, key, config.text(key), parse_duration);
  if (found <= Duration(0) && !may_be_zero) config.refuse(key, "found 0, expected more");
  return found;
}

std::chrono::month_day date_in(const std::string& text) {
  unsigned month = 0;
  unsigned day = 0;
  const bool has_form = text.size() == 5 && text[2] == '-';
  if (has_form) {
    std::from_chars(text.data(), text.data() + 2, month);
    std::from_chars(text.data() + 3, text.data() + 5, day);
  }
  const std::chrono::month_day date{std::chrono::month(month), std::chrono::day(day)};
  if (!has_form || !date.ok())
    throw Error(ErrorKind::invalid_input,
                "found '" + text + "' where a date of the year was expected; write it as 04-01");
  return date;
}

std::optional<twin::DayHours> read_hours(const Config& config, std::string_view key) {
  const auto text = config.optional_text(key);
  if (!text) return std::nullopt;
  return read(config, key, *text, twin::parse_day_hours);
}

std::vector<SeriesLimit> read_limits(const Config& config) {
  const std::filesystem::path folder = std::filesystem::path(config.name()).parent_path();
  std::vector<SeriesLimit> limits;
  for (const std::string& text : config.texts("limits"))
    limits.push_back(read(config, "limits", text, [&](const std::string& limit) {
      return read_series_limit(limit, folder);
    }));
  return limits;
}

CampaignTaskText read_task(const Config& config, const std::vector<SeriesLimit>& of_all) {
  CampaignTaskText task;
  task.name = config.text("name");
  task.times = static_cast<std::size_t>(config.optional_integer("times", 1, 10000).value_or(1));
  task.limits = of_all;
  const std::vector<SeriesLimit> own = read_limits(config);
  task.limits.insert(task.limits.end(), own.begin(), own.end());
  task.duration = read_duration(config, "duration", false);
  if (config.has("contingency")) task.contingency = read_duration(config, "contingency", true);
  task.start_hours = read_hours(config, "start_hours");
  task.working_hours = read_hours(config, "working_hours");
  if (const auto light = config.optional_text("daylight"))
    task.daylight = read(config, "daylight", *light, twin::parse_light);
  if (const auto split = config.optional_child("split")) {
    task.split = CampaignTaskText::Split{};
    task.split->shortest_visit = read_duration(*split, "shortest_visit", false);
    if (split->has("lost")) task.split->lost = read_duration(*split, "lost", true);
    if (task.split->lost >= task.split->shortest_visit)
      split->refuse("lost",
                    "found a loss as long as the shortest visit or longer; expected less than "
                    "shortest_visit");
    if (task.start_hours)
      config.refuse("start_hours", "found start_hours for split work; write working_hours");
    if (task.contingency > Duration(0))
      config.refuse("contingency",
                    "found contingency for split work, which needs none; leave it out");
  }
  return task;
}

}  // namespace

CampaignFile load_campaign(const std::filesystem::path& file) {
  const Config config = Config::load(file);
  CampaignFile campaign;
  campaign.name = config.optional_text("name").value_or(file.stem().string());
  if (const auto zone = config.optional_text("timezone"))
    campaign.zone = read(config, "timezone", *zone,
                         [](const std::string& name) { return TimeZone::named(name); });
  for (const std::string& text : config.texts("begin"))
    campaign.begin.push_back(read(config, "begin", text, date_in));
  if (campaign.begin.empty()) {
    for (unsigned month = 1; month <= 12; ++month)
      campaign.begin.emplace_back(std::chrono::month(month), std::chrono::day(1));
  }
  for (const double teams : config.numbers("teams", {1, 1000})) {
    if (teams != std::floor(teams))
      config.refuse("teams", "found a fraction where whole numbers were expected");
    campaign.teams.push_back(static_cast<std::size_t>(teams));
    if (std::count(campaign.teams.begin(), campaign.teams.end(), campaign.teams.back()) > 1)
      config.refuse("teams", formatted("found {} twice; keep one", campaign.teams.back()));
  }
  if (campaign.teams.empty()) campaign.teams = {1};
  const std::vector<SeriesLimit> of_all = read_limits(config);
  for (const Config& task : config.children("tasks"))
    campaign.tasks.push_back(read_task(task, of_all));
  config.expect_all_read();
  if (campaign.tasks.empty()) config.refuse("tasks", "found none, expected a list of one at least");
  if (campaign.limits().empty())
    config.refuse("limits", "found no limit, of all tasks or of one; expected at least one");
  return campaign;
}

}  // namespace slackwater::api
