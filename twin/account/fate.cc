#include "twin/account/fate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "twin/agent/agent.h"
#include "twin/agent/conduct.h"

namespace slackwater::twin {
namespace {

struct FateWords {
  const char* name;
  const char* words;
};
/// In the order of `Fate`.
constexpr std::array all_fates{
    FateWords{"battery_empty", "battery empty"},
    FateWords{"battery_cut_off", "battery cut off at its least voltage"},
    FateWords{"tether_parted", "its tether parted"},
    FateWords{"turned_over", "turned over"},
    FateWords{"left_depth", "left its depth"},
    FateWords{"fell", "fell"},
    FateWords{"struck_structure", "struck a structure"},
    FateWords{"struck_sea", "struck the sea"},
    FateWords{"aground", "ran aground"},
    FateWords{"capsized", "capsized"},
    FateWords{"slower_than_wind", "made no headway against the wind"},
    FateWords{"slower_than_water", "made no headway against the water"},
    FateWords{"left_area", "left the area of the forecast"},
    FateWords{"forecast_ended", "came to the end of the forecast"},
    FateWords{"no_data", "came where the forecast has no data"},
    FateWords{"diverged", "its calculation diverged"},
    FateWords{"not_recovered", "not recovered"},
};

std::optional<Fate> end_of(const Agent& agent, const AgentState& state) {
  const bool flies = agent.vehicle->kind == VehicleKind::uav;
  switch (state.halt) {
    case Halt::none:
      return std::nullopt;
    case Halt::outside_area:
      return Fate::left_area;
    case Halt::outside_time:
      return Fate::forecast_ended;
    case Halt::aground:
      return Fate::aground;
    case Halt::no_data:
      return Fate::no_data;
    case Halt::struck:
      return flies && state.vehicle.body.position_m.z > 0 ? Fate::struck_sea
                                                          : Fate::struck_structure;
    case Halt::capsized:
      return Fate::capsized;
    case Halt::no_headway:
      return flies ? Fate::slower_than_wind : Fate::slower_than_water;
    case Halt::diverged:
      break;
  }
  return Fate::diverged;
}

}  // namespace

const char* name_of(Fate fate) noexcept { return all_fates[static_cast<std::size_t>(fate)].name; }

const char* words_of(Fate fate) noexcept { return all_fates[static_cast<std::size_t>(fate)].words; }

std::optional<Fate> fate_named(std::string_view name) noexcept {
  for (std::size_t i = 0; i < all_fates.size(); ++i)
    if (all_fates[i].name == name) return static_cast<Fate>(i);
  return std::nullopt;
}

bool is_still_out(const Agent& agent, const AgentState& state) noexcept {
  return agent.conduct != nullptr && state.halt == Halt::none && !state.conduct.has_ended &&
         !state.conduct.is_aboard;
}

std::vector<FateEvent> fate_of(const Agent& agent, const AgentState& state, double ran_s) {
  const Milestones& m = state.milestones;
  const bool flies = agent.vehicle->kind == VehicleKind::uav;
  const bool lost_power = !std::isnan(m.power_lost_s);
  std::vector<FateEvent> events;
  if (lost_power)
    events.push_back(
        {m.is_empty > 0 ? Fate::battery_empty : Fate::battery_cut_off, m.power_lost_s});
  if (!std::isnan(m.line_parted_s)) events.push_back({Fate::tether_parted, m.line_parted_s});
  // One that falls tumbles, which is told by its falling; of one that floats its halt tells.
  const bool fell_first = flies && lost_power && m.capsized_s >= m.power_lost_s;
  if (!std::isnan(m.capsized_s) && state.halt != Halt::capsized && !fell_first)
    events.push_back({Fate::turned_over, m.capsized_s});
  if (!std::isnan(m.left_depth_s)) events.push_back({Fate::left_depth, m.left_depth_s});
  std::stable_sort(events.begin(), events.end(),
                   [](const FateEvent& a, const FateEvent& b) { return *a.at_s < *b.at_s; });
  if (flies && !events.empty() && (lost_power || state.halt == Halt::struck))
    events.push_back({Fate::fell, std::nullopt});
  if (const auto end = end_of(agent, state))
    events.push_back({*end, state.halted_at_s});
  else if (is_still_out(agent, state))
    events.push_back({Fate::not_recovered, ran_s});
  return events;
}

std::optional<double> time_of(std::span<const FateEvent> events, Fate what) noexcept {
  for (const FateEvent& event : events)
    if (event.what == what) return event.at_s;
  return std::nullopt;
}

std::string fate_text(std::span<const FateEvent> events, UtcTime start,
                      std::string_view structure) {
  std::string text;
  for (const FateEvent& event : events) {
    text += (text.empty() ? "" : " \u2192 ") + std::string(words_of(event.what));
    if (event.what == Fate::struck_structure && !structure.empty())
      text += " (" + std::string(structure) + ")";
    if (!event.at_s) continue;
    const auto passed = Duration(static_cast<Duration::rep>(std::floor(*event.at_s)) * 1000);
    constexpr std::size_t date = 11;  // 2025-06-01T
    text += " at " + format_utc(start + passed).substr(date);
  }
  return text;
}

}  // namespace slackwater::twin
