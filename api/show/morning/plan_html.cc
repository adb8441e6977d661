#include "api/show/morning/plan_html.h"

#include "api/ask/plan/plan_rules.h"
#include "api/show/plan/plan_text.h"
#include "api/show/report/html_page.h"
#include "api/show/report/time_text.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Tells the minutes of a plan as the page tells all times.
class PlanClock {
 public:
  explicit PlanClock(const Morning& morning)
      : begin_(morning.plan->problem.begin), clock_(morning.question.windows.zone) {}
  [[nodiscard]] UtcTime at(Minute minute) const { return begin_ + std::chrono::minutes(minute); }
  [[nodiscard]] std::string operator()(Minute minute) const { return clock_.clock(at(minute)); }
  [[nodiscard]] std::string operator()(Minute from, Minute to) const {
    return clock_.clocks(at(from), at(to));
  }

 private:
  UtcTime begin_;
  PageClock clock_;
};

std::string jobs_html(const MorningPlan& made, const PlanClock& clock) {
  const PlanProblem& problem = made.problem;
  ReportTable table;
  table.title = "What to do when: " + made.answer.name;
  table.note = worth_text(problem, made.answer.plan);
  table.columns = {"From and to", "Job", "Chance", "Vessel", "Crew", "Vehicles"};
  for (const Assignment& one : made.answer.plan.assignments) {
    std::vector<std::string> vehicles;
    for (const std::size_t k : one.vehicles) vehicles.push_back(problem.vehicles[k].id);
    table.rows.push_back(
        {clock(begin_of(problem, one), end_of(problem, one)), problem.jobs[one.job].id,
         chance_and_verdict(start_of(problem, one).probability), problem.vessels[one.vessel].id,
         problem.crews[one.crew].id, joined(vehicles, ", ")});
  }
  return table_html(table);
}

std::string ways_html(const MorningPlan& made, const PlanClock& clock) {
  const PlanProblem& problem = made.problem;
  ReportTable table;
  table.title = "Ways of the vessels";
  table.columns = {"Vessel", "Leaves", "From", "To", "Arrives"};
  for (std::size_t v = 0; v < problem.vessels.size(); ++v)
    for (const VesselWay& way : ways_of_vessel(problem, made.answer.plan.assignments, v))
      table.rows.push_back({problem.vessels[v].id, clock(way.leaves), problem.places[way.from],
                            problem.places[way.to], clock(way.arrives)});
  return table.rows.empty() ? std::string() : table_html(table);
}

std::string left_html(const MorningPlan& made) {
  if (made.answer.plan.left.empty()) return {};
  std::string html = "<section class=\"words\"><h2>Left for another day</h2><ul>";
  for (const LeftJob& left : made.answer.plan.left)
    html += "<li>" + escaped_html(made.problem.jobs[left.job].id + ": " + left.why) + "</li>";
  return html + "</ul></section>\n";
}

}  // namespace

std::string plan_html(const Morning& morning) {
  if (!morning.no_plan.empty())
    return "<section class=\"words\"><h2>What to do when</h2><p>There is no plan: " +
           escaped_html(morning.no_plan) + "</p></section>\n";
  if (!morning.plan) return {};
  const PlanClock clock(morning);
  return jobs_html(*morning.plan, clock) + ways_html(*morning.plan, clock) +
         left_html(*morning.plan);
}

}  // namespace slackwater::api
