#include "api/log/helm_turns.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <utility>

namespace slackwater::api {
namespace {

using store::SessionAction;

/// Nothing: the clock was set back.
std::optional<double> seconds_between(UtcTime from, UtcTime to) {
  const double s = std::chrono::duration<double>(to - from).count();
  return s < 0 ? std::nullopt : std::optional(s);
}

class Walk {
 public:
  explicit Walk(HelmHistory& history) : history_(history) {}

  void take(const SessionAction& action) {
    if (action.what == "cut_off") return leave_alone(action);
    if (action.what == "come_back") return come_back(action);
    if (action.what == "leave") return leave(action);
    if (action.vehicle.empty()) return;
    Helm& helm = helms_[action.vehicle];
    if (!action.is_taken) {
      if (action.what == "ask") ++history_.asked_in_vain[{action.seat, action.vehicle}];
      return;
    }
    if (is_command(action)) note_command(helm, action);
    take_of_helm(helm, action);
  }
  void end(double ran_s) {
    for (auto& [vehicle, helm] : helms_) {
      let_go(helm, ran_s);
      end_request(vehicle, helm);
    }
  }

 private:
  struct Request {
    unsigned seat = 0;
    UtcTime at;
  };
  struct Helm {
    std::optional<std::size_t> turn;  ///< under way
    bool is_there = false;            ///< its last stretch is open
    std::optional<Request> request;
    bool is_given = false;  ///< nobody has it, as its holder let it go; who asks goes on asking
  };

  [[nodiscard]] bool holds(const Helm& helm, unsigned seat) const {
    return helm.turn && history_.turns[*helm.turn].seat == seat;
  }

  void take_of_helm(Helm& helm, const SessionAction& action) {
    const std::string& what = action.what;
    const bool is_own = holds(helm, action.seat);
    if (what == "ask" && !is_own) {
      if (action.after != "requested") {
        get(helm, action, action.seat);
      } else if (!helm.request) {
        helm.request = Request{action.seat, action.at};
        helm.is_given = false;  // whoever has it, an agent say, has it still
      }
    } else if (what == "grant" && helm.request) {
      get(helm, action, helm.request->seat);
    } else if (what == "helm got") {
      const bool was_given = helm.is_given;
      get(helm, action, action.seat).was_taken = !was_given;
    } else if (what == "deny" || what == "request lapsed") {
      end_request(action.vehicle, helm);
    } else if (what == "give_back" && !is_own) {
      if (helm.request && helm.request->seat == action.seat) end_request(action.vehicle, helm);
    } else if (what == "give_back" || what == "lease over" || what == "helm ended") {
      if (is_own) let_go(helm, action.time_s);
    } else if (what == "take_back" || (what == "hold" && action.role == "supervisor")) {
      if (!is_own) take_over(helm, action);
    } else if (is_command(action) && !is_own && !what.ends_with("_end")) {
      // Whoever is obeyed has the helm: got with a take-back whose hold was refused, say.
      take_over(helm, action).was_taken = false;
    } else if (what.starts_with("link lost")) {
      ++history_.links_lost[{action.seat, action.vehicle}];
    }
  }

  /// Of a seat that asked for it, now or before.
  HelmTurn& get(Helm& helm, const SessionAction& action, unsigned seat) {
    const bool has_waited = helm.request && helm.request->seat == seat;
    const UtcTime asked_at = has_waited ? helm.request->at : action.at;
    const bool is_known = has_waited || action.what == "ask";
    if (has_waited) helm.request.reset();
    HelmTurn& turn = begin(helm, action, seat);
    turn.was_asked_for = true;
    if (is_known) turn.asked_to_had_s = seconds_between(asked_at, action.at);
    return turn;
  }
  /// With a command, so that there is no first one to wait for.
  HelmTurn& take_over(Helm& helm, const SessionAction& action) {
    HelmTurn& turn = begin(helm, action, action.seat);
    turn.was_taken = action.before != "free";
    turn.has_command = true;
    return turn;
  }
  HelmTurn& begin(Helm& helm, const SessionAction& action, unsigned seat) {
    let_go(helm, action.time_s);
    end_request(action.vehicle, helm);
    helm.turn = history_.turns.size();
    helm.is_there = true;
    helm.is_given = false;
    HelmTurn& turn = history_.turns.emplace_back();
    turn.seat = seat;
    turn.vehicle = action.vehicle;
    turn.had_at = action.at;
    turn.there.push_back({action.time_s, action.time_s});
    return turn;
  }
  void let_go(Helm& helm, double t_s) {
    close(helm, t_s);
    helm.turn.reset();
    helm.is_given = true;
  }
  void close(Helm& helm, double t_s) {
    if (helm.turn && std::exchange(helm.is_there, false)) {
      Stretch& last = history_.turns[*helm.turn].there.back();
      last.to_s = std::max(last.from_s, t_s);
    }
  }
  void end_request(const std::string& vehicle, Helm& helm) {
    if (helm.request) ++history_.asked_in_vain[{helm.request->seat, vehicle}];
    helm.request.reset();
  }
  void note_command(const Helm& helm, const SessionAction& action) {
    // The end of sticks comes a moment after the last of them.
    if (!holds(helm, action.seat) || action.what.ends_with("_end")) return;
    HelmTurn& turn = history_.turns[*helm.turn];
    if (std::exchange(turn.has_command, true)) return;
    turn.had_to_command_s = seconds_between(turn.had_at, action.at);
  }

  void leave_alone(const SessionAction& action) {
    for (auto& [vehicle, helm] : helms_)
      if (holds(helm, action.seat)) close(helm, action.time_s);
  }
  void come_back(const SessionAction& action) {
    for (auto& [vehicle, helm] : helms_) {
      if (!holds(helm, action.seat) || std::exchange(helm.is_there, true)) continue;
      history_.turns[*helm.turn].there.push_back({action.time_s, action.time_s});
    }
  }
  void leave(const SessionAction& action) {
    for (auto& [vehicle, helm] : helms_) {
      if (helm.request && helm.request->seat == action.seat) end_request(vehicle, helm);
      if (holds(helm, action.seat)) let_go(helm, action.time_s);
    }
  }

  HelmHistory& history_;
  std::map<std::string, Helm> helms_;
};

}  // namespace

bool is_command(const SessionAction& action) noexcept {
  static constexpr std::array<std::string_view, 10> commands{
      "stick",     "stick_end", "thrusters", "thrusters_end", "waypoints",
      "take_back", "hold",      "home",      "resume",        "camera"};
  return std::find(commands.begin(), commands.end(), action.what) != commands.end();
}

HelmHistory helm_history_of(std::span<const SessionAction> actions, double ran_s) {
  HelmHistory history;
  Walk walk(history);
  for (const SessionAction& action : actions) walk.take(action);
  walk.end(ran_s);
  return history;
}

}  // namespace slackwater::api
