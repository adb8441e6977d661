#include <limits>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/wkt.h"
#include "api/door/edr/sample/queries.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

/// The bed at a place that the forecast reaches.
double bed_at(const Selection& s, double longitude_deg, double latitude_deg) {
  const Place place{longitude_deg, latitude_deg, 0, {}};
  BedSample bed;
  s.field->sample_bed({&place, 1}, {&bed, 1});
  if (bed.status != SampleStatus::outside_area && bed.status != SampleStatus::land)
    return bed.water_depth_m;
  throw Error(ErrorKind::not_found,
              formatted("coords: found the place {:.5f} {:.5f}", longitude_deg, latitude_deg) +
                  (bed.status == SampleStatus::land ? ", which is on land"
                                                    : ", which is outside the forecast") +
                  "; valid: " + s.field->range().text());
}

}  // namespace

QueryPoints position_plan(Selection s, const QueryString& query) {
  const Geometry geometry = parse_wkt("coords", query.find("coords").value_or(""),
                                      {GeometryType::point, GeometryType::multi_point});
  std::vector<UtcTime> times = times_of(s, query);
  const Path& points = geometry.parts.front().front();
  // The places of one answer share their levels, so that it has one domain type.
  double deepest_bed_m = 0;
  for (const Vertex& point : points)
    deepest_bed_m = std::max(deepest_bed_m, bed_at(s, point.longitude_deg, point.latitude_deg));
  std::vector<double> levels = verticals_of(s, query, deepest_bed_m);
  const bool has_own_levels =
      geometry.has_vertical && !query.find("z") && s.collection->vertical != Vertical::none;
  const Work work = moderate_work(s, points.size() * times.size() * levels.size());
  return {work, [s = std::move(s), points, times = std::move(times), levels = std::move(levels),
                 has_own_levels]() mutable {
            Absences absences{};
            std::vector<Coverage> coverages;
            for (const Vertex& point : points) {
              coverages.push_back(at_point(s, point.longitude_deg, point.latitude_deg, times,
                                           has_own_levels ? std::vector{point.vertical} : levels,
                                           absences));
            }
            return answer_of(std::move(s), std::move(coverages), absences);
          }};
}

QueryPoints location_plan(Selection s, const QueryString& query, std::size_t column) {
  const ForecastColumn& c = s.field->snapshot().columns.at(column);
  std::vector<UtcTime> times = times_of(s, query);
  std::vector<double> levels = verticals_of(s, query, c.water_depth_m);
  const Work work = moderate_work(s, times.size() * levels.size());
  return {work, [s = std::move(s), place = c.point, times = std::move(times),
                 levels = std::move(levels)]() mutable {
            Absences absences{};
            std::vector<Coverage> coverages{
                at_point(s, place.longitude_deg(), place.latitude_deg(), times, levels, absences)};
            return answer_of(std::move(s), std::move(coverages), absences);
          }};
}

}  // namespace slackwater::api::edr
