#include "ingest/ais/report.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace slackwater::ingest {
namespace {

using Json = nlohmann::json;

/// gpsdecode writes words ("nan", "fast") where there is no number.
std::optional<double> number_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// A whole number in [least, most].
std::optional<int> whole_of(const Json& object, const char* key, int least, int most) {
  const auto value = number_of(object, key);
  if (!value || *value < least || *value > most || *value != std::floor(*value))
    return std::nullopt;
  return static_cast<int>(*value);
}

std::optional<std::string> text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  return clean_ais_text(found->get_ref<const std::string&>());
}

std::optional<AisClass> speaker_of(int type) noexcept {
  switch (type) {
    case 1:
    case 2:
    case 3:
    case 5:
      return AisClass::a;
    case 4:
      return AisClass::base_station;
    case 18:
    case 19:
    case 24:
      return AisClass::b;
    default:
      return std::nullopt;
  }
}

/// Distances from the antenna to the four sides (ITU-R M.1371 figure 41). Bow and port zero with
/// the others given: the size is known, the place of the antenna is not.
void read_dimensions(const Json& object, AisIdentity& identity) {
  const auto bow = whole_of(object, "to_bow", 0, 511);
  const auto stern = whole_of(object, "to_stern", 0, 511);
  const auto port = whole_of(object, "to_port", 0, 63);
  const auto starboard = whole_of(object, "to_starboard", 0, 63);
  if (!bow || !stern || !port || !starboard) return;
  if (*bow + *stern > 0) identity.length_m = *bow + *stern;
  if (*port + *starboard > 0) identity.beam_m = *port + *starboard;
  if (*bow == 0 && *port == 0) return;
  if (identity.length_m) identity.antenna_from_bow_m = *bow;
  if (identity.beam_m) identity.antenna_from_port_m = *port;
}

AisIdentity identity_of(const Json& object) {
  AisIdentity identity;
  identity.name = text_of(object, "shipname");
  identity.callsign = text_of(object, "callsign");
  identity.ship_type = whole_of(object, "shiptype", 1, 99);
  const auto imo = whole_of(object, "imo", 1, 999'999'999);
  if (imo) identity.imo = static_cast<std::uint32_t>(*imo);
  read_dimensions(object, identity);
  return identity;
}

}  // namespace

std::string_view name_of(AisClass speaker) noexcept {
  switch (speaker) {
    case AisClass::a:
      return "A";
    case AisClass::b:
      return "B";
    case AisClass::base_station:
      return "base station";
  }
  return "";
}

std::optional<std::string> clean_ais_text(std::string_view text) {
  constexpr std::size_t most_characters = 20;  // a name; ITU-R M.1371 tables 52, 69
  std::string result;
  for (const char c : text.substr(0, text.find('@'))) {
    if (c >= ' ' && c <= '~') result += c;
  }
  const std::size_t first = result.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  result = result.substr(first, result.find_last_not_of(' ') - first + 1);
  if (result.size() > most_characters) return std::nullopt;
  return result;
}

std::optional<GeoPoint> ais_position(double latitude_deg, double longitude_deg) {
  if (!(std::abs(latitude_deg) <= 90) || !(std::abs(longitude_deg) <= 180)) return std::nullopt;
  return GeoPoint::from_degrees(latitude_deg, longitude_deg);
}

std::optional<double> ais_speed_m_s(double speed_kn) noexcept {
  constexpr double or_more_kn = 102.2;  // 1022: "102.2 knots or higher", 1023: not available
  if (!(speed_kn >= 0) || !(speed_kn < or_more_kn - 0.05)) return std::nullopt;
  return speed_kn * metres_per_second_of_knot;
}

std::optional<Angle> ais_angle(double angle_deg) noexcept {
  if (!(angle_deg >= 0) || !(angle_deg < 360)) return std::nullopt;
  return Angle::from_degrees(angle_deg);
}

std::optional<AisReport> report_from_json(std::string_view json) {
  const Json object = Json::parse(json, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  const auto type = whole_of(object, "type", 1, 27);
  const auto mmsi = whole_of(object, "mmsi", 1, 999'999'999);
  const auto speaker = type ? speaker_of(*type) : std::nullopt;
  if (!mmsi || !speaker) return std::nullopt;

  AisReport report;
  report.mmsi = static_cast<std::uint32_t>(*mmsi);
  report.type = *type;
  report.speaker = *speaker;
  const auto latitude = number_of(object, "lat");
  const auto longitude = number_of(object, "lon");
  if (latitude && longitude) report.position = ais_position(*latitude, *longitude);
  if (const auto speed = number_of(object, "speed"))
    report.speed_over_ground_m_s = ais_speed_m_s(*speed);
  if (const auto course = number_of(object, "course"))
    report.course_over_ground = ais_angle(*course);
  if (const auto heading = number_of(object, "heading")) report.heading = ais_angle(*heading);
  report.utc_second = whole_of(object, "second", 0, 59);
  report.identity = identity_of(object);
  return report;
}

}  // namespace slackwater::ingest
