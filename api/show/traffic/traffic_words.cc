#include "api/show/traffic/traffic_words.h"

#include <cmath>

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// "40 s", "12 min", "3 h 20 min".
std::string span_text(double span_s) {
  const long seconds = std::lround(std::abs(span_s));
  if (seconds < 120) return std::to_string(seconds) + " s";
  const long minutes = std::lround(std::abs(span_s) / 60);
  if (minutes < 120) return std::to_string(minutes) + " min";
  if (minutes >= 2880) return std::to_string(minutes / 1440) + " days";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}
std::string span_text(Duration span) {
  return span_text(std::chrono::duration<double>(span).count());
}

std::string metres_text(double metres) {
  return metres < 10'000 ? formatted("{:.0f} m", metres) : formatted("{:.1f} km", metres / 1000);
}

std::string site_or(const std::string& turbine) { return turbine.empty() ? "the site" : turbine; }

std::string degrees_text(double degrees) {
  return formatted("{:03}", static_cast<int>(std::lround(degrees)) % 360);
}

std::string movement_text(const ingest::AisPosition& position) {
  std::string text = position.speed_over_ground_m_s
                         ? formatted("{:.1f} m/s", *position.speed_over_ground_m_s)
                         : std::string("-");
  if (position.course_over_ground)
    text += " to " + degrees_text(position.course_over_ground->degrees());
  return text;
}

std::string kind_text(const ingest::AisIdentity& identity) {
  const std::string kind(identity.ship_type ? ingest::kind_of_ship_type(*identity.ship_type) : "");
  const std::string length =
      identity.length_m ? formatted("{:.0f} m", *identity.length_m) : std::string();
  return joined(std::vector<std::string>{kind, length}, " ");
}

std::string line_of(const VesselThere& there) {
  const LastHeard& heard = there.heard;
  std::string line = formatted(
      "{:9}  {:<20}  {:<26}  {:<17}  {:>9} from {}  heard {} ago", heard.mmsi,
      heard.identity.name.value_or("-"), kind_text(heard.identity), movement_text(heard.position),
      metres_text(there.distance_m), degrees_text(there.bearing_deg), span_text(there.age));
  if (!there.is_fresh) return line + ", old: no closest approach\n";
  if (there.told) line += ", " + approach_words(*there.told);
  if (there.alarm != TrafficAlarm::none) line += "  !";
  return line + "\n";
}

}  // namespace

std::string approach_words(const Approach& approach) {
  const std::string where = metres_text(approach.distance_m) + " from " + site_or(approach.to);
  switch (approach.passing) {
    case Passing::closing:
      return "passes " + where + " in " + span_text(approach.time_s);
    case Passing::past:
      return "goes away, past at " + where + " " + span_text(approach.time_s) + " ago";
    case Passing::still:
      break;
  }
  return "lies " + where;
}

std::string traffic_in_words(const TrafficQuestion& question, const TrafficHeard& heard,
                             const TrafficAnswer& answer) {
  if (heard.sources.empty())
    return "No log of AIS is given. Start slackwater serve with --ais FILE to see vessels.";
  std::vector<std::string> said;
  for (const TrafficSource& source : heard.sources)
    if (!source.trouble.empty()) said.push_back(source.trouble);
  if (!heard.last) {
    said.push_back(heard.first ? "Nothing was heard by then; what is known begins at " +
                                     format_utc(*heard.first) + "."
                               : "No traffic was heard yet.");
    return joined(said, " ");
  }
  const Duration since = question.at - *heard.last;
  const std::string last =
      format_utc(*heard.last) + ", " + span_text(since) + " before the time that is shown";
  if (since > question.rule.silent) said.push_back("Traffic was last heard at " + last + ".");
  const std::string reach = " within " + metres_text(question.rule.reach_m);
  said.push_back(answer.vessels.empty()
                     ? "No vessel" + reach + "."
                     : counted(answer.vessels.size() + answer.left_out, "vessel") + reach + ".");
  if (answer.left_out > 0)
    said.push_back("The nearest " + std::to_string(answer.vessels.size()) + " are told.");
  if (answer.too_old > 0)
    said.push_back(std::to_string(answer.too_old) + " more were silent for over " +
                   span_text(question.rule.shown) + ", not shown.");
  return joined(said, " ");
}

std::string traffic_text(const TrafficQuestion& question, const TrafficHeard& heard,
                         const TrafficAnswer& answer) {
  std::string text = question.site + " at " + format_utc(question.at) + ": " +
                     traffic_in_words(question, heard, answer) + "\n";
  for (const VesselThere& there : answer.vessels) text += line_of(there);
  return text;
}

}  // namespace slackwater::api
