#include "api/show/morning/morning_page.h"

#include <algorithm>
#include <array>

#include "api/ask/windows/worth.h"
#include "api/show/morning/gantt_html.h"
#include "api/show/morning/morning_clock.h"
#include "api/show/morning/morning_text.h"
#include "api/show/morning/plan_html.h"
#include "api/show/morning/recent_skill_text.h"
#include "api/show/morning/sign_off_html.h"
#include "api/show/morning/task_words.h"
#include "api/show/rehearse/risk_report.h"
#include "api/show/report/time_text.h"
#include "api/show/windows/past_words.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// One line of what past forecasts were worth, by variable.
/// @param verified  in words, where there is none
std::string trust_text(const std::vector<RecentSkill>& trust, const std::string& verified) {
  if (trust.empty()) return verified;
  std::vector<std::string> parts;
  parts.reserve(trust.size());
  for (const RecentSkill& of : trust) parts.push_back(text_of(of));
  return "error of the first day of lead: " + joined(parts, "; ");
}

/// The newest forecast whose truth is in, held against it.
std::string yesterday_html(const std::vector<RecentSkill>& trust) {
  if (trust.empty()) return {};
  const calibration::SkillEntry& of = trust.front().verdict.forecast.of;
  ReportTable table;
  table.title = "The last forecast compared with the truth: that of " + date_text(of.issued);
  table.note =
      "Root mean square error over its first day. A simple method has the same data: the last "
      "value kept, the same hour of the day before, a tide, or a slab of water pushed by the wind.";
  table.columns = {"What", "Forecast", "Best simple method", "Its error", "Better", "Against"};
  for (const RecentSkill& of_variable : trust) {
    const calibration::Verdict& verdict = of_variable.verdict;
    const std::string unit = " " + of_variable.unit;
    std::vector<std::string> row{of_variable.variable,
                                 formatted("{:.2f}", verdict.best ? verdict.best->forecast_rmse
                                                                  : verdict.forecast.score.rmse) +
                                     unit};
    if (verdict.best) {
      row.emplace_back(name_of(verdict.best->method));
      row.push_back(formatted("{:.2f}", verdict.best->rmse) + unit);
      row.emplace_back(verdict.outcome == calibration::Outcome::ahead    ? "the forecast"
                       : verdict.outcome == calibration::Outcome::beaten ? "the simple method"
                                                                         : "a tie");
    } else {
      row.insert(row.end(), {"none", "-", "-"});
    }
    row.push_back(verdict.forecast.of.truth);
    table.rows.push_back(std::move(row));
  }
  return table_html(table);
}

/// What befell a task where its flights went best, or else what is gravest of it.
void add_risks(const TaskWindows& task, const MorningClock& clock, ReportTable& table) {
  constexpr std::size_t most_risks = 3;
  const TaskStart* best = best_flown(task);
  if (best == nullptr) return;
  std::vector<twin::RiskEntry> told;
  for (const twin::RiskEntry& risk : best->twin->risks)
    if (risk.befell > 0 && told.size() < most_risks) told.push_back(risk);
  if (told.empty() && !best->twin->risks.empty()) told.push_back(best->twin->risks.front());
  for (const twin::RiskEntry& risk : told) {
    std::vector<std::string> row{task.name + " at " + clock(best->start)};
    const std::vector<std::string> cells = risk_cells(risk);
    row.insert(row.end(), cells.begin(), cells.end());
    table.rows.push_back(std::move(row));
  }
}

std::string risks_html(const Morning& morning) {
  const MorningClock clock(morning);
  ReportTable table;
  table.title = "Risks of what was flown";
  table.note =
      "Of each task what befell its best start, the gravest first, or else the gravest cause of "
      "its sheet. Bounds hold at 95 %; harm from 1 (slight) to 5 (grave), estimates unless your "
      "own register replaces them. Where the flights leave more than one class open, the first "
      "and the last. The waves of each future err in "
      "height as those of the chances above do; their period is that of the start.";
  table.columns = {"Task and start", "Cause", "Befell", "Likelihood", "Worst harm", "Risk"};
  for (const TaskWindows* task : by_verdict(morning)) add_risks(*task, clock, table);
  if (!table.rows.empty()) return table_html(table);
  return "<section class=\"words\"><h2>Risks</h2><p>Nothing was flown, so there is no register of "
         "risks: the chances above are of the limits alone. <code>slackwater report --fly "
         "15min</code> flies the starts that are left open.</p></section>\n";
}

/// What was said of past starts, and what came.
std::string said_and_came_html(const Morning& morning) {
  twin::PastVerdicts all;
  for (const TaskWindows& task : morning.windows.tasks) all += task.past;
  if (all.mornings == 0) return {};
  ReportTable table;
  table.title = "What was said of past starts, and what came";
  table.note = "All tasks above on " + counted(all.mornings, "past morning") +
               ", each told as today, from the others. Chances that say as much as they should "
               "hold as often as they were said.";
  table.columns = {"Said to be", "Starts", "Chance said", "Held"};
  constexpr std::array<const char*, 4> names{"go", "marginal", "no-go, 10 % or more",
                                             "no-go, below 10 %"};
  for (std::size_t c = 0; c < names.size(); ++c) {
    const twin::SaidAndCame& of = all.classes[c];
    if (of.starts == 0) continue;
    const auto n = static_cast<double>(of.starts);
    table.rows.push_back({names[c], std::to_string(of.starts),
                          formatted("{:.0f} %", 100 * of.said / n),
                          formatted("{:.0f} %", 100 * static_cast<double>(of.held) / n)});
  }
  return table_html(table);
}

void add_provenance(const Morning& morning, ReportInput& page) {
  const ScenarioWater& water = morning.windows.water;
  page.facts.emplace_back("Forecast", water.forecast_name);
  page.facts.emplace_back("Its checksum", water.forecast_sha256.substr(0, 12));
  page.facts.emplace_back("Futures", std::to_string(futures_of(morning)));
}

std::string notes_html(const Morning& morning) {
  std::string html;
  for (const std::string& note : morning.windows.notes)
    html += "<p>" + escaped_html(sentence(note)) + "</p>";
  return html.empty() ? html : "<section class=\"words\">" + html + "</section>\n";
}

}  // namespace

ReportInput morning_page(const Morning& morning, const ForecastPage& forecast) {
  ReportInput page = forecast_page(forecast);
  const std::string of_forecast = page.headline;
  page.title = "Go or no-go: " + morning.windows.site_name;
  page.headline = (morning.today ? today_headline_of(morning) + " " : "") + headline_of(morning);
  const WindPolicy wind = forecast.forecast->wind_policy.value_or(WindPolicy::best);
  page.decisions_html = gantt_today_html(morning) + gantt_html(morning) + notes_html(morning) +
                        plan_html(morning) + sign_off_html(morning);
  page.answer.emplace_back("The forecast", of_forecast);
  std::erase_if(page.answer, [](const auto& line) { return line.first == "How good it was"; });
  page.answer.emplace_back("Trust", trust_text(trust_of(forecast.skill, wind), forecast.verified));
  page.answer.emplace_back("Goes so far", past_text(morning.windows));
  page.after_plots_html = said_and_came_html(morning) + risks_html(morning) +
                          yesterday_html(trust_of(newest_day_of(forecast.skill, wind), wind));
  add_provenance(morning, page);
  return page;
}

}  // namespace slackwater::api
