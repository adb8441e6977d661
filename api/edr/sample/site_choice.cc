#include "api/edr/sample/site_choice.h"

#include "api/edr/read/bad_parameter.h"
#include "api/edr/read/bbox.h"
#include "api/edr/read/wkt.h"

namespace slackwater::api::edr {
namespace {

/// What a query points at.
struct Target {
  Box box;
  double longitude_deg = 0;  ///< the place by which it chooses
  double latitude_deg = 0;
};

Target middle_of(const Box& box) {
  return {box, 0.5 * (box.west_deg + box.east_deg), 0.5 * (box.south_deg + box.north_deg)};
}

Target target_of(const QueryType& type, const QueryString& query) {
  if (type.name == "cube") {
    const auto text = query.find("bbox");
    if (!text)
      throw bad_parameter("bbox", "nothing", "west,south,east,north, e.g. 2.0,53.0,2.5,53.4");
    return middle_of(parse_bbox(*text).box);
  }
  const auto text = query.find("coords");
  if (!text) throw bad_parameter("coords", "nothing", "Well Known Text, e.g. POINT(-2.55 48.85)");
  const Geometry geometry = parse_wkt("coords", *text);
  const Box box = bounding_box(geometry);
  if (type.name == "area") return middle_of(box);
  const Vertex& first = geometry.parts.front().front().front();
  return {box, first.longitude_deg, first.latitude_deg};
}

}  // namespace

const ForecastCatalogue::SiteForecast* site_for(const ForecastCatalogue& catalogue,
                                                const QueryType& type, const QueryString& query) {
  const Target target = target_of(type, query);
  if (const auto* site = catalogue.site_at(target.longitude_deg, target.latitude_deg)) return site;
  for (const auto& site : catalogue.sites) {
    for (const ForecastColumn& column : site.field->snapshot().columns) {
      if (contains(target.box, column.point.longitude_deg(), column.point.latitude_deg()))
        return &site;
    }
  }
  return nullptr;
}

std::string reach_of(const ForecastCatalogue& catalogue) {
  if (catalogue.sites.empty()) return "no forecast is stored yet; run `slackwater forecast` first";
  std::string text = "the forecasts in force reach";
  for (const auto& site : catalogue.sites)
    text += " " + site.site_id + " (" + site.field->range().text() + ");";
  text.back() = '.';
  return text;
}

}  // namespace slackwater::api::edr
