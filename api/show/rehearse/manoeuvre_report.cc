#include "api/show/rehearse/manoeuvre_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater::api {
namespace {

using constants::degree;
using nlohmann::json;
using twin::ManoeuvreAccount;
using twin::ManoeuvreKind;
using twin::Ordered;
using twin::StepAccount;
using twin::TaskOrder;

double helm_for_people(const ManoeuvreAccount& m, double helm) {
  return m.by_rudder ? helm / degree : helm;
}

/// "10 degrees of rudder", "0.3 of the thrusters' yaw moment"
std::string helm_text(const ManoeuvreAccount& m) {
  for (const TaskOrder& order : m.orders)
    if (order.is(Ordered::helm))
      return formatted("{:.4g}", std::abs(helm_for_people(m, order.value))) +
             (m.by_rudder ? " degrees of rudder" : " of the thrusters' yaw moment");
  return "";
}

std::string side_text(const ManoeuvreAccount& m) {
  for (const TaskOrder& order : m.orders)
    if (order.is(Ordered::helm)) return order.value < 0 ? "to port" : "to starboard";
  return "";
}

/// Parts of a sentence, those that there are.
struct Parts {
  std::vector<std::string> all;
  void add(const std::string& part) { all.push_back(part); }
  void add(const char* what, const std::optional<double>& value, int digits, const char* unit,
           double per = 1) {
    if (value) all.push_back(formatted("{} {:.{}f}{}", what, *value / per, digits, unit));
  }
  [[nodiscard]] std::string text() const { return joined(all, ", "); }
};

std::string circle_text(const ManoeuvreAccount& m) {
  const twin::TurningCircle& circle = *m.circle;
  Parts parts;
  parts.add("advance", circle.advance_m, 2, " m");
  parts.add("transfer", circle.transfer_m, 2, " m");
  parts.add("tactical diameter", circle.tactical_diameter_m, 2, " m");
  parts.add("360 degrees in", circle.full_s, 1, " s");
  if (circle.steady)
    parts.add(
        formatted("steady at {:.2f} degrees/s on a radius of {:.2f} m, {:.2f} m/s ({:.0f} % "
                  "of the approach), bow {:.1f} degrees into the turn",
                  std::abs(circle.steady->turn_rad_s) / degree, circle.steady->radius_m,
                  circle.steady->speed_m_s, 100 * circle.steady->speed_kept,
                  (circle.to_starboard ? 1 : -1) * circle.steady->drift_rad / degree));
  return parts.text();
}

std::string zig_zag_text(const ManoeuvreAccount& m) {
  const twin::ZigZag& found = *m.zig_zag;
  Parts parts;
  std::vector<std::string> overshoots;
  for (const double overshoot : found.overshoot_rad)
    overshoots.push_back(formatted("{:.2f}", overshoot / degree));
  if (!overshoots.empty()) parts.add("overshoots " + joined(overshoots, ", ") + " degrees");
  parts.add("period", found.period_s, 1, " s");
  parts.add("initial turning", found.initial_turning_m, 2, " m");
  return parts.text();
}

std::string spiral_text(const ManoeuvreAccount& m) {
  const twin::Spiral& found = *m.spiral;
  Parts parts;
  const auto steady = static_cast<std::size_t>(
      std::count_if(found.points.begin(), found.points.end(),
                    [](const twin::SpiralPoint& point) { return point.is_steady; }));
  parts.add(formatted("{} helms, steady at {} of them", found.points.size(), steady));
  parts.add("loop", found.loop_width_rad, m.by_rudder ? 2 : 3,
            m.by_rudder ? " degrees wide" : " of the yaw moment wide", m.by_rudder ? degree : 1);
  parts.add("loop", found.loop_height_rad_s, 3, " degrees/s high", degree);
  return parts.text();
}

std::string pull_out_text(const ManoeuvreAccount& m) {
  return formatted("{:.3f} degrees/s left of {:.2f}", m.pull_out->residual_rad_s / degree,
                   m.pull_out->turn_rad_s / degree);
}

/// Heading in degrees of a compass, else as it is.
std::string kept_text(Ordered what, double value) {
  if (what == Ordered::heading) return formatted("{:.1f}", compass_deg(value / degree));
  return formatted("{:.2f}", value);
}

const char* unit_of(Ordered what) {
  return what == Ordered::heading ? " degrees" : what == Ordered::speed ? " m/s" : " m";
}

std::string step_text(const StepAccount& step) {
  const double per = step.what == Ordered::heading ? degree : 1;
  std::string text = formatted("{} from {} to {}{} at {:g} s: ", name_of(step.what),
                               kept_text(step.what, step.from), kept_text(step.what, step.to),
                               unit_of(step.what), step.at_s);
  if (!step.response) return text + "too few rows of the log for figures";
  Parts parts;
  parts.add("rise", step.response->rise_s, 2, " s");
  if (!step.response->rise_s) parts.add("did not rise to 90 %");
  parts.add(formatted("overshoot {:.1f} %", 100 * step.response->overshoot));
  parts.add("settled after", step.response->settling_s, 2, " s");
  if (!step.response->settling_s) parts.add("did not settle within 5 %");
  parts.add(
      formatted("{:+.3f}{} off at its end", step.response->steady_error / per, unit_of(step.what)));
  return text + parts.text();
}

std::string steps_text(const ManoeuvreAccount& m) {
  if (m.steps.empty()) return "no step was reached";
  std::vector<std::string> texts;
  for (const StepAccount& step : m.steps) texts.push_back(step_text(step));
  return joined(texts, "; ");
}

std::string figures_text(const ManoeuvreAccount& m) {
  if (m.circle) return circle_text(m);
  if (m.zig_zag) return zig_zag_text(m);
  if (m.spiral) return spiral_text(m);
  if (m.pull_out) return pull_out_text(m);
  if (m.kind == ManoeuvreKind::steps && m.has_begun()) return steps_text(m);
  return "";
}

/// "tactical_diameter_m" as "tactical diameter".
std::string plain_name(std::string name) {
  if (name == "all") return "figures";
  for (const char* unit : {"_deg_s", "_deg", "_share", "_m", "_s"})
    if (name.ends_with(unit)) {
      name.resize(name.size() - std::string(unit).size());
      break;
    }
  std::replace(name.begin(), name.end(), '_', ' ');
  for (const char* of_a_turn : {"steady", "quarter", "half", "three quarters", "full"})
    if (name == of_a_turn) return name + " turn";
  return name;
}

/// Those with one reason together.
std::string absent_text(const ManoeuvreAccount& m) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < m.absent.size();) {
    std::vector<std::string> names;
    const std::string& why = m.absent[i].why;
    for (; i < m.absent.size() && m.absent[i].why == why; ++i)
      names.push_back(plain_name(m.absent[i].name));
    texts.push_back("no " + joined(names, ", no ") + ": " + why);
  }
  return joined(texts, "; ");
}

