#include "ingest/ais/table.h"

#include <array>
#include <charconv>

#include "fields/base/error.h"
#include "fields/base/text.h"

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

/// "31/12/2015 23:59:59", the day first.
std::optional<UtcTime> danish_time_in(const std::string& text) {
  if (text.size() < 19 || text[2] != '/' || text[5] != '/' || text[10] != ' ') return std::nullopt;
  return time_in(text.substr(6, 4) + '-' + text.substr(3, 2) + '-' + text.substr(0, 2) + 'T' +
                 text.substr(11));
}

/// Our name for a column, each name that an authority gives it behind; small letters and digits.
struct ColumnNames {
  std::string_view ours;
  std::array<std::string_view, 2> theirs;
};
constexpr std::array column_names{
    ColumnNames{"mmsi", {"mmsi", ""}},
    ColumnNames{"time", {"basedatetime", "timestamp"}},
    ColumnNames{"latitude", {"lat", "latitude"}},
    ColumnNames{"longitude", {"lon", "longitude"}},
    ColumnNames{"sog", {"sog", ""}},
    ColumnNames{"cog", {"cog", ""}},
    ColumnNames{"heading", {"heading", ""}},
    ColumnNames{"name", {"vesselname", "name"}},
    ColumnNames{"imo", {"imo", ""}},
    ColumnNames{"callsign", {"callsign", ""}},
    ColumnNames{"ship type", {"vesseltype", "shiptype"}},
    ColumnNames{"length", {"length", ""}},
    ColumnNames{"beam", {"width", ""}},
    ColumnNames{"class", {"transceiverclass", "transceiver"}},
    ColumnNames{"mobile", {"typeofmobile", ""}},
    ColumnNames{"to bow", {"a", ""}},
    ColumnNames{"to port", {"c", ""}},
};

std::string letters_and_digits(std::string_view name) {
  std::string bare;
  for (const char c : lower_case(name)) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) bare += c;
  }
  return bare;
}

/// The first number of a type (ITU-R M.1371-5 annex 8, table 53) by the Danish table's word for it.
std::optional<int> ship_type_of(std::string_view word) {
  struct Word {
    std::string_view word;
    int type;
  };
  constexpr std::array words{Word{"wig", 20},           Word{"fishing", 30},
                             Word{"towing", 31},        Word{"towinglongwide", 32},
                             Word{"dredging", 33},      Word{"diving", 34},
                             Word{"military", 35},      Word{"sailing", 36},
                             Word{"pleasure", 37},      Word{"hsc", 40},
                             Word{"pilot", 50},         Word{"sar", 51},
                             Word{"tug", 52},           Word{"porttender", 53},
                             Word{"antipollution", 54}, Word{"lawenforcement", 55},
                             Word{"medical", 58},       Word{"passenger", 60},
                             Word{"cargo", 70},         Word{"tanker", 80},
                             Word{"other", 90}};
  const std::string bare = letters_and_digits(word);
  for (const Word& one : words) {
    if (one.word == bare) return one.type;
  }
  return std::nullopt;
}

/// Who speaks, by the Danish table's word for it; nothing for what is no ship, aircraft or station.
struct Mobile {
  AisClass speaker;
  int type;
};
std::optional<Mobile> mobile_of(std::string_view word) {
  const std::string bare = letters_and_digits(word);
  if (bare == "classa") return Mobile{AisClass::a, 1};
  if (bare == "classb") return Mobile{AisClass::b, 18};
  if (bare == "basestation") return Mobile{AisClass::base_station, 4};
  if (bare == "sarairborne") return Mobile{AisClass::aircraft, 9};
  return std::nullopt;
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

bool AisTable::is_header(std::string_view line) {
  const AisTable table(line);
  for (const char* needed : {"mmsi", "time", "latitude", "longitude"}) {
    if (!table.column_.contains(needed)) return false;
  }
  // Anyone may call a column "timestamp"; whose zone and order of days we know only of these two.
  return table.is_danish_ || contains_ignoring_case(letters_and_digits(line), "basedatetime");
}

bool AisTable::looks_like_one(std::string_view line) {
  return line.find(',') != std::string_view::npos && line.find('!') == std::string_view::npos &&
         contains_ignoring_case(line, "mmsi");
}

AisTable::AisTable(std::string_view header) {
  if (header.starts_with("\xEF\xBB\xBF")) header.remove_prefix(3);
  for (const std::string& name : fields_of_csv(header)) {
    const std::string bare = letters_and_digits(name);
    for (const ColumnNames& names : column_names) {
      if (!bare.empty() && (bare == names.theirs[0] || bare == names.theirs[1]))
        column_.emplace(names.ours, columns_);
    }
    ++columns_;
  }
  is_danish_ = column_.contains("mobile");
}

std::optional<AisReport> AisTable::report_of(std::string_view row) const {
  const std::vector<std::string> fields = fields_of_csv(row);
  if (fields.size() != columns_) return std::nullopt;
  const auto text = [&](const char* name) -> std::string {
    const auto found = column_.find(name);
    if (found == column_.end()) return {};
    const std::string& field = fields[found->second];
    if (field == "NA" || field == "Unknown" || field == "Undefined") return {};
    return field;
  };
  const auto number = [&](const char* name) { return number_in<double>(text(name)); };
  const auto mmsi = number_in<std::uint32_t>(text("mmsi"));
  AisReport report;
  report.time = is_danish_ ? danish_time_in(text("time")) : time_in(text("time"));
  if (!mmsi || *mmsi < 1 || *mmsi > 999'999'999 || !report.time) return std::nullopt;
  report.mmsi = *mmsi;
  if (is_danish_) {
    const auto mobile = mobile_of(text("mobile"));
    if (!mobile) return report;
    report.speaker = mobile->speaker;
    report.type = mobile->type;
  } else {
    report.speaker = text("class") == "B" ? AisClass::b : AisClass::a;
    report.type = report.speaker == AisClass::b ? 18 : 1;
  }
  const auto latitude = number("latitude");
  const auto longitude = number("longitude");
  if (latitude && longitude) report.position = ais_position(*latitude, *longitude);
  if (const auto speed = number("sog")) report.speed_over_ground_m_s = ais_speed_m_s(*speed);
  if (const auto course = number("cog")) report.course_over_ground = ais_angle(*course);
  if (const auto heading = number("heading")) report.heading = ais_angle(*heading);

  AisIdentity& identity = report.identity;
  identity.name = clean_ais_text(text("name"));
  identity.callsign = clean_ais_text(text("callsign"));
  const auto ship_type =
      is_danish_ ? ship_type_of(text("ship type")) : number_in<int>(text("ship type"));
  if (ship_type && *ship_type >= 1 && *ship_type <= 99) identity.ship_type = ship_type;
  std::string imo = text("imo");
  if (imo.starts_with("IMO")) imo.erase(0, 3);
  const auto imo_number = number_in<std::uint32_t>(imo);
  if (imo_number && *imo_number >= 1 && *imo_number <= 999'999'999) identity.imo = imo_number;
  identity.length_m = positive(number("length"), 1022);
  identity.beam_m = positive(number("beam"), 126);
  if (is_danish_) {
    const auto bow = positive(number("to bow"), 511);
    const auto port = positive(number("to port"), 63);
    if (identity.length_m && bow) identity.antenna_from_bow_m = bow;
    if (identity.beam_m && port) identity.antenna_from_port_m = port;
  }
  return report;
}

}  // namespace slackwater::ingest
