#include "ingest/ais/marine_cadastre.h"

#include <charconv>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

/// A number that is the whole text.
template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || problem != std::errc() || stop != text.data() + text.size())
    return std::nullopt;
  return value;
}

/// "2022-01-03T00:00:36", in UTC without saying so.
std::optional<UtcTime> time_in(std::string text) {
  if (text.size() > 10 && text[10] == ' ') text[10] = 'T';
  if (!text.ends_with('Z')) text += 'Z';
  try {
    return parse_utc(text);
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::optional<double> positive(std::optional<double> value, double most) {
  if (!value || !(*value > 0) || !(*value <= most)) return std::nullopt;
  return value;
}

}  // namespace

std::vector<std::string> fields_of_csv(std::string_view line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') {
      const bool is_doubled = is_quoted && i + 1 < line.size() && line[i + 1] == '"';
      if (is_doubled) {
        fields.back() += c;
        ++i;
      } else {
        is_quoted = !is_quoted;
      }
    } else if (c == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

bool MarineCadastreReader::is_header(std::string_view line) {
  const MarineCadastreReader reader(line);
  for (const char* needed : {"MMSI", "BaseDateTime", "LAT", "LON"}) {
    if (!reader.column_.contains(needed)) return false;
  }
  return true;
}

MarineCadastreReader::MarineCadastreReader(std::string_view header) {
  for (std::string& name : fields_of_csv(header)) column_.emplace(std::move(name), columns_++);
}

std::optional<AisReport> MarineCadastreReader::report_of(std::string_view row) const {
  const std::vector<std::string> fields = fields_of_csv(row);
  if (fields.size() != columns_) return std::nullopt;
  const auto text = [&](const char* name) -> std::string {
    const auto found = column_.find(name);
    if (found == column_.end() || fields[found->second] == "NA") return {};
    return fields[found->second];
  };
  const auto number = [&](const char* name) { return number_in<double>(text(name)); };
  const auto mmsi = number_in<std::uint32_t>(text("MMSI"));
  AisReport report;
  report.time = time_in(text("BaseDateTime"));
  if (!mmsi || *mmsi < 1 || *mmsi > 999'999'999 || !report.time) return std::nullopt;
  report.mmsi = *mmsi;
  report.speaker = text("TransceiverClass") == "B" ? AisClass::b : AisClass::a;
  report.type = report.speaker == AisClass::b ? 18 : 1;
  const auto latitude = number("LAT");
  const auto longitude = number("LON");
  if (latitude && longitude) report.position = ais_position(*latitude, *longitude);
  if (const auto speed = number("SOG")) report.speed_over_ground_m_s = ais_speed_m_s(*speed);
  if (const auto course = number("COG")) report.course_over_ground = ais_angle(*course);
  if (const auto heading = number("Heading")) report.heading = ais_angle(*heading);

  AisIdentity& identity = report.identity;
  identity.name = clean_ais_text(text("VesselName"));
  identity.callsign = clean_ais_text(text("CallSign"));
  const auto ship_type = number_in<int>(text("VesselType"));
  if (ship_type && *ship_type >= 1 && *ship_type <= 99) identity.ship_type = ship_type;
  std::string imo = text("IMO");
  if (imo.starts_with("IMO")) imo.erase(0, 3);
  const auto imo_number = number_in<std::uint32_t>(imo);
  if (imo_number && *imo_number >= 1 && *imo_number <= 999'999'999) identity.imo = imo_number;
  identity.length_m = positive(number("Length"), 1022);
  identity.beam_m = positive(number("Width"), 126);
  return report;
}

}  // namespace slackwater::ingest