std::string approach_text(const twin::ApproachAccount& approach) {
  if (approach.is_steady()) return formatted("approach of {:.3f} m/s", approach.speed_m_s);
  return formatted(
      "the approach was not steady: {:.3f} m/s and up to {:.3f} off it, headings {:.1f} degrees "
      "apart",
      approach.speed_m_s, approach.most_off_m_s, approach.turned_rad / degree);
}

json steady_json(const std::optional<twin::SteadyTurn>& steady) {
  if (!steady) return nullptr;
  return {{"turn_deg_s", number(steady->turn_rad_s / degree)},
          {"speed_m_s", number(steady->speed_m_s)},
          {"radius_m", number(steady->radius_m)},
          {"drift_deg", number(steady->drift_rad / degree)},
          {"speed_kept", number(steady->speed_kept)}};
}

json circle_json(const twin::TurningCircle& circle) {
  return {{"to", circle.to_starboard ? "starboard" : "port"},
          {"advance_m", number(circle.advance_m)},
          {"transfer_m", number(circle.transfer_m)},
          {"tactical_diameter_m", number(circle.tactical_diameter_m)},
          {"quarter_s", number(circle.quarter_s)},
          {"half_s", number(circle.half_s)},
          {"three_quarters_s", number(circle.three_quarters_s)},
          {"full_s", number(circle.full_s)},
          {"steady", steady_json(circle.steady)}};
}

json zig_zag_json(const twin::ZigZag& found) {
  json overshoots = json::array(), executes = json::array();
  for (const double overshoot : found.overshoot_rad)
    overshoots.push_back(number(overshoot / degree));
  for (const double execute : found.execute_s) executes.push_back(number(execute));
  return {{"overshoots_deg", overshoots},
          {"executes_s", executes},
          {"initial_turning_m", number(found.initial_turning_m)},
          {"period_s", number(found.period_s)}};
}

