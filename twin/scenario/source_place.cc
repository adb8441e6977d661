#include "twin/scenario/source_place.h"

#include "fields/base/error.h"

namespace slackwater::twin {

void refuse_at(const SourcePlace& place, const std::string& why) {
  throw Error(ErrorKind::invalid_input, place.text + ": " + why);
}

SourcePlace place_of_key(const Config& config, std::string_view key) {
  const KeyPlaces places = config.places();
  for (const auto& [dotted, line] : places.line)
    if (dotted.ends_with(key)) return {places.of(dotted)};
  return {places.file};
}

}  // namespace slackwater::twin
