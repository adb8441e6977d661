#include "ingest/ais/report.h"

#include <array>
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
    case 27:
      return AisClass::a;
    case 4:
      return AisClass::base_station;
    case 18:
    case 19:
    case 24:
      return AisClass::b;
    case 9:
      return AisClass::aircraft;
    default:
      return std::nullopt;
  }
}

/// What one step of a coded number is worth (ITU-R M.1371-5 annex 8, tables 47, 55, 66 and 78).
struct Steps {
  double degree = 1.0 / 600000.0;
  double knot = 0.1;
  double course_degree = 0.1;
};

Steps steps_of(int type, bool is_scaled) noexcept {
  if (is_scaled) return {1, 1, 1};
  if (type == 9) return {1.0 / 600000.0, 1, 0.1};
  if (type == 27) return {1.0 / 600.0, 1, 1};
  return {};
}

/// In whole knots, which reach further and end earlier than the tenths of other types.
std::optional<double> whole_knots_m_s(int type, double speed_kn) noexcept {
  const double least_unknown = type == 9 ? 1022 : 63;
  if (!(speed_kn >= 0) || !(speed_kn < least_unknown)) return std::nullopt;
  return speed_kn * metres_per_second_of_knot;
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
    case AisClass::aircraft:
      return "SAR aircraft";
  }
  return "";
}

bool is_ais_type_of_ours(int type) noexcept { return speaker_of(type).has_value(); }

std::string_view name_of_ais_type(int type) noexcept {
  // ITU-R M.1371-5, annex 8, table 46.
  constexpr std::array<std::string_view, 28> names{"",
                                                   "position",
                                                   "position",
                                                   "position",
                                                   "base station",
                                                   "ship and voyage",
                                                   "addressed binary",
                                                   "binary acknowledge",
                                                   "binary broadcast",
                                                   "SAR aircraft position",
                                                   "UTC inquiry",
                                                   "UTC response",
                                                   "addressed safety text",
                                                   "safety acknowledge",
                                                   "safety broadcast",
                                                   "interrogation",
                                                   "assignment",
                                                   "GNSS corrections",
                                                   "position of class B",
                                                   "extended position of class B",
                                                   "data link management",
                                                   "aid to navigation",
                                                   "channel management",
                                                   "group assignment",
                                                   "particulars",
                                                   "single-slot binary",
                                                   "multiple-slot binary",
                                                   "long-range position"};
  if (type < 0 || static_cast<std::size_t>(type) >= names.size()) return "";
  return names[static_cast<std::size_t>(type)];
}

std::string_view kind_of_ship_type(int type) noexcept {
  constexpr std::array<std::string_view, 10> thirties{
      "fishing vessel", "towing vessel",  "towing vessel",  "dredger", "diving vessel",
      "military ship",  "sailing vessel", "pleasure craft", "",        ""};
  constexpr std::array<std::string_view, 10> fifties{
      "pilot vessel",          "search and rescue vessel",    "tug",          "port tender",
      "anti-pollution vessel", "law enforcement vessel",      "local vessel", "local vessel",
      "medical transport",     "ship not party to a conflict"};
  if (type < 20 || type > 99) return "";
  const auto ones = static_cast<std::size_t>(type % 10);
  switch (type / 10) {
    case 2:
      return "wing-in-ground craft";
    case 3:
      return thirties[ones];
    case 4:
      return "high-speed craft";
    case 5:
      return fifties[ones];
    case 6:
      return "passenger ship";
    case 7:
      return "cargo ship";
    case 8:
      return "tanker";
    default:
      return "other ship";
  }
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
  const auto scaled = object.find("scaled");
  const Steps step = steps_of(*type, scaled == object.end() || *scaled != Json(false));
  if (latitude && longitude)
    report.position = ais_position(*latitude * step.degree, *longitude * step.degree);
  if (const auto speed = number_of(object, "speed"))
    report.speed_over_ground_m_s = *type == 9 || *type == 27 ? whole_knots_m_s(*type, *speed)
                                                             : ais_speed_m_s(*speed * step.knot);
  if (const auto course = number_of(object, "course"))
    report.course_over_ground = ais_angle(*course * step.course_degree);
  if (const auto heading = number_of(object, "heading")) report.heading = ais_angle(*heading);
  report.utc_second = whole_of(object, "second", 0, 59);
  report.identity = identity_of(object);
  return report;
}

}  // namespace slackwater::ingest
