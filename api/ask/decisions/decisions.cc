#include "api/ask/decisions/decisions.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "api/ask/decisions/decide.h"
#include "api/ask/decisions/what_came_of_start.h"
#include "api/pipeline/past_mornings.h"
#include "api/program/paths.h"
#include "data/store/store.h"
#include "fields/base/attempt.h"
#include "fields/base/parallel.h"
#include "fields/site/site.h"

namespace slackwater::api {
namespace {

using std::chrono::days;

/// As many days of data are held at a time.
constexpr days at_a_time{40};

void mark_what_counts(std::vector<DecisionAnswer>& decisions) {
  std::map<std::tuple<std::string, std::string, UtcTime>, DecisionAnswer*> last;
  for (DecisionAnswer& one : decisions) {
    DecisionAnswer*& before = last[{one.row.task, one.row.turbine, one.row.start}];
    if (before != nullptr) before->counts = false;
    before = &one;
  }
}

/// Of decisions of a stretch of days.
/// @param forecasts  of the site
void tell_what_came(const DecisionsQuestion& question, const Site& site,
                    const std::filesystem::path& store_folder, store::Store& store,
                    const std::vector<store::ForecastRow>& forecasts,
                    std::span<DecisionAnswer> decisions) {
  std::vector<store::ForecastRow> rows;
  std::map<std::int64_t, std::size_t> place;
  UtcTime until = UtcTime::min();
  for (const store::ForecastRow& row : forecasts) {
    if (std::none_of(decisions.begin(), decisions.end(),
                     [&](const DecisionAnswer& one) { return one.row.forecast == row.id; }))
      continue;
    place[row.id] = rows.size();
    rows.push_back(row);
    until = std::max(until, row.valid_to + days(1));
  }
  std::vector<ForecastAndCame> came;
  const int threads = question.windows.threads;
  const auto failure =
      attempt([&] { came = what_came_of(store, site, rows, until, question.known_by, threads); });
  for_all(decisions.size(), threads, [&](std::size_t i) {
    DecisionAnswer& one = decisions[i];
    if (failure)
      one.what.why = failure->why;
    else
      one.what = what_came_of_start(question.windows, one.row, came[place.at(one.row.forecast)],
                                    store_folder);
  });
}

}  // namespace

std::string_view name_of(Came came) noexcept {
  switch (came) {
    case Came::held:
      return "held";
    case Came::did_not_hold:
      return "did_not_hold";
    case Came::not_known_yet:
      return "not_known_yet";
    case Came::cannot_be_known:
      return "cannot_be_known";
  }
  return "";
}

DecisionsRecord record_of(const std::vector<DecisionAnswer>& decisions, UtcTime known_by) {
  struct Day {
    bool has_go = false, is_lost = false, is_open = false;
  };
  DecisionsRecord record;
  std::map<std::pair<std::string, UtcDay>, Day> by_day;
  std::set<std::string> tasks;
  for (const DecisionAnswer& one : decisions) {
    if (!one.counts || one.row.recorded_at > known_by) continue;
    tasks.insert(one.row.task);
    Day& day = by_day[{one.row.task, day_of(one.row.start)}];
    const bool has_held = one.what.came == Came::held;
    if (one.row.decided == store::Decided::go) {
      day.has_go = true;
      if (is_known(one.what.came)) {
        ++record.goes_known;
        record.goes_held += has_held ? 1 : 0;
      } else {
        ++record.goes_open;
      }
    } else {
      day.is_lost |= has_held;
      day.is_open |= !is_known(one.what.came);
    }
  }
  for (const auto& [key, day] : by_day) {
    if (day.has_go) continue;
    record.days_lost += day.is_lost ? 1 : 0;
    record.days_open += !day.is_lost && day.is_open ? 1 : 0;
  }
  record.tasks = tasks.size();
  return record;
}

DecisionsAnswer decisions_of(const DecisionsQuestion& question,
                             const std::filesystem::path& store_folder) {
  const Site site = find_site(question.windows.site, site_folders(store_folder));
  store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
  DecisionsAnswer answer;
  answer.site_id = site.id;
  answer.site_name = site.name;
  answer.zone = site.time_zone;
  answer.known_by = question.known_by;
  store::DecisionQuery query;
  query.site_id = site.id;
  if (!question.task.empty()) query.task = lasting_name(question.task);
  query.from = question.from;
  for (store::DecisionRow& row : store.find_decisions(query)) {
    DecisionAnswer& one = answer.decisions.emplace_back();
    one.is_late = row.recorded_at > row.start;
    one.row = std::move(row);
  }
  if (answer.decisions.empty()) return answer;
  mark_what_counts(answer.decisions);
  store::ForecastQuery of_site;
  of_site.site_id = site.id;
  const std::vector<store::ForecastRow> forecasts = store.find_forecasts(of_site);
  for (auto first = answer.decisions.begin(); first != answer.decisions.end();) {
    const auto last = std::find_if(first, answer.decisions.end(), [&](const DecisionAnswer& one) {
      return one.row.start >= first->row.start + at_a_time;
    });
    tell_what_came(question, site, store_folder, store, forecasts, {first, last});
    first = last;
  }
  answer.record = record_of(answer.decisions, question.known_by);
  return answer;
}

}  // namespace slackwater::api
