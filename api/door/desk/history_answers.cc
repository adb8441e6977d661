#include "api/door/desk/history_answers.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/ask/history/climate.h"
#include "api/ask/history/sea_limit.h"
#include "api/ask/history/workability.h"
#include "api/door/desk/asked_words.h"
#include "api/door/desk/site_list.h"
#include "api/door/edr/read/bad_parameter.h"
#include "api/show/history/climate_answer.h"
#include "api/show/history/workability_answer.h"
#include "fields/base/error.h"

namespace slackwater::api::desk {
namespace {

using edr::bad_parameter;
using nlohmann::json;

ingest::Vocabulary vocabulary_of(const Answers& from) {
  return ingest::Vocabulary::load(from.data_folder / "products" / "variables.yaml");
}

HistorySource source_of(const Answers& from, const std::string& site, const AskedWords& words) {
  HistorySource source;
  source.site = described_site(site, from.store_folder).id;
  source.store_folder = from.store_folder;
  if (!words.one("depth").empty()) source.options.depth_m = words.number("depth", 0, 12000, 0);
  source.from = words.read_one("from", parse_day);
  source.to = words.read_one("to", parse_day);
  if (source.from && source.to && *source.to < *source.from)
    throw bad_parameter("from", words.one("from"), "a day that is not after to");
  return source;
}

WorkabilityQuestion workability_question(const AskedWords& words) {
  WorkabilityQuestion question;
  for (const std::string& text : words.all("limit"))
    question.limits.push_back(read_word("limit", text, parse_series_limit));
  if (question.limits.empty())
    throw bad_parameter("limit", "", "one or more, e.g. sea_surface_wave_significant_height<=1.5");
  const auto duration = words.read_one("duration", duration_in);
  if (!duration || *duration <= Duration(0))
    throw bad_parameter("duration", words.one("duration"), "how long the task takes, e.g. 12h");
  question.duration = *duration;
  question.contingency = words.read_one("contingency", duration_in).value_or(Duration(0));
  question.start_hours = words.read_one("start-hours", twin::parse_day_hours);
  question.daylight = words.read_one("daylight", twin::parse_light);
  question.zone =
      words.read_one("timezone", [](const std::string& name) { return TimeZone::named(name); });
  return question;
}

ClimateQuestion climate_question(const AskedWords& words) {
  ClimateQuestion question;
  if (const auto what = words.all("what"); !what.empty()) {
    const auto is_asked = [&](const char* one) {
      return std::find(what.begin(), what.end(), one) != what.end();
    };
    question.roses = is_asked("roses");
    question.scatter = is_asked("scatter");
    question.extremes = is_asked("extremes");
    for (const std::string& one : what)
      if (one != "roses" && one != "scatter" && one != "extremes")
        throw bad_parameter("what", one, "roses, scatter or extremes");
  }
  if (const auto of = words.all("of"); !of.empty()) {
    question.of.clear();
    for (const std::string& text : of) {
      const ClimateOf one = read_word("of", text, parse_climate_of);
      if (std::find(question.of.begin(), question.of.end(), one) == question.of.end())
        question.of.push_back(one);
    }
  }
  question.sectors = words.count("sectors", 360, 12);
  if (const auto years = words.all("return-period"); !years.empty()) {
    std::vector<double> asked;
    for (const std::string& text : years)
      asked.push_back(number_in("return-period", text, least_return_years, most_return_years));
    question.storms.return_years = return_periods(std::move(asked));
  }
  return question;
}

}  // namespace

json workability_answer(const Answers& from, const std::string& site, const std::string& query) {
  const AskedWords words(query, {"limit", "duration", "contingency", "start-hours", "daylight",
                                 "timezone", "depth", "from", "to"});
  const ingest::Vocabulary vocabulary = vocabulary_of(from);
  const HistorySource source = source_of(from, site, words);
  const WorkabilityQuestion question = workability_question(words);
  const std::vector<std::string> idle = expect_possible(question.limits, vocabulary);
  History history = load_history(source, question.limits, vocabulary);
  history.notes.insert(history.notes.end(), idle.begin(), idle.end());
  const WorkabilityAnswer answer = answer_of(history, question, vocabulary);
  return workability_json(history, question, answer, vocabulary);
}

json climate_answer(const Answers& from, const std::string& site, const std::string& query) {
  const AskedWords words(query, {"what", "of", "sectors", "return-period", "depth", "from", "to"});
  const ingest::Vocabulary vocabulary = vocabulary_of(from);
  const HistorySource source = source_of(from, site, words);
  const ClimateQuestion question = climate_question(words);
  const History history = load_history(source, wanted_by(question), vocabulary);
  const ClimateAnswer answer = answer_of(history, question, vocabulary);
  return climate_json(history, question, answer);
}

}  // namespace slackwater::api::desk
