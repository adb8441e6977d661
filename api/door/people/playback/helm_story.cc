#include "api/door/people/playback/helm_story.h"

#include <algorithm>

namespace slackwater::people {
namespace {

using twin::HelmCause;
using twin::HelmMode;

/// Lets time, people and commands do what they did, and keeps what came of it.
class Teller {
 public:
  explicit Teller(const twin::HelmRule& rule) : rule_(rule) { story_.push_back(now_); }

  [[nodiscard]] std::vector<LoggedHelm> take() { return std::move(story_); }

  /// What comes of nobody's speaking to it.
  void pass(double until_s) {
    for (double at_s = ends_s(); at_s <= until_s; at_s = ends_s()) {
      const twin::HelmDue due =
          twin::helm_due(rule_, now_.mode, now_.cause, since_s_, renewed_s_, at_s);
      if (due.mode == now_.mode) return;
      begin(due.mode, due.cause, at_s);
    }
  }

  void tell(const twin::Command& command, double at_s) {
    pass(at_s);
    if (std::holds_alternative<twin::Reroute>(command.what))
      begin(HelmMode::waypoints, HelmCause::asked, at_s);
    else if (std::holds_alternative<twin::SetVelocity>(command.what))
      begin(HelmMode::velocity, HelmCause::asked, at_s);
    else if (std::holds_alternative<twin::SetThrusters>(command.what))
      begin(HelmMode::thrusters, HelmCause::asked, at_s);
    else if (std::holds_alternative<twin::SetActuators>(command.what))
      begin(HelmMode::actuators, HelmCause::asked, at_s);
    else if (std::holds_alternative<twin::GoHome>(command.what))
      begin(HelmMode::home, HelmCause::asked, at_s);
    else if (std::holds_alternative<twin::Resume>(command.what) && now_.mode != HelmMode::own)
      begin(HelmMode::own, HelmCause::asked, at_s);
    else if (const auto* hold = std::get_if<twin::HoldHere>(&command.what))
      tell_to_hold(hold->is_client_lost, at_s);
  }

  /// A row of the record that is of this vehicle, or of a whole seat.
  void tell(const Action& row) {
    if (!row.is_taken) return;
    pass(row.time_s);
    if (row.vehicle.empty())
      tell_of_seat(row);
    else
      tell_of_helm(row);
    keep(row.time_s);
  }

 private:
  [[nodiscard]] double ends_s() const {
    if (twin::must_be_renewed(now_.mode)) return renewed_s_ + rule_.renewal_s;
    const bool is_for_want = now_.mode == HelmMode::hold && (now_.cause == HelmCause::not_renewed ||
                                                             now_.cause == HelmCause::client_lost);
    return is_for_want && rule_.home_after_s > 0 ? since_s_ + rule_.home_after_s
                                                 : std::numeric_limits<double>::infinity();
  }
  void begin(HelmMode mode, HelmCause cause, double at_s) {
    if (mode != now_.mode || cause != now_.cause) since_s_ = at_s;
    renewed_s_ = at_s;
    now_.mode = mode;
    now_.cause = cause;
    keep(at_s);
  }
  /// Whoever flies its own mission, or is on its way home, needs nobody.
  void tell_to_hold(bool is_client_lost, double at_s) {
    if (!is_client_lost) return begin(HelmMode::hold, HelmCause::asked, at_s);
    if (now_.mode == HelmMode::own || now_.mode == HelmMode::home) return;
    begin(HelmMode::hold, HelmCause::client_lost, at_s);
  }

  void hold(const Action& row) {
    now_.phase = HelmPhase::held;
    now_.holder = row.who;
    seat_ = row.seat;
    now_.asker.clear();
    asker_seat_ = 0;
    now_.is_raw = false;
  }
  void free() {
    now_.phase = HelmPhase::free;
    now_.holder.clear();
    now_.asker.clear();
    seat_ = asker_seat_ = 0;
    now_.is_raw = false;
  }
  void end_request() {
    now_.asker.clear();
    asker_seat_ = 0;
    if (now_.phase == HelmPhase::requested)
      now_.phase = now_.holder.empty() ? HelmPhase::free : HelmPhase::held;
  }

  void tell_of_helm(const Action& row) {
    const std::string& what = row.what;
    const bool is_loss = what.starts_with("link lost");
    // It was not heard for a while, and then it was: that leaves no row of its own.
    if (!is_loss && row.seat == seat_ && now_.phase == HelmPhase::lost)
      now_.phase = HelmPhase::held;
    const bool is_end =
        what == "lease over" || what == "helm ended" || (what == "give_back" && row.seat == seat_);
    // A supervisor's HOLD takes the helm.
    const bool is_taken =
        what == "helm got" || what == "take_back" || (is_order(what) && row.seat != seat_);
    if (is_end) return free();
    if (is_taken) return hold(row);
    if (what == "ask") {
      if (row.after == name_of(HelmPhase::held) && row.seat != seat_) return hold(row);
      if (row.after != name_of(HelmPhase::requested)) return;
      now_.phase = HelmPhase::requested;
      now_.asker = row.who;
      asker_seat_ = row.seat;
    } else if (what == "grant") {
      Action asker = row;
      asker.who = now_.asker;
      asker.seat = asker_seat_;
      hold(asker);
    } else if (what == "deny" || what == "give_back" || what == "request lapsed") {
      end_request();
    } else if (what == "raw") {
      now_.is_raw = row.after == "raw thrusters";
    } else if (is_loss) {
      now_.is_raw = false;
      if (now_.phase != HelmPhase::requested) now_.phase = HelmPhase::lost;
    }
  }
  void tell_of_seat(const Action& row) {
    if (row.what == "leave" && row.seat == asker_seat_) end_request();
    if (row.seat == 0 || row.seat != seat_) return;
    if (row.what == "leave") return free();
    if (now_.phase == HelmPhase::requested) return;
    if (row.what == "cut_off") now_.phase = HelmPhase::lost;
    if (row.what == "come_back") now_.phase = HelmPhase::held;
  }
  static bool is_order(const std::string& what) {
    return what == "hold" || what == "home" || what == "resume" || what == "waypoints";
  }

  void keep(double at_s) {
    if (now_.is_like(story_.back())) return;
    now_.from_s = at_s;
    if (story_.back().from_s == at_s)
      story_.back() = now_;
    else
      story_.push_back(now_);
  }

  twin::HelmRule rule_;
  LoggedHelm now_;
  unsigned seat_ = 0, asker_seat_ = 0;
  double since_s_ = 0, renewed_s_ = 0;
  std::vector<LoggedHelm> story_;
};

}  // namespace

std::vector<LoggedHelm> helm_story(const StoryOf& of, std::span<const Action> actions,
                                   std::span<const twin::Command> commands, double step_s) {
  Teller teller(of.rule);
  auto action = actions.begin();
  const auto tell_actions_before = [&](double time_s) {
    for (; action != actions.end() && action->time_s <= time_s; ++action)
      if (action->vehicle.empty() || action->vehicle == of.name) teller.tell(*action);
  };
  for (const twin::Command& command : commands) {
    const double at_s = static_cast<double>(command.step) * step_s;
    if (command.agent != of.vehicle || at_s > of.until_s) continue;
    tell_actions_before(at_s);
    teller.tell(command, at_s);
  }
  tell_actions_before(std::numeric_limits<double>::infinity());
  teller.pass(of.until_s);
  return teller.take();
}

}  // namespace slackwater::people
