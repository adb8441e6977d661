#include "ingest/history/offer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/frame.h"

namespace slackwater::ingest {
namespace {

struct Made {
  const char* name;
  VectorPart part;
  const char* east;
  const char* north;
};
/// Of each vector its speed, then its direction.
constexpr std::array made_of_two{
    Made{"wind_speed", VectorPart::speed, "eastward_wind", "northward_wind"},
    Made{"wind_from_direction", VectorPart::from_direction, "eastward_wind", "northward_wind"},
    Made{"sea_water_speed", VectorPart::speed, "eastward_sea_water_velocity",
         "northward_sea_water_velocity"},
    Made{"sea_water_velocity_to_direction", VectorPart::to_direction, "eastward_sea_water_velocity",
         "northward_sea_water_velocity"},
};

/// The one offer of this standard name, or the one of several that the user names; nothing where
/// there is none.
std::optional<std::size_t> only_one(const std::string& standard_name,
                                    const std::vector<Offer>& offers) {
  for (const bool by_name : {true, false}) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < offers.size(); ++i) {
      if (offers[i].standard_name != standard_name || (by_name && !offers[i].is_named)) continue;
      if (found)
        throw Error(ErrorKind::invalid_input,
                    "found two columns that are " + standard_name + ", '" + offers[*found].name +
                        "' and '" + offers[i].name + "'; say which is meant with --column '" +
                        offers[i].name + "=" + standard_name + "'");
      found = i;
    }
    if (found) return found;
  }
  return std::nullopt;
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

double part_of(VectorPart part, double east, double north) noexcept {
  if (part == VectorPart::speed) return std::hypot(east, north);
  if (east == 0 && north == 0) return constants::nan;
  return part == VectorPart::from_direction ? from_direction_deg({east, north})
                                            : to_direction_deg({east, north});
}

void make_of_components(HistorySeries& east, const HistorySeries& north, const Making& making) {
  if (north.time != east.time || north.unit != east.unit)
    refuse("components '" + east.name + "' and '" + north.name +
           "': found other times or units, expected the same for both");
  for (std::size_t t = 0; t < east.value.size(); ++t) {
    double& value = east.value[t];
    value = part_of(making.part, value, north.value[t]);
    if (east.is_single_precision) value = static_cast<float>(value);
  }
  if (making.part != VectorPart::speed) east.unit = "degree";
  east.standard_name = making.standard_name;
  east.name += " and " + north.name;
}

bool is_direction(const std::string& standard_name) {
  return standard_name.find("_direction") != std::string::npos;
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
  for (const Made& made : made_of_two) {
    if (name != made.name) continue;
    const auto east = only_one(made.east, offers);
    const auto north = only_one(made.north, offers);
    if (!east || !north) continue;
    const Offer& a = offers[*east];
    const Offer& b = offers[*north];
    // A name chooses a height among several: what else the file has may be of another.
    if (a.is_named != b.is_named)
      throw Error(ErrorKind::invalid_input,
                  "found '" + (a.is_named ? a : b).name + "' named as " +
                      (a.is_named ? a : b).standard_name + " and '" + (a.is_named ? b : a).name +
                      "' not named, which may be of another height; name both components with "
                      "--column");
    return Making{*east, north, made.part, made.name};
  }
  return std::nullopt;
}

std::vector<std::string> made_apart(const std::vector<std::string>& wanted,
                                    const std::vector<Offer>& offers,
                                    const Vocabulary& vocabulary) {
  std::vector<std::string> told;
  const auto is_wanted = [&](const char* name) {
    return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  for (std::size_t i = 0; i < made_of_two.size(); i += 2) {
    const char* const speed = made_of_two[i].name;
    const char* const direction = made_of_two[i + 1].name;
    if (!is_wanted(speed) || !is_wanted(direction)) continue;
    const auto one = making_of(speed, offers, vocabulary);
    const auto other = making_of(direction, offers, vocabulary);
    if (!one || !other || one->second.has_value() == other->second.has_value()) continue;
    const auto columns = [&](const Making& making) {
      return "'" + offers[making.first].name + "'" +
             (making.second ? " and '" + offers[*making.second].name + "'" : "");
    };
    told.push_back(std::string(speed) + " is of " + columns(*one) + " and " + direction + " of " +
                   columns(*other) + ": make sure that both are of one height");
  }
  return told;
}

}  // namespace slackwater::ingest
