#include "api/door/edr/sample/work.h"

#include <algorithm>
#include <string>

#include "fields/base/error.h"

namespace slackwater::api::edr {

Work moderate_work(const Selection& s, std::size_t places, std::size_t domains) {
  return moderate_work(s.parameters.size(), places, domains);
}

Work moderate_work(std::size_t selected, std::size_t places, std::size_t domains) {
  if (domains > most_domains) {
    throw Error(ErrorKind::usage, "found a query for " + std::to_string(domains) +
                                      " lines (each at each time and level); an answer holds at "
                                      "most " +
                                      std::to_string(most_domains) +
                                      ": narrow datetime, z or the resolution");
  }
  const std::size_t parameters = std::max<std::size_t>(1, selected);
  if (places <= most_values / parameters) return {places * parameters, 0};
  throw Error(ErrorKind::usage, "found a query for " + std::to_string(places) +
                                    " places and times with " + std::to_string(parameters) +
                                    " parameters; an answer holds at most " +
                                    std::to_string(most_values) +
                                    " values: narrow datetime, z, parameter-name or the area");
}

std::size_t moderate_comparisons(std::size_t cells, std::size_t vertices) {
  if (cells <= most_comparisons / std::max<std::size_t>(1, vertices)) return cells * vertices;
  throw Error(ErrorKind::usage, "coords: found an area of " + std::to_string(vertices) +
                                    " vertices over " + std::to_string(cells) +
                                    " cells; expected at most " + std::to_string(most_comparisons) +
                                    " of cells times vertices: simplify the area, or lower "
                                    "resolution-x and resolution-y");
}

bool takes_long(const Work& work) noexcept {
  return work.values > most_short_values || work.comparisons > most_short_comparisons;
}

}  // namespace slackwater::api::edr
