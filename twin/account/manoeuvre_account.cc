#include "twin/account/manoeuvre_account.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"
#include "twin/state/mission.h"

namespace slackwater::twin {
namespace {

using constants::degree;
using Rows = std::vector<ManoeuvreRow>;

constexpr double most_between_rows_rad = 20 * degree;
constexpr std::size_t least_rows_of_step = 5;

/// A quantity of the log at its times, where it has numbers.
struct Series {
  std::vector<double> t_s;
  std::vector<double> value;
};

/// Ahead, through the water where that is known.
Series speed_in(const VehicleRows& log) {
  const auto through = log.column("speed_through_water"), over = log.column("velocity_body");
  Series out;
  for (std::size_t i = 0; i < log.t_s.size(); ++i) {
    const double water_m_s = i < through.size() ? through[i] : constants::nan;
    const double ground_m_s = 3 * i < over.size() ? over[3 * i] : constants::nan;
    const double speed_m_s = std::isfinite(water_m_s) ? water_m_s : ground_m_s;
    if (!std::isfinite(speed_m_s)) continue;
    out.t_s.push_back(log.t_s[i]);
    out.value.push_back(speed_m_s);
  }
  return out;
}

Series depth_in(const VehicleRows& log) {
  const auto z = log.column("z");
  Series out;
  for (std::size_t i = 0; i < std::min(log.t_s.size(), z.size()); ++i) {
    if (!std::isfinite(z[i])) continue;
    out.t_s.push_back(log.t_s[i]);
    out.value.push_back(-z[i]);
  }
  return out;
}

/// Without jumps of a whole turn.
Series heading_in(const VehicleRows& log) {
  const auto yaw = log.column("yaw");
  Series out;
  for (std::size_t i = 0; i < std::min(log.t_s.size(), yaw.size()); ++i) {
    if (!std::isfinite(yaw[i])) continue;
    const double before = out.value.empty() ? yaw[i] : out.value.back();
    out.t_s.push_back(log.t_s[i]);
    out.value.push_back(before + wrapped_rad(yaw[i] - before));
  }
  return out;
}

/// Of one vehicle, for all its manoeuvres.
struct LoggedWay {
  explicit LoggedWay(const VehicleRows& log)
      : rows(manoeuvre_rows(log)),
        speed(speed_in(log)),
        depth(depth_in(log)),
        heading(heading_in(log)) {}
  Rows rows;
  Series speed, depth, heading;
};

/// From a time to another, the first value straight between the rows about it.
Series stretch_of(const Series& all, double from_s, double to_s) {
  Series out;
  const auto first = std::lower_bound(all.t_s.begin(), all.t_s.end(), from_s);
  for (auto i = static_cast<std::size_t>(first - all.t_s.begin());
       i < all.t_s.size() && all.t_s[i] <= to_s; ++i) {
    if (out.t_s.empty() && i > 0 && all.t_s[i] > from_s) {
      const double share = (from_s - all.t_s[i - 1]) / (all.t_s[i] - all.t_s[i - 1]);
      out.t_s.push_back(from_s);
      out.value.push_back(all.value[i - 1] + share * (all.value[i] - all.value[i - 1]));
    }
    out.t_s.push_back(all.t_s[i]);
    out.value.push_back(all.value[i]);
  }
  return out;
}

const TaskOrder* order_of(const ManoeuvreAccount& account, Ordered what) {
  for (const TaskOrder& order : account.orders)
    if (order.is(what)) return &order;
  return nullptr;
}

std::optional<ApproachAccount> approach_of(const LoggedWay& way, double began_s,
                                           double executed_s) {
  constexpr double part = 0.2;
  const double from_s = executed_s - part * (executed_s - began_s);
  const Series speed = stretch_of(way.speed, from_s, executed_s);
  const Series heading = stretch_of(way.heading, from_s, executed_s);
  if (speed.value.size() < 2 || heading.value.size() < 2) return std::nullopt;
  ApproachAccount approach;
  for (const double value : speed.value)
    approach.speed_m_s += value / static_cast<double>(speed.value.size());
  for (const double value : speed.value)
    approach.most_off_m_s = std::max(approach.most_off_m_s, std::abs(value - approach.speed_m_s));
  const auto [least, most] = std::minmax_element(heading.value.begin(), heading.value.end());
  approach.turned_rad = *most - *least;
  return approach;
}

/// The rows of a manoeuvre, each with the helm that was in force.
Rows rows_with_helm(const LoggedWay& way, const ManoeuvreAccount& account) {
  Rows rows;
  auto next = account.orders.begin();
  double helm = 0;
  for (ManoeuvreRow row : way.rows) {
    if (row.t_s > account.ended_s) break;
    for (; next != account.orders.end() && next->t_s <= row.t_s; ++next)
      if (next->is(Ordered::helm)) helm = next->value;
    row.helm_rad = helm;
    rows.push_back(row);
  }
  return rows;
}

double turned_from(const Rows& rows, double from_s, double& most_between_rad) {
  double turned_rad = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].t_s <= from_s) continue;
    const double step_rad = wrapped_rad(rows[i].heading_rad - rows[i - 1].heading_rad);
    turned_rad += step_rad;
    most_between_rad = std::max(most_between_rad, std::abs(step_rad));
    // Headings alias beyond half a turn; the rate does not.
    const double by_rate_rad = rows[i].turn_rad_s * (rows[i].t_s - rows[i - 1].t_s);
    most_between_rad = std::max(most_between_rad, std::abs(by_rate_rad));
  }
  return turned_rad;
}

