#include "api/door/edr/sample/coverages.h"

#include <cmath>
#include <set>
#include <variant>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "fields/service/wave_source.h"

namespace slackwater::api::edr {
namespace {

/// The axis that a domain shows: nothing where there is no vertical.
std::vector<double> shown_axis(const std::vector<double>& verticals) {
  if (verticals.size() == 1 && std::isnan(verticals[0])) return {};
  return verticals;
}

/// What a collection without a vertical is sampled at.
double sampled(double vertical) { return std::isnan(vertical) ? 0.0 : vertical; }

/// "product forecast and harmonic tide": all that any column has.
std::string level_sources_text(const Snapshot& forecast) {
  std::set<std::string_view> sources;
  for (const ForecastColumn& column : forecast.columns)
    for (const DataStatus source : column.sea_level.source)
      sources.insert(text_of_level_source(source));
  return joined(std::vector<std::string_view>(sources.begin(), sources.end()), " and ");
}

}  // namespace

DomainType domain_at_point(std::size_t times, std::size_t verticals) {
  if (times > 1 && verticals > 1) return DomainType::grid;
  if (verticals > 1) return DomainType::vertical_profile;
  return times > 1 ? DomainType::point_series : DomainType::point;
}

Coverage at_point(const Selection& s, double longitude_deg, double latitude_deg,
                  const std::vector<UtcTime>& times, const std::vector<double>& verticals,
                  Absences& absences) {
  std::vector<Place> places;
  places.reserve(times.size() * verticals.size());
  for (const UtcTime time : times) {
    for (const double z : verticals)
      places.push_back({longitude_deg, latitude_deg, sampled(z), time});
  }
  Coverage coverage;
  coverage.longitude_deg = {longitude_deg};
  coverage.latitude_deg = {latitude_deg};
  coverage.vertical_m = shown_axis(verticals);
  coverage.time = times;
  coverage.domain = domain_at_point(times.size(), coverage.vertical_m.size());
  sample(*s.collection, *s.field, s.parameters, places, coverage.values, absences);
  return coverage;
}

Coverage on_grid(const Selection& s, std::vector<double> longitude_deg,
                 std::vector<double> latitude_deg, const std::vector<UtcTime>& times,
                 const std::vector<double>& verticals,
                 const std::function<bool(double, double)>& is_wanted, Absences& absences) {
  Coverage coverage;
  coverage.domain = DomainType::grid;
  coverage.longitude_deg = std::move(longitude_deg);
  coverage.latitude_deg = std::move(latitude_deg);
  coverage.vertical_m = shown_axis(verticals);
  coverage.time = times;
  const std::size_t cells = coverage.longitude_deg.size() * coverage.latitude_deg.size();
  std::vector<Place> wanted;
  std::vector<std::size_t> cell;
  for (std::size_t j = 0; j < coverage.latitude_deg.size(); ++j) {
    for (std::size_t i = 0; i < coverage.longitude_deg.size(); ++i) {
      if (!is_wanted(coverage.longitude_deg[i], coverage.latitude_deg[j])) continue;
      cell.push_back(j * coverage.longitude_deg.size() + i);
      wanted.push_back({coverage.longitude_deg[i], coverage.latitude_deg[j], 0, {}});
    }
  }
  const std::size_t slices = times.size() * verticals.size();
  coverage.values.assign(s.parameters.size(), std::vector<double>(slices * cells, constants::nan));
  std::size_t slice = 0;
  for (const UtcTime time : times) {
    for (const double z : verticals) {
      for (Place& place : wanted) {
        place.vertical_m = sampled(z);
        place.time = time;
      }
      std::vector<std::vector<double>> found;
      sample(*s.collection, *s.field, s.parameters, wanted, found, absences);
      for (std::size_t p = 0; p < found.size(); ++p) {
        for (std::size_t c = 0; c < cell.size(); ++c)
          coverage.values[p][slice * cells + cell[c]] = found[p][c];
      }
      ++slice;
    }
  }
  return coverage;
}

Coverage along(const Selection& s, std::span<const Vertex> vertices, const std::string& id,
               Absences& absences) {
  Coverage coverage;
  coverage.domain = DomainType::trajectory;
  coverage.id = id;
  std::vector<Place> places;
  for (const Vertex& vertex : vertices) {
    coverage.longitude_deg.push_back(vertex.longitude_deg);
    coverage.latitude_deg.push_back(vertex.latitude_deg);
    coverage.time.push_back(vertex.time);
    if (s.collection->vertical != Vertical::none) coverage.vertical_m.push_back(vertex.vertical);
    places.push_back({vertex.longitude_deg, vertex.latitude_deg, vertex.vertical, vertex.time});
  }
  sample(*s.collection, *s.field, s.parameters, places, coverage.values, absences);
  return coverage;
}

Answer answer_of(Selection s, std::vector<Coverage> coverages, const Absences& absences) {
  Answer answer = std::move(s.answer);
  const std::vector<std::string> why_missing = notes_of(absences, *s.field);
  answer.notes.insert(answer.notes.end(), why_missing.begin(), why_missing.end());
  const Snapshot& snapshot = s.field->snapshot();
  if (snapshot.averaged && s.collection->vertical == Vertical::depth_down)
    answer.notes.push_back(sentence_of(*snapshot.averaged));
  if (snapshot.hindsight) {
    answer.notes.emplace_back(
        "made in hindsight: wind or waves were used that were not known at the issue time");
  }
  if (snapshot.simulated_wind) {
    answer.notes.emplace_back(
        "driven by a simulated wind forecast: none published by the issue time is stored");
  }
  if (std::holds_alternative<Quantities<SeaSample>>(s.collection->quantities) &&
      !has_given_waves_only(snapshot)) {
    answer.notes.push_back("source of the waves: " + wave_sources_text(snapshot));
  }
  if (std::holds_alternative<Quantities<SeaLevelSample>>(s.collection->quantities))
    answer.notes.push_back("source of the level: " + level_sources_text(snapshot));
  answer.coverages = std::move(coverages);
  return answer;
}

}  // namespace slackwater::api::edr
