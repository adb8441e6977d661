#include "api/door/desk/site_answers.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/ask/decisions/decisions.h"
#include "api/ask/morning/plan_windows.h"
#include "api/ask/plan/make_plan.h"
#include "api/ask/plan/plan_setup.h"
#include "api/door/desk/asked_words.h"
#include "api/door/desk/kept_answers.h"
#include "api/door/desk/site_list.h"
#include "api/door/morning/make_morning.h"
#include "api/pipeline/load_site_data.h"
#include "api/pipeline/sources_json.h"
#include "api/pipeline/verify.h"
#include "api/show/decisions/decisions_json.h"
#include "api/show/morning/morning_json.h"
#include "api/show/morning/verified_text.h"
#include "api/show/plan/plan_json.h"
#include "api/show/report/skill_json.h"
#include "api/show/windows/windows_answer.h"
#include "calibration/day/sources.h"
#include "fields/base/error.h"

namespace slackwater::api::desk {
namespace {

using nlohmann::json;

/// Of a plan that is made while somebody waits for it, s.
constexpr double plan_limit_s = 20;

template <typename Parse>
auto read(const char* word, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const Error& problem) {
    throw Error(ErrorKind::usage, std::string(word) + ": " + problem.message());
  }
}

WindowsQuestion question_of(const Answers& from, const std::string& site,
                            const std::string& query) {
  static_cast<void>(described_site(site, from.store_folder));
  return windows_question(windows_words(site, query), {"", from.store_folder, from.now});
}

int cores() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

}  // namespace

void WaterAtHand::lend(const std::string& mark, WindowsQuestion& question) const {
  if (question.day || question.members > 0) return;
  const std::lock_guard lock(mutex_);
  if (!water_ || mark != mark_ || question.site != site_) return;
  question.water = water_;
  question.past = past_;
}

void WaterAtHand::keep(const std::string& mark, const WindowsQuestion& question,
                       const WindowsAnswer& answer) {
  if (question.day || question.members > 0) return;
  const std::lock_guard lock(mutex_);
  mark_ = mark;
  site_ = question.site;
  water_ = answer.water;
  past_ = answer.past;
}

json windows_answer(const Answers& from, const std::string& site, const std::string& query) {
  WindowsQuestion question = question_of(from, site, query);
  const std::string mark = mark_of(from.store_folder, from.data_folder);
  from.water->lend(mark, question);
  const WindowsAnswer answer = windows_of(question, from.store_folder);
  from.water->keep(mark, question, answer);
  return windows_json(question, answer);
}

json report_answer(const Answers& from, const std::string& id, const std::string& query) {
  const Site site = described_site(id, from.store_folder);
  MorningQuestion question;
  question.windows = question_of(from, id, query);
  if (!question.windows.day) question.now = from.now();
  question.plan = plan_of_site(site.id, from.store_folder);
  question.plan_limit_s = plan_limit_s;
  question.is_unattended = true;  // a plan that cannot be read is told beside the rest
  const std::string mark = mark_of(from.store_folder, from.data_folder);
  from.water->lend(mark, question.windows);
  const Morning morning = morning_of(question, from.store_folder);
  from.water->keep(mark, question.windows, morning.windows);
  const KnownForecast known = known_of(morning, site, from.store_folder);
  return morning_json(morning, known.past.entries, verified_text(known.past));
}

json plan_of(const Answers& from, const PlanFile& file, WindowsQuestion question, double chance,
             double limit_s) {
  const DayChances windows = windows_for_plan(file, std::move(question), from.store_folder);
  const PlanProblem problem = problem_of(file, windows, chance);
  PlanAnswer answer;
  answer.name = file.name;
  answer.site = file.site.id;
  answer.time_limit_s = limit_s;
  answer.plan = make_plan(problem, limit_s);
  return plan_json(problem, answer);
}

json plan_answer(const Answers& from, const std::string& id, const std::string& query) {
  const AskedWords words(query, {"chance", "time-limit", "assume"});
  const Site site = described_site(id, from.store_folder);
  const std::filesystem::path file = plan_of_site(site.id, from.store_folder);
  if (file.empty())
    throw Error(ErrorKind::not_found, "found no plan of site " + site.id +
                                          ", expected one in the store's plans/" + site.id +
                                          ".yaml; see api/docs/plan.md");
  WindowsQuestion question;
  for (const std::string& text : words.all("assume"))
    question.assumed.push_back(twin::parse_assumption(text));
  question.practice = AlphaPractice::of_tables({});
  question.threads = cores();
  return plan_of(from, load_plan_file(file, from.store_folder), std::move(question),
                 words.number("chance", 0, 1, twin::VerdictRule{}.marginal),
                 words.number("time-limit", 0.01, 20, plan_limit_s));
}

json verification_answer(const Answers& from, const std::string& id, const std::string& query) {
  const AskedWords words(query, {"from", "to", "bands"});
  const Site site = described_site(id, from.store_folder);
  calibration::VerifyOptions options;
  if (const std::string text = words.one("from"); !text.empty())
    options.from = read("from", text, parse_day);
  if (const std::string text = words.one("to"); !text.empty())
    options.to = read("to", text, parse_day);
  if (const std::string text = words.one("bands"); !text.empty())
    options.bands = read("bands", text, calibration::parse_bands);
  options.threads = cores();
  store::Store store = store::Store::open(from.store_folder, store::OpenMode::read_only);
  return skill_list(verify(store, site, options).entries);
}

json sources_answer(const Answers& from, const std::string& id, const std::string& query) {
  const AskedWords words(query, {"day", "horizon", "wind"});
  const Site site = described_site(id, from.store_folder);
  calibration::ForecastOptions options;
  options.issued = from.now();
  options.seen_by = options.issued;
  if (const std::string text = words.one("horizon"); !text.empty()) {
    options.horizon = read("horizon", text, [](const std::string& v) { return parse_duration(v); });
    if (options.horizon < std::chrono::hours(1) || options.horizon > std::chrono::days(15))
      throw Error(ErrorKind::usage, "horizon: found " + text + ", expected 1h to 15d");
  }
  if (const std::string text = words.one("wind"); !text.empty())
    options.wind = read("wind", text, wind_policy_from);
  if (const std::string text = words.one("day"); !text.empty())
    options.day = read("day", text, parse_day);
  store::Store store = store::Store::open(from.store_folder, store::OpenMode::read_only);
  const SiteData data = load_site_data(store, site, options);
  const calibration::Inputs inputs = calibration::inputs_of(data, options);
  return {{"site", site.id},
          {"issued", format_utc(options.issued)},
          {"day", format_day(inputs.day)},
          {"sources", sources_json(inputs.sources)}};
}

json decisions_answer(const Answers& from, const std::string& id, const std::string& query) {
  const AskedWords words(query, {"task", "from"});
  const Site site = described_site(id, from.store_folder);
  DecisionsQuestion question;
  question.windows = plain_question(site, id);
  question.task = words.one("task");
  if (!question.task.empty()) expect_id("task", question.task);
  if (const std::string text = words.one("from"); !text.empty())
    question.from = UtcTime(read("from", text, parse_day));
  question.known_by = from.now();
  return decisions_json(decisions_of(question, from.store_folder));
}

}  // namespace slackwater::api::desk