const char* how_it_ended(const ManoeuvreAccount& account) {
  return account.is_over()         ? "ended"
         : account.was_interrupted ? "was interrupted"
                                   : "the run ended";
}

/// "ended at 143 degrees from its approach"
std::string ended_text(const ManoeuvreAccount& account) {
  return formatted("{} at {:.0f} degrees from its approach", how_it_ended(account),
                   std::abs(account.turned_rad) / degree);
}

void say_absent(ManoeuvreAccount& account, const std::string& name, const std::string& why) {
  account.absent.push_back({name, why});
}

void add_circle(const Rows& rows, double executed_s, ManoeuvreAccount& account) {
  const TurningCircle& circle = account.circle.emplace(turning_circle(rows, executed_s));
  const std::string ended = ended_text(account);
  for (const auto& [name, figure] : {std::pair{"advance_m", circle.advance_m},
                                     {"transfer_m", circle.transfer_m},
                                     {"tactical_diameter_m", circle.tactical_diameter_m},
                                     {"quarter_s", circle.quarter_s},
                                     {"half_s", circle.half_s},
                                     {"three_quarters_s", circle.three_quarters_s},
                                     {"full_s", circle.full_s}})
    if (!figure) say_absent(account, name, ended);
  if (!circle.steady)
    say_absent(account, "steady",
               std::abs(account.turned_rad) < 0.5 * constants::pi
                   ? ended
                   : "in its last quarter of a turn the rate was not yet within 2 % of its mean");
}

void add_zig_zag(const Rows& rows, double executed_s, ManoeuvreAccount& account) {
  const ZigZag& found =
      account.zig_zag.emplace(zig_zag(rows, executed_s, account.heading_change_rad));
  const std::size_t wanted = account.legs > 0 ? account.legs - 1 : 0;
  const std::size_t overshoots = found.overshoot_rad.size();
  const std::string ended =
      formatted("{} after {} of {} overshoots", how_it_ended(account), overshoots, wanted);
  if (overshoots < wanted) say_absent(account, "overshoots_deg", ended);
  if (!found.initial_turning_m) say_absent(account, "initial_turning_m", ended);
  if (!found.period_s) say_absent(account, "period_s", ended + ", a period takes 3");
}

