#include "api/rehearse/mission_timeline.h"

#include <cmath>

#include "api/rehearse/fate.h"

namespace slackwater::api {
namespace {

/// What an event makes a vehicle do from then on; nothing: the same as before.
std::optional<std::string> doing_after(const MissionEvent& event) {
  if (event.kind == "hold_began") return "holds";
  if (event.kind == "went_back") return "goes back";
  if (event.kind == "resumed") return "";
  if (event.kind == "turned_for_home") return "comes home";
  return std::nullopt;
}

bool is_end(const MissionEvent& event) {
  return event.kind == "finished" || event.kind == "gave_up";
}

std::string clock_text(const ingest::TrajectoryFile& log, double t_s) {
  constexpr std::size_t time_of_day = 11;  // behind 2025-06-01T
  const auto whole = Duration(static_cast<Duration::rep>(std::floor(t_s)) * 1000);
  return format_utc(log.epoch + whole).substr(time_of_day, 5) + " UTC";
}

}  // namespace

std::vector<MissionStretch> stretches_of(const std::vector<MissionEvent>& events,
                                         std::size_t vehicle, double log_ends_s) {
  std::vector<MissionStretch> stretches;
  std::optional<MissionStretch> now;
  const auto end = [&](double t_s) {
    if (now && t_s > now->from_s) {
      now->to_s = t_s;
      stretches.push_back(*now);
    }
  };
  for (const MissionEvent& event : events) {
    if (event.vehicle != vehicle) continue;
    const auto doing = doing_after(event);
    if (!doing && event.kind != "phase_began" && !is_end(event)) continue;
    end(event.t_s);
    if (is_end(event)) return stretches;
    if (!now) now = MissionStretch{};
    now->from_s = event.t_s;
    if (doing)
      now->doing = *doing;
    else
      now->phase = event.text;
  }
  end(log_ends_s);
  return stretches;
}

std::optional<MissionEnd> mission_end_of(const std::vector<MissionEvent>& events,
                                         std::size_t vehicle, double log_ends_s) {
  bool has_events = false;
  std::optional<MissionEvent> away;
  for (const MissionEvent& event : events) {
    if (event.vehicle != vehicle) continue;
    has_events = true;
    if (is_end(event)) {
      const bool is_done = event.kind == "finished" && event.cause == "none";
      return MissionEnd{event.t_s, is_done, is_done ? "" : away ? away->text : event.text};
    }
    if (event.kind == "hold_began" || event.kind == "turned_for_home") away = event;
    if (event.kind == "resumed") away.reset();
  }
  if (!has_events) return std::nullopt;
  return MissionEnd{log_ends_s, false, away ? away->text : "was still at work"};
}

std::string mission_headline(const ingest::TrajectoryFile& log,
                             const std::vector<MissionEvent>& events, bool& is_done) {
  std::string done, not_done;
  is_done = true;
  for (std::size_t i = 0; i < log.names.size(); ++i) {
    const auto end = mission_end_of(events, i, log.t_s.back());
    if (!end) continue;
    is_done = is_done && end->is_done;
    if (!end->is_done && !fate_in(log, i).empty()) continue;  // which says it already
    const std::string when = clock_text(log, end->t_s);
    if (end->is_done)
      done += (done.empty() ? "" : ", ") + log.names[i] + " by " + when;
    else
      not_done +=
          (not_done.empty() ? "" : "; ") + log.names[i] + ": " + end->why + " (ended " + when + ")";
  }
  std::string text = not_done.empty() ? "" : "Not done: " + not_done + ".";
  if (!done.empty()) text += (text.empty() ? "" : " ") + std::string("Done: ") + done + ".";
  return text;
}

}  // namespace slackwater::api