json spiral_json(const ManoeuvreAccount& m) {
  const char* const helm = m.by_rudder ? "helm_deg" : "helm_share";
  const char* const width = m.by_rudder ? "loop_width_deg" : "loop_width_share";
  json points = json::array();
  for (const twin::SpiralPoint& point : m.spiral->points)
    points.push_back({{helm, number(helm_for_people(m, point.helm_rad))},
                      {"turn_deg_s", number(point.turn_rad_s / degree)},
                      {"steady", point.is_steady}});
  const auto& wide = m.spiral->loop_width_rad;
  const auto& high = m.spiral->loop_height_rad_s;
  return {{"points", points},
          {width, wide ? number(helm_for_people(m, *wide)) : json(nullptr)},
          {"loop_height_deg_s", high ? number(*high / degree) : json(nullptr)}};
}

json step_json(const StepAccount& step) {
  const bool is_heading = step.what == Ordered::heading;
  const auto kept = [&](double value) {
    return number(is_heading ? compass_deg(value / degree) : value);
  };
  json out{{"what", name_of(step.what)},
           {"unit", is_heading                    ? "deg"
                    : step.what == Ordered::speed ? "m/s"
                                                  : "m"},
           {"at_s", number(step.at_s)},
           {"from", kept(step.from)},
           {"to", kept(step.to)},
           {"lasted_s", number(step.lasted_s)}};
  const auto& r = step.response;
  out["rise_s"] = r ? number(r->rise_s) : json(nullptr);
  out["time_63_s"] = r ? number(r->time_63_s) : json(nullptr);
  out["overshoot"] = r ? number(r->overshoot) : json(nullptr);
  out["settling_s"] = r ? number(r->settling_s) : json(nullptr);
  out["steady_error"] = r ? number(r->steady_error / (is_heading ? degree : 1)) : json(nullptr);
  return out;
}

json figures_json(const ManoeuvreAccount& m) {
  if (m.circle) return circle_json(*m.circle);
  if (m.zig_zag) return zig_zag_json(*m.zig_zag);
  if (m.spiral) return spiral_json(m);
  if (m.pull_out)
    return {{"turn_deg_s", number(m.pull_out->turn_rad_s / degree)},
            {"residual_turn_deg_s", number(m.pull_out->residual_rad_s / degree)}};
  if (m.kind != ManoeuvreKind::steps || !m.has_begun()) return nullptr;
  json steps = json::array();
  for (const StepAccount& step : m.steps) steps.push_back(step_json(step));
  return {{"steps", steps}};
}

json helms_json(const ManoeuvreAccount& m) {
  json helms = json::array();
  for (const TaskOrder& order : m.orders)
    if (order.is(Ordered::helm))
      helms.push_back(
          {{"at_s", number(order.t_s)},
           {m.by_rudder ? "helm_deg" : "helm_share", number(helm_for_people(m, order.value))}});
  return helms;
}

}  // namespace

std::string manoeuvre_name(const ManoeuvreAccount& m) {
  std::string kind = name_of(m.kind);
  std::replace(kind.begin(), kind.end(), '_', m.kind == ManoeuvreKind::turning_circle ? ' ' : '-');
  return kind + formatted(" (task {})", m.task + 1);
}

std::string manoeuvre_text(const ManoeuvreAccount& m) {
  std::string text;
  if (m.executed_s() && m.kind != ManoeuvreKind::spiral)
    text = side_text(m) + " by " + helm_text(m) + ": ";
  std::vector<std::string> parts;
  for (const std::string& part :
       {figures_text(m), absent_text(m), m.approach ? approach_text(*m.approach) : std::string()})
    if (!part.empty()) parts.push_back(part);
  return text + joined(parts, "; ");
}

json manoeuvre_json(const ManoeuvreAccount& m) {
  json absent = json::array();
  for (const twin::AbsentFigure& figure : m.absent)
    absent.push_back({{"figure", figure.name}, {"why", figure.why}});
  json approach;
  if (m.approach)
    approach = {{"speed_m_s", number(m.approach->speed_m_s)},
                {"largest_off_m_s", number(m.approach->most_off_m_s)},
                {"turned_deg", number(m.approach->turned_rad / degree)},
                {"steady", m.approach->is_steady()}};
  const bool has_begun = m.has_begun();
  return {{"task", m.task},
          {"kind", name_of(m.kind)},
          {"began_s", has_begun ? number(m.orders.front().t_s) : json(nullptr)},
          {"executed_s", number(m.executed_s())},
          {"ended_s", has_begun ? number(m.ended_s) : json(nullptr)},
          {"over", m.is_over()},
          {"approach", approach},
          {"helms", helms_json(m)},
          {"figures", figures_json(m)},
          {"absent", absent}};
}

}  // namespace slackwater::api
