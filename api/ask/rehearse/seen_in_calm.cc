#include "api/ask/rehearse/seen_in_calm.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>

#include "api/program/paths.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/scenario/write_scenario.h"

namespace slackwater::api {
namespace {

bool asks(const twin::Scenario& scenario) {
  for (const twin::ScenarioVehicle& vehicle : scenario.vehicles) {
    if (!vehicle.conduct || !vehicle.conduct->inspection) continue;
    for (const twin::InspectionLine& line : vehicle.conduct->inspection->lines)
      if (line.seen_at > 0) return true;
  }
  return false;
}

/// What cannot even be set up in still water shows nothing here: it is told where it is set up in
/// its own.
twin::CalmFlight flown_if_it_can_be(const twin::Scenario& calm, const twin::Surround& surround) {
  try {
    return twin::fly_in_calm(calm, surround, twin::CalmEnd::seen);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::invalid_input) throw;
    return {};
  }
}

/// Flights of this process, by the text of what was flown: windows ask for the same task at many
/// starts, a service day after day.
class Flown {
 public:
  twin::CalmFlight of(const twin::Scenario& calm) {
    const std::string text = twin::write_scenario(calm);
    std::shared_ptr<Slot> slot = slot_of(text);
    const std::lock_guard one(slot->mutex);
    if (!slot->flight) {
      twin::Surround surround;
      surround.site = calm.origin;
      surround.data_folder = data_folder();
      slot->flight = flown_if_it_can_be(calm, surround);
    }
    return *slot->flight;
  }

 private:
  struct Slot {
    std::mutex mutex;
    std::optional<twin::CalmFlight> flight;
  };
  std::shared_ptr<Slot> slot_of(const std::string& text) {
    constexpr std::size_t most = 256;
    const std::lock_guard one(mutex_);
    if (slots_.size() >= most && !slots_.contains(text)) slots_.clear();
    std::shared_ptr<Slot>& slot = slots_[text];
    if (!slot) slot = std::make_shared<Slot>();
    return slot;
  }

  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Slot>> slots_;
};

}  // namespace

std::optional<twin::CalmFlight> calm_flight_of(const LoadedMission& mission) {
  static Flown flown;
  twin::Scenario calm = twin::in_dead_calm(mission.scenario, mission.expanded.workers,
                                           mission.expanded.water_depth_m);
  // When it is flown changes nothing.
  calm.start = parse_utc("2000-01-01T00:00:00Z");
  calm.name = "calm";
  if (!asks(calm)) return std::nullopt;
  return flown.of(calm);
}

std::string unseen_in_calm(const LoadedMission& mission) {
  if (mission.expanded.is_thinned) return "";
  const std::optional<twin::CalmFlight> flight = calm_flight_of(mission);
  if (!flight || !flight->is_flown_out) return "";
  const auto lacks = [](const twin::CalmLook& look) { return look.asked - look.covered; };
  const auto worst =
      std::max_element(flight->looks.begin(), flight->looks.end(),
                       [&](const auto& a, const auto& b) { return lacks(a) < lacks(b); });
  if (worst == flight->looks.end() || worst->is_seen()) return "";
  return formatted(
      "{}: flown in dead calm its {} covers {:.3g} % of {}, expected at least {:g} % (seen_at of "
      "its look): {}",
      worst->vehicle, worst->instrument, 100 * worst->covered, worst->surfaces, 100 * worst->asked,
      worst->why);
}

void expect_seen_in_calm(const LoadedMission& mission) {
  if (const std::string why = unseen_in_calm(mission); !why.empty())
    throw Error(ErrorKind::invalid_input, why);
}

}  // namespace slackwater::api
