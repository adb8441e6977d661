#include "twin/scenario/source_place.h"

namespace slackwater::twin {

SourcePlace place_of_key(const Config& config, std::string_view key) {
  const KeyPlaces places = config.places();
  for (const auto& [dotted, line] : places.line)
    if (dotted.ends_with(key)) return {places.of(dotted)};
  return {places.file};
}

}  // namespace slackwater::twin