/// Helms that a spiral was put to for all their time; those of one angle in a row are one.
void add_spiral(const Rows& rows, double executed_s, ManoeuvreAccount& account) {
  std::vector<TaskOrder> helms;
  for (const TaskOrder& order : account.orders)
    if (order.is(Ordered::helm)) helms.push_back(order);
  const std::size_t begun = helms.size();
  const double until_s = account.is_over() ? account.ended_s : helms.back().t_s;
  if (!account.is_over()) helms.pop_back();
  Rows whole;
  for (const ManoeuvreRow& row : rows)
    if (row.t_s >= executed_s && (account.is_over() || row.t_s < until_s)) whole.push_back(row);
  const Spiral& found = account.spiral.emplace(spiral(whole));
  if (begun < account.legs || !account.is_over())
    say_absent(account, "points",
               formatted("{} at helm {} of {}", how_it_ended(account), begun, account.legs));
  const auto last = std::unique(helms.begin(), helms.end(),
                                [](const auto& a, const auto& b) { return a.value == b.value; });
  const auto unlike = static_cast<std::size_t>(last - helms.begin());
  if (found.points.size() < unlike)
    say_absent(account, "points",
               formatted("{} of {} helms have no row of the log; log more often (log_every_s)",
                         unlike - found.points.size(), unlike));
  if (!found.loop_width_rad)
    say_absent(account, account.by_rudder ? "loop_width_deg" : "loop_width_share",
               "its helms do not take it from one side to the other and back");
  if (!found.loop_height_rad_s)
    say_absent(account, "loop_height_deg_s", "helm 0 is not among its helms on both ways");
}

void add_pull_out(const Rows& rows, ManoeuvreAccount& account) {
  std::vector<double> helms_s;
  for (const TaskOrder& order : account.orders)
    if (order.is(Ordered::helm)) helms_s.push_back(order.t_s);
  const auto is_after = [&](double t_s) {
    return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.t_s > t_s; });
  };
  if (helms_s.size() < 2 || !account.is_over() || !is_after(helms_s[1])) {
    say_absent(account, "residual_turn_deg_s",
               how_it_ended(account) + std::string(helms_s.size() < 2
                                                       ? " before the helm was amidships"
                                                       : " before the turn was steady again"));
    return;
  }
  Rows turn;
  for (const ManoeuvreRow& row : rows)
    if (row.t_s <= helms_s[1]) turn.push_back(row);
  account.pull_out =
      PullOut{residual_turn_rad_s(turn, helms_s[0]), residual_turn_rad_s(rows, helms_s[1])};
}

/// Headings of a step from where it kept the one before, the short way.
StepAccount step_of(const LoggedWay& way, const TaskOrder& before, const TaskOrder& order,
                    double until_s) {
  StepAccount step;
  step.what = static_cast<Ordered>(order.what);
  step.at_s = order.t_s;
  step.from = before.value;
  step.to = order.value;
  step.lasted_s = until_s - order.t_s;
  const Series& all = step.what == Ordered::heading ? way.heading
                      : step.what == Ordered::speed ? way.speed
                                                    : way.depth;
  Series found = stretch_of(all, step.at_s, until_s);
  if (step.what == Ordered::heading) {
    step.to = step.from + wrapped_rad(step.to - step.from);
    // The whole turns that the log has counted by then.
    const double off = found.value.empty() ? 0 : found.value.front() - step.from;
    for (double& value : found.value) value += wrapped_rad(off) - off;
  }
  if (found.t_s.size() >= least_rows_of_step)
    step.response = step_response(found.t_s, found.value, step.from, step.to);
  return step;
}

