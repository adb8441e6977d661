#include "api/door/desk/slack_answer.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/door/desk/asked_words.h"
#include "api/show/report/forecast_speed.h"
#include "fields/base/text.h"

namespace slackwater::api::desk {
namespace {

using nlohmann::json;

json time_or_null(const std::optional<UtcTime>& time) {
  return time ? json(format_utc(*time)) : json(nullptr);
}

const ForecastCatalogue::SiteForecast& forecast_of(const ForecastCatalogue& catalogue,
                                                   const std::string& id) {
  const auto found = std::find_if(catalogue.sites.begin(), catalogue.sites.end(),
                                  [&](const auto& site) { return site.site_id == id; });
  if (found != catalogue.sites.end()) return *found;
  throw Error(ErrorKind::not_found,
              "found no forecast of a site by that id; GET /sites lists what there is");
}

GeoPoint place_asked(const AskedWords& words, const Snapshot& forecast) {
  const std::string longitude = words.one("longitude"), latitude = words.one("latitude");
  if (longitude.empty() && latitude.empty()) return forecast.columns.front().point;
  return GeoPoint::from_degrees(number_in("latitude", latitude, -90, 90),
                                number_in("longitude", longitude, -360, 360));
}

void expect_water(const Field& field, const GeoPoint& place, double depth_m) {
  const Place there{place.longitude_deg(), place.latitude_deg(), depth_m,
                    field.snapshot().time.front()};
  if (has_value(field.current(there).status)) return;
  throw Error(ErrorKind::not_found,
              formatted("found no water of this forecast at {} in {:g} m; choose a place nearer to "
                        "a column, or a smaller depth",
                        position_text(place), depth_m));
}

}  // namespace

json slack_answer(const IssuedFields& forecasts, const std::string& site,
                  const std::string& query) {
  const AskedWords words(query, {"depth", "below", "longitude", "latitude"});
  const double depth_m = words.number("depth", 0, 12000, 5);
  const double below_m_s = words.number("below", 0.01, 10, 0.5);
  const auto catalogue = forecasts.catalogue();
  const auto& forecast = forecast_of(*catalogue, site);
  const Field& field = *forecast.field;
  const GeoPoint place = place_asked(words, field.snapshot());
  expect_water(field, place, depth_m);
  const SlackAt slack = slack_at(field, place, depth_m, below_m_s);
  json windows = json::array();
  for (const SlackWindow& window : slack.windows)
    windows.push_back({{"from", format_utc(window.from)},
                       {"to", format_utc(window.to)},
                       {"begins_before", window.is_cut_before},
                       {"ends_after", window.is_cut_after},
                       {"sure_from", time_or_null(window.sure_from)},
                       {"sure_to", time_or_null(window.sure_to)}});
  return {{"site", site},
          {"instance", forecast.instance},
          {"longitude_deg", place.longitude_deg()},
          {"latitude_deg", place.latitude_deg()},
          {"depth_m", depth_m},
          {"below_m_s", below_m_s},
          {"slack", std::move(windows)},
          {"why_none", slack.no_tide.empty() ? json(nullptr) : json(slack.no_tide)}};
}

}  // namespace slackwater::api::desk
