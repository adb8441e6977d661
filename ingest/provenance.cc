#include "ingest/provenance.h"

#include <array>
#include <string_view>
#include <vector>

#include "ingest/cf/time_code.h"

namespace slackwater::ingest {
namespace {

bool is_id_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

}  // namespace

std::optional<UtcTime> stated_reference_time(const netcdf::File& file, const Product& product) {
  for (const netcdf::Variable& variable : file.variables()) {
    if (variable.text("standard_name") != "forecast_reference_time" || variable.size() != 1)
      continue;
    const auto units = variable.text("units");
    if (!units || variable.type == netcdf::Type::character || variable.type == netcdf::Type::string)
      continue;
    std::vector<std::string> ignored;
    const TimeCode code = TimeCode::parse(*units, variable.text("calendar").value_or(""), ignored);
    return code.decode(file.read_all(variable).front());
  }
  for (const std::string& name : product.reference_time) {
    if (const auto text = file.text(name)) {
      if (const auto date = find_date(*text)) return date;
    }
  }
  return std::nullopt;
}

std::string stated_dataset_id(const netcdf::File& file) {
  constexpr std::array<std::string_view, 2> starts{"cmems_mod_", "cmems_obs"};
  for (const netcdf::Attribute& attribute : file.attributes()) {
    const auto text = attribute.text();
    if (!text) continue;
    for (const std::string_view start : starts) {
      const std::size_t at = text->find(start);
      if (at == std::string::npos) continue;
      std::size_t end = at;
      while (end < text->size() && is_id_character((*text)[end])) ++end;
      while (end > at && (*text)[end - 1] == '.') --end;
      return text->substr(at, end - at);
    }
  }
  return {};
}

}  // namespace slackwater::ingest
