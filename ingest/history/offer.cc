#include "ingest/history/offer.h"

#include <algorithm>
#include <array>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

struct Speed {
  const char* name;
  const char* east;
  const char* north;
};
constexpr std::array speeds{
    Speed{"wind_speed", "eastward_wind", "northward_wind"},
    Speed{"sea_water_speed", "eastward_sea_water_velocity", "northward_sea_water_velocity"},
};

/// The one offer of this standard name; nothing where there is none.
std::optional<std::size_t> only_one(const std::string& standard_name,
                                    const std::vector<Offer>& offers) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    if (offers[i].standard_name != standard_name) continue;
    if (found)
      throw Error(ErrorKind::invalid_input,
                  "found two columns that are " + standard_name + ", '" + offers[*found].name +
                      "' and '" + offers[i].name +
                      "'; name the column itself in the limit, or leave one --column away");
    found = i;
  }
  return found;
}

}  // namespace

NamedColumn parse_named_column(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t colon = equals == std::string::npos ? equals : text.find(':', equals);
  NamedColumn named;
  if (equals != std::string::npos) {
    named.column = text.substr(0, equals);
    named.standard_name =
        text.substr(equals + 1, colon == std::string::npos ? colon : colon - equals - 1);
    if (colon != std::string::npos) named.unit = text.substr(colon + 1);
  }
  const bool has_empty_unit = colon != std::string::npos && named.unit.empty();
  if (named.column.empty() || named.standard_name.empty() || has_empty_unit)
    throw Error(ErrorKind::usage, "found --column '" + text +
                                      "', expected NAME=STANDARD_NAME:UNIT, e.g. "
                                      "Hs=sea_surface_wave_significant_height:m");
  return named;
}

std::string current_name(const std::string& name, const Vocabulary& vocabulary) {
  const Quantity* quantity = vocabulary.by_standard_name(name);
  return quantity == nullptr ? name : quantity->standard_name;
}

std::optional<Making> making_of(const std::string& wanted, const std::vector<Offer>& offers,
                                const Vocabulary& vocabulary) {
  const auto own = std::find_if(offers.begin(), offers.end(),
                                [&](const Offer& offer) { return offer.name == wanted; });
  if (own != offers.end()) return Making{static_cast<std::size_t>(own - offers.begin())};
  const std::string name = current_name(wanted, vocabulary);
  if (const auto one = only_one(name, offers)) return Making{*one};
  for (const Speed& speed : speeds) {
    if (name != speed.name) continue;
    const auto east = only_one(speed.east, offers);
    const auto north = only_one(speed.north, offers);
    if (east && north) return Making{*east, north};
  }
  return std::nullopt;
}

}  // namespace slackwater::ingest
