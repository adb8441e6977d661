#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fields/base/angle.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"

namespace slackwater::ingest {

/// Who speaks, by the message types of ITU-R M.1371.
enum class AisClass : std::uint8_t {
  a,             ///< types 1, 2, 3, 5, 27: ships that must carry AIS
  b,             ///< types 18, 19, 24: small craft
  base_station,  ///< type 4: on land, its clock and place
  aircraft,      ///< type 9: of search and rescue, in the air
};
/// "A", "B", "base station", "SAR aircraft".
[[nodiscard]] std::string_view name_of(AisClass speaker) noexcept;

/// The message types that we read: 1 to 5, 9, 18, 19, 24 and 27.
[[nodiscard]] bool is_ais_type_of_ours(int type) noexcept;
/// What a message type of ITU-R M.1371 is, "aid to navigation"; empty for one that it does not
/// have.
[[nodiscard]] std::string_view name_of_ais_type(int type) noexcept;

/// "cargo ship", "tug": what a ship type of ITU-R M.1371-5, table 53, means; empty for one that it
/// does not have.
[[nodiscard]] std::string_view kind_of_ship_type(int type) noexcept;

/// What a vessel says of itself; what it does not say, or says is not available, is absent.
struct AisIdentity {
  std::optional<std::string> name;  ///< printable ASCII, at most 20 characters
  std::optional<std::string> callsign;
  std::optional<int>
      ship_type;  ///< 1 to 99 by ITU-R M.1371 table 53: 37 pleasure craft, 70s cargo, ...
  std::optional<std::uint32_t> imo;
  std::optional<double> length_m;
  std::optional<double> beam_m;
  std::optional<double> antenna_from_bow_m;  ///< where the position is taken, from the bow aft
  std::optional<double> antenna_from_port_m;
  bool operator==(const AisIdentity&) const = default;
};

/// One decoded message, in SI units, its values checked against ITU-R M.1371: latitude 91,
/// longitude 181, speed 102.3 kn (and "102.2 kn or more"), course 360 and heading 511 mean "not
/// available" and are absent here. So do 1023 kn (and 1022 or more) of an aircraft and 63 kn of
/// type 27.
struct AisReport {
  std::uint32_t mmsi = 0;  ///< 1 to 999999999
  int type = 0;            ///< one of ours
  AisClass speaker = AisClass::a;
  bool is_own_ship = false;  ///< VDO: of the receiver itself
  std::optional<UtcTime>
      time;  ///< when it was received, by the log; AIS itself tells the second alone
  std::optional<GeoPoint> position;  ///< of type 27 rounded to a tenth of a minute, 185 m
  std::optional<double> speed_over_ground_m_s;
  std::optional<Angle> course_over_ground;  ///< where it goes to, clockwise from true north
  std::optional<Angle> heading;
  std::optional<int> utc_second;  ///< 0 to 59: of the position, by the vessel's receiver
  AisIdentity identity;
};

inline constexpr double metres_per_second_of_knot = 1852.0 / 3600.0;

/// A report from an object of `gpsdecode -j`, scaled or not (`"scaled":false`). Takes any text.
/// @return nothing where it is no JSON object of one of our types with an MMSI
[[nodiscard]] std::optional<AisReport> report_from_json(std::string_view json);

/// Text as vessels write it: padding (`@`, blanks) and what is not printable ASCII taken off;
/// absent where nothing is left or more than 20 characters are.
[[nodiscard]] std::optional<std::string> clean_ais_text(std::string_view text);

/// Raw values to what they mean: nothing where out of range or "not available". Shared by both
/// kinds of log.
[[nodiscard]] std::optional<GeoPoint> ais_position(double latitude_deg, double longitude_deg);
[[nodiscard]] std::optional<double> ais_speed_m_s(double speed_kn) noexcept;
[[nodiscard]] std::optional<Angle> ais_angle(double angle_deg) noexcept;

}  // namespace slackwater::ingest
