#include "api/door/live/bag_traffic.h"

#include <cmath>
#include <map>

#include "api/door/dds/message/orders.h"
#include "api/door/live/bag_clock.h"
#include "data/bag/bag.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/agent.h"

namespace slackwater::live {
namespace {

constexpr std::uint32_t first_mmsi = 980'000'001;
constexpr double every_s = 1;  ///< more often than vessels report

/// "NAME" of a topic "/NAME/ending"; nothing of others.
std::optional<std::string> name_before(const std::string& topic, const std::string& ending) {
  const std::string after = "/" + ending;
  if (!topic.starts_with('/') || !topic.ends_with(after) || topic.size() <= after.size() + 1)
    return std::nullopt;
  return topic.substr(1, topic.size() - after.size() - 1);
}

/// Which channels tell where somebody is: of each name the pose, else the odometry.
struct Teller {
  std::size_t channel = 0;
  bool is_pose = false;
};
std::map<std::string, Teller> tellers_of(const bag::Bag& bag) {
  std::map<std::string, Teller> tellers;
  for (std::size_t i = 0; i < bag.channels().size(); ++i) {
    const bag::Channel& channel = bag.channels()[i];
    if (const auto name = name_before(channel.topic, "pose");
        name && channel.type == "geometry_msgs/msg/PoseStamped")
      tellers[*name] = {i, true};
    else if (const auto odometer = name_before(channel.topic, "odometry");
             odometer && channel.type == "nav_msgs/msg/Odometry")
      tellers.try_emplace(*odometer, Teller{i, false});
  }
  return tellers;
}

/// Positions in another type, which people take for those.
std::string found_instead(const bag::Bag& bag) {
  std::string text;
  for (const bag::Channel& channel : bag.channels())
    if (name_before(channel.topic, "pose") || name_before(channel.topic, "odometry"))
      text += (text.empty() ? "; found " : ", ") + channel.topic + " as " + channel.type;
  return text;
}

twin::Triple<double> place_in(const bag::Recorded& message, bool is_pose) {
  const twin::Triple<double> place_m = is_pose ? dds::place_in_pose(message.payload).position_m
                                               : dds::place_in_odometry(message.payload).position_m;
  for (const double part_m : {place_m.x, place_m.y, place_m.z}) {
    if (std::abs(part_m) <= twin::farthest_from_origin_m) continue;  // what is no number is not
    throw Error(
        ErrorKind::invalid_input,
        formatted("found a place of north {:g}, east {:g}, down {:g} m; expected numbers of "
                  "at most {:g} m from the origin of the run; leave the topic out of the "
                  "bag, or give the scenario the origin that it was recorded about",
                  place_m.x, place_m.y, place_m.z, twin::farthest_from_origin_m));
  }
  return place_m;
}

/// The files of a bag by their checksums, so that a log says what passed by.
std::string checksums_of(const std::filesystem::path& bag) {
  if (!std::filesystem::is_directory(bag))
    return bag.filename().string() + " " + sha256_of_file(bag);
  std::map<std::string, std::string> sums;
  for (const auto& entry : std::filesystem::directory_iterator(bag))
    if (entry.is_regular_file())
      sums[entry.path().filename().string()] = sha256_of_file(entry.path());
  std::string text;
  for (const auto& [name, sum] : sums)
    text += (text.empty() ? "" : ", ") + bag.filename().string() + "/" + name + " " + sum;
  return text;
}

}  // namespace

void add_bag_traffic(const std::filesystem::path& path, const twin::Scenario& scenario,
                     api::ScenarioWater& water) {
  const auto bag = bag::open_bag(path);
  const std::map<std::string, Teller> tellers = tellers_of(*bag);
  if (tellers.empty()) {
    throw Error(ErrorKind::invalid_input,
                path.string() +
                    ": found no positions of vehicles; expected topics like /rov/pose "
                    "(geometry_msgs/msg/PoseStamped) or /rov/odometry" +
                    found_instead(*bag));
  }
  std::map<std::size_t, std::string> names;
  for (const auto& [name, teller] : tellers) names[teller.channel] = name;
  std::map<std::string, std::vector<twin::TrackPoint>> tracks;
  BagClock clock(scenario.duration_s);
  while (const auto message = bag->next()) {
    const auto name = names.find(message->channel);
    const bool is_used = name != names.end();
    const double t_s = clock.time_s(*message, bag->channels()[message->channel].topic, is_used);
    if (!is_used) continue;
    if (t_s > scenario.duration_s + every_s) break;
    std::vector<twin::TrackPoint>& track = tracks[name->second];
    if (!track.empty() && t_s < track.back().t_s + every_s) continue;
    const auto place_m = with_context(
        formatted("{}, topic {}, the message of {} ns ({:g} s from its first)", path.string(),
                  bag->channels()[message->channel].topic, message->log_time_ns, t_s),
        [&] { return place_in(*message, tellers.at(name->second).is_pose); });
    track.push_back({t_s, place_m, std::nullopt, std::nullopt});
  }
  if (tracks.empty())
    throw Error(ErrorKind::invalid_input,
                formatted("{}: found no position of a vehicle within the {:g} s of the run; make "
                          "the run longer, or cut the bag",
                          path.string(), scenario.duration_s));
  if (const std::string words = clock.left_out(); !words.empty())
    water.warnings.push_back(path.string() + ": " + words);
  std::uint32_t mmsi = first_mmsi;
  for (auto& [name, track] : tracks) {
    twin::TrafficVessel vessel;
    vessel.id = mmsi++;
    vessel.name = name;
    vessel.track = twin::Track(std::move(track));
    water.surround.vessels.push_back(std::move(vessel));
  }
  water.warnings.insert(water.warnings.end(), bag->warnings().begin(), bag->warnings().end());
  water.traffic_files += (water.traffic_files.empty() ? "" : ", ") + checksums_of(path);
}

}  // namespace slackwater::live
