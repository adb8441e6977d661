#include "twin/account/mission_event.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/agent/conduct.h"

namespace slackwater::twin {
namespace {

std::string text_of(const ConductEvent& event, const Agent& agent) {
  const auto because = [&](const char* what) {
    std::string text = std::string(what) + ": " + words_of(agent, event.cause, event.detail);
    if (event.cause == Cause::limit)
      text += std::isnan(event.value) ? std::string(", found no value")
                                      : formatted(", found {:.3g}", event.value);
    return text;
  };
  switch (event.kind) {
    case ConductEventKind::phase_began:
      return name_of(static_cast<Phase>(event.detail));
    case ConductEventKind::hold_began:
      return because("holds");
    case ConductEventKind::went_back:
      return "goes back to where it left off";
    case ConductEventKind::resumed:
      return "resumes";
    case ConductEventKind::turned_for_home:
      return because("comes home");
    case ConductEventKind::came_home:
      return "home";
    case ConductEventKind::came_aboard:
      return "aboard";
    case ConductEventKind::launched:
      return "launched";
    case ConductEventKind::fault_began:
    case ConductEventKind::fault_ended:
      return std::string(event.kind == ConductEventKind::fault_began ? "fault: " : "over: ") +
             name_of(agent.conduct->plan.faults[event.detail].kind);
    case ConductEventKind::finished:
      return "finished";
    case ConductEventKind::gave_up:
      return "gave up";
    case ConductEventKind::found:
      return formatted("finds who it looks for, {:.0f} m off", event.value);
  }
  return "";
}

std::optional<double> value_of(const ConductEvent& event) {
  const bool has_one = event.cause == Cause::limit || event.kind == ConductEventKind::found;
  return has_one && std::isfinite(event.value) ? std::optional(event.value) : std::nullopt;
}

bool is_end(const MissionEvent& event) {
  return event.kind == ConductEventKind::finished || event.kind == ConductEventKind::gave_up;
}

bool leaves_task(const MissionEvent& event) {
  return event.kind == ConductEventKind::hold_began ||
         event.kind == ConductEventKind::turned_for_home;
}

/// What an event makes a vehicle do from then on; nothing: the same as before.
std::optional<std::string> doing_after(const MissionEvent& event) {
  switch (event.kind) {
    case ConductEventKind::hold_began:
      return "holds";
    case ConductEventKind::went_back:
      return "goes back";
    case ConductEventKind::resumed:
      return "";
    case ConductEventKind::turned_for_home:
      return "comes home";
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string words_of(const Agent& agent, Cause cause, std::size_t detail) {
  switch (cause) {
    case Cause::limit:
      return "limit: " + text_of(agent.conduct->plan.limits[detail]);
    case Cause::reserve:
      return "energy for the way home";
    case Cause::link:
      return "lost link";
    case Cause::gnss:
      return "lost GNSS";
    case Cause::thruster:
      return "lost thruster";
    case Cause::tether:
      return "fouled tether";
    case Cause::held_too_long:
      return "held too long";
    case Cause::carrier:
      return "its carrier turned for home or went no further";
    case Cause::mammal:
      return "marine mammal in the zone";
    case Cause::no_watch:
      return "nobody has watched the zone for long enough";
    case Cause::none:
      break;
  }
  return "nothing";
}

std::vector<MissionEvent> mission_events_of(const Agent& agent, const ConductState& own) {
  std::vector<MissionEvent> events;
  for (const ConductEvent& event : own.events)
    events.push_back({event.t_s, event.kind, event.cause, text_of(event, agent), value_of(event)});
  return events;
}

std::vector<MissionStretch> stretches_of(std::span<const MissionEvent> events, double ran_s) {
  std::vector<MissionStretch> stretches;
  std::optional<MissionStretch> now;
  const auto end = [&](double t_s) {
    if (now && t_s > now->from_s) {
      now->to_s = t_s;
      stretches.push_back(*now);
    }
  };
  for (const MissionEvent& event : events) {
    const auto doing = doing_after(event);
    if (!doing && event.kind != ConductEventKind::phase_began && !is_end(event)) continue;
    end(event.t_s);
    if (is_end(event)) return stretches;
    if (!now) now = MissionStretch{};
    now->from_s = event.t_s;
    if (doing)
      now->doing = *doing;
    else
      now->phase = event.text;
  }
  end(ran_s);
  return stretches;
}

std::optional<MissionEnd> mission_end_of(std::span<const MissionEvent> events, double ran_s) {
  if (events.empty()) return std::nullopt;
  const MissionEvent* away = nullptr;
  for (const MissionEvent& event : events) {
    if (is_end(event)) {
      const bool is_done = event.kind == ConductEventKind::finished && event.cause == Cause::none;
      return MissionEnd{event.t_s, is_done, is_done ? "" : away ? away->text : event.text};
    }
    if (leaves_task(event)) away = &event;
    if (event.kind == ConductEventKind::resumed) away = nullptr;
  }
  return MissionEnd{ran_s, false, away != nullptr ? away->text : "was still at work"};
}

bool are_out(std::span<const MissionEvent> events) noexcept {
  bool is_out = !events.empty();
  for (const MissionEvent& event : events) {
    if (is_end(event)) return false;
    if (event.kind == ConductEventKind::came_aboard) is_out = false;
    if (event.kind == ConductEventKind::launched) is_out = true;
  }
  return is_out;
}

Interventions interventions_of(std::span<const MissionEvent> events, double ran_s) {
  Interventions all;
  std::optional<double> away_since_s;
  const auto come_back = [&](double t_s) {
    if (!away_since_s) return;
    const double away_s = t_s - *away_since_s;
    all.away_s += away_s;
    all.longest_away_s = std::max(all.longest_away_s, away_s);
    away_since_s.reset();
  };
  for (const MissionEvent& event : events) {
    if (leaves_task(event)) {
      ++all.count;
      if (event.cause == Cause::limit) ++all.limit_violations;
      if (!away_since_s) away_since_s = event.t_s;
    } else if (event.kind == ConductEventKind::resumed || is_end(event)) {
      come_back(event.t_s);
    }
  }
  come_back(ran_s);
  return all;
}

}  // namespace slackwater::twin
