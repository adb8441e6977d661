#include "api/door/live/topics/alarm_publisher.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/door/dds/message/vehicle_messages.h"

namespace slackwater::live {
namespace {

bool is_lost(const twin::Alarm& alarm) { return alarm.status == twin::AlarmStatus::lost; }

}  // namespace

AlarmPublisher::AlarmPublisher(Stream& stream, const RunPlace& place,
                               const twin::TrafficWatch& watch,
                               std::span<const twin::TrafficVessel> vessels)
    : stream_(stream), place_(place), watch_(watch), vessels_(vessels) {}

void AlarmPublisher::open(const std::string& name) {
  vehicles_.push_back(
      {stream_.open("/" + name + "/cpa_alarms", "std_msgs/msg/String", latched_quality), {}});
}

std::string AlarmPublisher::json_of(std::span<const twin::Alarm> alarms) const {
  nlohmann::json all = nlohmann::json::array();
  for (const twin::Alarm& alarm : alarms) {
    const auto vessel = std::find_if(vessels_.begin(), vessels_.end(),
                                     [&](const auto& other) { return other.id == alarm.id; });
    all.push_back({{"mmsi", alarm.id},
                   {"name", vessel == vessels_.end() ? "" : vessel->name},
                   {"cpa_m", alarm.approach.distance_m},
                   {"tcpa_s", alarm.approach.time_s},
                   {"is_lost", is_lost(alarm)}});
  }
  // What a vessel calls itself may be no UTF-8.
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void AlarmPublisher::speak(double t_s) {
  const auto& of_each = watch_.state().alarms;
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    std::span<const twin::Alarm> alarms;
    if (i < of_each.size()) alarms = of_each[i];
    Told now;
    for (const twin::Alarm& alarm : alarms) now.emplace_back(alarm.id, is_lost(alarm));
    Vehicle& vehicle = vehicles_[i];
    if (vehicle.told == now) continue;
    vehicle.told = std::move(now);
    stream_.publish(vehicle.channel, dds::stamp_of(place_.epoch, t_s), dds::text(json_of(alarms)));
  }
}

}  // namespace slackwater::live