void add_steps(const LoggedWay& way, ManoeuvreAccount& account) {
  for (const Ordered what : {Ordered::heading, Ordered::speed, Ordered::depth}) {
    std::vector<TaskOrder> of_kind;
    for (const TaskOrder& order : account.orders) {
      if (!order.is(what)) continue;
      // What is ordered as it begins is what it begins with.
      if (!of_kind.empty() && of_kind.back().t_s == order.t_s) of_kind.pop_back();
      of_kind.push_back(order);
    }
    for (std::size_t i = 1; i < of_kind.size(); ++i) {
      if (of_kind[i].value == of_kind[i - 1].value) {
        say_absent(
            account, std::string(name_of(what)) + "_step",
            formatted("what is asked for at {:g} s of the run is kept already", of_kind[i].t_s));
        continue;
      }
      const double until_s = i + 1 < of_kind.size() ? of_kind[i + 1].t_s : account.ended_s;
      account.steps.push_back(step_of(way, of_kind[i - 1], of_kind[i], until_s));
    }
  }
  if (!account.is_over())
    say_absent(account, "steps",
               std::string(how_it_ended(account)) + " before their time was over");
  std::stable_sort(account.steps.begin(), account.steps.end(),
                   [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
}

}  // namespace

bool ApproachAccount::is_steady() const noexcept {
  return most_off_m_s <= 0.02 * std::abs(speed_m_s) && turned_rad <= 2 * degree;
}

bool ManoeuvreAccount::is_over() const noexcept {
  return has_begun() && orders.back().is(Ordered::over);
}

std::optional<double> ManoeuvreAccount::executed_s() const noexcept {
  const TaskOrder* const helm = order_of(*this, Ordered::helm);
  return helm != nullptr ? std::optional(helm->t_s) : std::nullopt;
}

std::vector<ManoeuvreAccount> manoeuvres_of(const Mission& mission, const MissionState& state) {
  std::vector<ManoeuvreAccount> out;
  for (std::size_t i = 0; i < mission.manoeuvres.size(); ++i) {
    const ManoeuvrePlan& plan = mission.manoeuvres[i];
    if (!plan.is_there) continue;
    ManoeuvreAccount& account = out.emplace_back();
    account.task = i;
    account.kind = plan.kind;
    account.by_rudder = plan.by_rudder;
    account.heading_change_rad = plan.heading_change_rad;
    account.legs = plan.legs.size();
    for (const TaskOrder& order : state.orders) {
      if (order.task != static_cast<double>(i)) continue;
      account.orders.push_back(order);
      account.followed_s = order.t_s;
    }
    if (i == state.task && account.has_begun() && !account.is_over())
      account.followed_s = std::max(account.followed_s, state.manoeuvre.last_s);
  }
  return out;
}

namespace {

/// @param between_s  from row to row
void add_way(const LoggedWay& way, double until_s, double between_s, ManoeuvreAccount& account) {
  if (!account.has_begun()) {
    say_absent(account, "all", "it did not come to it");
    return;
  }
  // Within a row of the end it was not: a run ends with a step that it has.
  account.was_interrupted = !account.is_over() && until_s - account.followed_s > between_s;
  account.ended_s = account.is_over() || account.was_interrupted ? account.followed_s : until_s;
  if (account.kind == ManoeuvreKind::steps) return add_steps(way, account);
  const auto executed_s = account.executed_s();
  if (!executed_s) {
    say_absent(account, "all", std::string(how_it_ended(account)) + " in its approach");
    return;
  }
  account.approach = approach_of(way, account.orders.front().t_s, *executed_s);
  if (!account.approach)
    say_absent(account, "approach", "its last fifth has fewer than two rows of the log");
  const Rows rows = rows_with_helm(way, account);
  double most_between_rad = 0;
  account.turned_rad = turned_from(rows, *executed_s, most_between_rad);
  if (most_between_rad > most_between_rows_rad) {
    say_absent(account, "all",
               formatted("the rows of the log are up to {:.0f} degrees of its turn apart, expected "
                         "at most {:.0f}; log {:.0f} times as often (log_every_s)",
                         most_between_rad / degree, most_between_rows_rad / degree,
                         std::ceil(most_between_rad / most_between_rows_rad)));
    return;
  }
  switch (account.kind) {
    case ManoeuvreKind::turning_circle:
      return add_circle(rows, *executed_s, account);
    case ManoeuvreKind::zig_zag:
      return add_zig_zag(rows, *executed_s, account);
    case ManoeuvreKind::spiral:
      return add_spiral(rows, *executed_s, account);
    case ManoeuvreKind::pull_out:
      return add_pull_out(rows, account);
    case ManoeuvreKind::steps:
      return;
  }
}

}  // namespace

void add_rows(const VehicleRows& log, double until_s, std::vector<ManoeuvreAccount>& manoeuvres) {
  if (manoeuvres.empty()) return;
  const LoggedWay way(log);
  const std::size_t rows = log.t_s.size();
  const double between_s = rows > 1 ? log.t_s[rows - 1] - log.t_s[rows - 2] : 0;
  for (ManoeuvreAccount& account : manoeuvres) add_way(way, until_s, between_s, account);
}

}  // namespace slackwater::twin
