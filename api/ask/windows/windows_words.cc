#include "api/ask/windows/windows_words.h"

#include <algorithm>
#include <thread>

#include "api/program/paths.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

int cores() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

template <typename Parse>
auto read(const std::string& name, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const Error& problem) {
    throw Error(ErrorKind::usage, name + ": " + problem.message());
  }
}

UtcTime time_of(const std::string& name, const std::string& text, const WordsSaid& said) {
  return text == "now" ? said.now() : read(name, text, parse_utc);
}

/// The hours in which a site works, where nobody says others.
std::optional<twin::DayHours> shift_of(const Site& site) {
  if (site.shift.empty()) return std::nullopt;
  return with_context("site " + site.id + ", shift",
                      [&] { return twin::parse_day_hours(site.shift); });
}

AlphaPractice practice_of(const std::vector<std::string>& named, const Site& site,
                          const WordsSaid& said, int threads) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : named)
    if (name != "errors") files.emplace_back(name);
  if (files.size() == named.size()) return AlphaPractice::of_tables(files);
  if (files.size() + 1 < named.size())
    throw Error(ErrorKind::usage, said.before_names + "alpha: found errors twice; name it once");
  return AlphaPractice::of_errors(
      twin::with_verified(published_height_errors(),
                          verified_heights(site, said.store_folder, threads)),
      files);
}

}  // namespace

Duration positive_duration(const std::string& name, const std::string& text) {
  const Duration found =
      read(name, text, [](const std::string& value) { return parse_duration(value); });
  if (found < std::chrono::minutes(1) || found > std::chrono::days(1))
    throw Error(ErrorKind::usage, name + ": found " + text + ", expected 1min to 1d");
  return found;
}

WindowsQuestion windows_question(const WindowsWords& words, const WordsSaid& said) {
  const auto name = [&](const char* word) { return said.before_names + word; };
  WindowsQuestion question;
  question.site = words.site;
  question.forecast = words.forecast;
  if (!words.day.empty()) question.day = read(name("day"), words.day, parse_day);
  question.tasks = words.tasks;
  question.turbines = words.turbines;
  if (!words.from.empty()) question.from = time_of(name("from"), words.from, said);
  if (!words.to.empty()) question.to = time_of(name("to"), words.to, said);
  question.every = positive_duration(name("every"), words.every);
  if (!words.contingency.empty())
    question.contingency = read(name("contingency"), words.contingency,
                                [](const std::string& value) { return parse_duration(value); });
  question.members = words.members;
  question.waves_as_forecast = words.waves == "forecast";
  for (const std::string& text : words.assume)
    question.assumed.push_back(twin::parse_assumption(text));
  if (!words.light.empty()) question.light = read(name("light"), words.light, twin::parse_light);
  if (!words.shift.empty())
    question.shift = read(name("shift"), words.shift, twin::parse_day_hours);
  if (!words.zone.empty())
    question.zone = read(name("timezone"), words.zone,
                         [](const std::string& zone) { return TimeZone::named(zone); });
  const Site site = find_site(words.site, site_folders(said.store_folder));
  if (words.zone.empty()) question.zone = site.time_zone;
  if (words.shift.empty()) question.shift = shift_of(site);
  question.period_from_start = words.period_from == "start";
  if (words.marginal > words.go)
    throw Error(ErrorKind::usage, "found " + name("marginal") + " above " + name("go") +
                                      ", expected at most as much");
  question.rule = {words.go, words.marginal};
  question.threads = words.threads > 0 ? words.threads : cores();
  question.practice = practice_of(words.alpha, site, said, question.threads);
  return question;
}

WindowsQuestion plain_question(const Site& site, const std::string& named) {
  WindowsQuestion question;
  question.site = named;
  question.zone = site.time_zone;
  question.shift = shift_of(site);
  question.practice = AlphaPractice::of_tables({});
  question.threads = cores();
  return question;
}

}  // namespace slackwater::api
