#include "api/door/edr/sample/site_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/bbox.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/wkt.h"
#include "api/door/edr/sample/asked_area.h"
#include "api/issued/in_force.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

using SiteForecast = ForecastCatalogue::SiteForecast;

/// A site that has this share of what the best one has is as good as that.
constexpr double as_much = 0.9;
/// What a column stands for around it where the areas of sites are compared, km: the same for all,
/// so that one column that reaches far does not stand for more than a farm of them.
constexpr double about_a_column_km = 1.0;
/// Places along each side of a site's part of an area at which its reach is tried.
constexpr std::size_t tries_per_side = 17;
/// Places along a line.
constexpr std::size_t tries_per_line = 100;

/// What a query points at.
struct Target {
  Box box;
  double longitude_deg = 0;  ///< the place by which it chooses among equals
  double latitude_deg = 0;
  std::optional<AskedArea> shape;  ///< of an area; else
  std::vector<Place> places;       ///< the points, or places along the line
};

Target area_target(AskedArea shape) {
  const Box& box = shape.box;
  return {box,
          0.5 * (box.west_deg + box.east_deg),
          0.5 * (box.south_deg + box.north_deg),
          std::move(shape),
          {}};
}

/// The vertices, and places between them where they are few.
std::vector<Place> places_along(const Path& path) {
  std::vector<Place> places;
  const std::size_t between = std::max<std::size_t>(1, tries_per_line / path.size());
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    for (std::size_t k = 0; k < between; ++k) {
      const double w = static_cast<double>(k) / static_cast<double>(between);
      places.push_back({std::lerp(path[i].longitude_deg, path[i + 1].longitude_deg, w),
                        std::lerp(path[i].latitude_deg, path[i + 1].latitude_deg, w),
                        0,
                        {}});
    }
  }
  places.push_back({path.back().longitude_deg, path.back().latitude_deg, 0, {}});
  return places;
}

Target target_of(const QueryType& type, const QueryString& query) {
  if (type.name == "cube") {
    const auto text = query.find("bbox");
    if (!text)
      throw bad_parameter("bbox", "nothing", "west,south,east,north, e.g. 2.0,53.0,2.5,53.4");
    return area_target(shape_of(parse_bbox(*text).box));
  }
  const auto text = query.find("coords");
  if (!text) throw bad_parameter("coords", "nothing", "Well Known Text, e.g. POINT(-2.55 48.85)");
  Geometry geometry = parse_wkt("coords", *text);
  if (type.name == "area") return area_target(shape_of(std::move(geometry)));
  const Vertex first = geometry.parts.front().front().front();
  if (type.name == "radius") {
    const double radius_m =
        parse_distance_m("within", query.find("within").value_or(""), "within-units",
                         query.find("within-units").value_or(""));
    Target target = area_target(circle(first.longitude_deg, first.latitude_deg, radius_m));
    target.longitude_deg = first.longitude_deg;
    return target;
  }
  Target target{bounding_box(geometry), first.longitude_deg, first.latitude_deg, {}, {}};
  const bool is_line = type.name != "position";
  for (const Part& part : geometry.parts) {
    for (const Path& path : part) {
      if (is_line) {
        const std::vector<Place> places = places_along(path);
        target.places.insert(target.places.end(), places.begin(), places.end());
      } else {
        for (const Vertex& point : path)
          target.places.push_back({point.longitude_deg, point.latitude_deg, 0, {}});
      }
    }
  }
  return target;
}

std::size_t count_reached(const Field& field, const std::vector<Place>& places) {
  std::vector<BedSample> beds(places.size());
  field.sample_bed(places, beds);
  return static_cast<std::size_t>(std::count_if(beds.begin(), beds.end(), [](const BedSample& bed) {
    return bed.status != SampleStatus::outside_area;
  }));
}

/// How much of a shape a field reaches within a box, in square degrees of latitude.
double reached_area(const Field& field, const AskedArea& shape, const Box& cut) {
  if (cut.west_deg > cut.east_deg || cut.south_deg > cut.north_deg) return 0;
  std::vector<Place> places;
  for (std::size_t j = 0; j < tries_per_side; ++j) {
    for (std::size_t i = 0; i < tries_per_side; ++i) {
      const auto share = [](std::size_t n) {
        return (static_cast<double>(n) + 0.5) / tries_per_side;
      };
      const double x = std::lerp(cut.west_deg, cut.east_deg, share(i));
      const double y = std::lerp(cut.south_deg, cut.north_deg, share(j));
      if (shape.is_inside(x, y)) places.push_back({x, y, 0, {}});
    }
  }
  constexpr double least_deg = 1e-9;  // a box may be a line
  const double middle = 0.5 * (cut.south_deg + cut.north_deg) * constants::degree;
  return std::max(least_deg, cut.east_deg - cut.west_deg) * std::cos(middle) *
         std::max(least_deg, cut.north_deg - cut.south_deg) *
         static_cast<double>(count_reached(field, places)) / (tries_per_side * tries_per_side);
}

/// How much of a shape a field reaches at all.
double reached_area(const Field& field, const AskedArea& shape) {
  const slackwater::BoundingBox& area = field.range().box;
  const double east = area.east_deg < area.west_deg ? area.east_deg + 360 : area.east_deg;
  return reached_area(field, shape,
                      shared(shape.box, {area.west_deg, area.south_deg, east, area.north_deg}));
}

/// How much of a shape lies among a field's columns, or about as near as they stand for.
double covered_area(const Field& field, const AskedArea& shape) {
  Box cut{1e9, 1e9, -1e9, -1e9};
  for (const ForecastColumn& column : field.snapshot().columns) {
    const double x = in_box(column.point.longitude_deg(), shape.box);
    const double y = column.point.latitude_deg();
    const double north = about_a_column_km * 1000 / (constants::earth_radius_m * constants::degree);
    const double east = north / std::max(0.01, std::cos(column.point.latitude.radians()));
    cut = {std::min(cut.west_deg, x - east), std::min(cut.south_deg, y - north),
           std::max(cut.east_deg, x + east), std::max(cut.north_deg, y + north)};
  }
  return reached_area(
      field, shape,
      {std::max(cut.west_deg, shape.box.west_deg), std::max(cut.south_deg, shape.box.south_deg),
       std::min(cut.east_deg, shape.box.east_deg), std::min(cut.north_deg, shape.box.north_deg)});
}

std::size_t columns_within(const Field& field, const AskedArea& shape) {
  const auto& columns = field.snapshot().columns;
  return static_cast<std::size_t>(
      std::count_if(columns.begin(), columns.end(), [&](const ForecastColumn& column) {
        const double x = in_box(column.point.longitude_deg(), shape.box);
        const double y = column.point.latitude_deg();
        return contains(shape.box, x, y) && shape.is_inside(x, y);
      }));
}

/// A site that reaches some of the target.
struct Candidate {
  const SiteForecast* site = nullptr;
  double reached = 0;      ///< of the target: an area, or a count of places
  double covered = 0;      ///< of an area, by its columns
  std::size_t within = 0;  ///< columns in the area asked for
};

std::vector<Candidate> candidates_for(const ForecastCatalogue& catalogue, const Target& target) {
  std::vector<Candidate> candidates;
  for (const SiteForecast& site : catalogue.sites) {
    Candidate candidate{&site, 0, 0, 0};
    if (target.shape) {
      candidate.reached = reached_area(*site.field, *target.shape);
      candidate.covered = covered_area(*site.field, *target.shape);
      candidate.within = columns_within(*site.field, *target.shape);
    } else {
      candidate.reached = static_cast<double>(count_reached(*site.field, target.places));
    }
    if (candidate.reached > 0 || candidate.within > 0) candidates.push_back(candidate);
  }
  return candidates;
}

/// The candidate that fits best, as the header says.
const Candidate& best_of(std::vector<Candidate>& candidates, const Target& target) {
  const auto keep_best = [&](double share, auto measure) {
    double most = 0;
    for (const Candidate& c : candidates) most = std::max(most, measure(c));
    std::erase_if(candidates, [&](const Candidate& c) { return measure(c) < share * most; });
  };
  keep_best(as_much, [](const Candidate& c) { return c.covered; });
  keep_best(1, [](const Candidate& c) { return static_cast<double>(c.within); });
  keep_best(as_much, [](const Candidate& c) { return c.reached; });
  std::vector<std::shared_ptr<const Field>> fields;
  fields.reserve(candidates.size());
  for (const Candidate& c : candidates) fields.push_back(c.site->field);
  return candidates[nearest_reaching(fields, target.longitude_deg, target.latitude_deg)
                        .value_or(0)];
}

/// "answered by site farm (columns: 12, in the area asked for: 5); lone reaches some of it too: …".
std::string note_on_choice(const Candidate& best, const std::vector<std::string>& others,
                           bool is_area) {
  std::string note = "answered by site " + best.site->site_id +
                     " (columns: " + std::to_string(best.site->field->snapshot().columns.size());
  if (is_area) note += ", in the area asked for: " + std::to_string(best.within);
  note += "); " + joined(others, ", ") + (others.size() == 1 ? " reaches" : " reach");
  return note + " some of it too: name a site by /locations or an instance";
}

}  // namespace

std::vector<std::string> notes_on(const SiteForecast& site) {
  std::vector<std::string> notes;
  for (const std::string& instance : site.passed_over) {
    notes.push_back("the newer forecast " + instance +
                    " is damaged or cannot be read: this older one is used");
  }
  return notes;
}

SiteChoice site_for(const ForecastCatalogue& catalogue, const QueryType& type,
                    const QueryString& query) {
  const Target target = target_of(type, query);
  std::vector<Candidate> candidates = candidates_for(catalogue, target);
  SiteChoice choice;
  if (candidates.empty()) {
    choice.site = catalogue.site_at(target.longitude_deg, target.latitude_deg);
    for (const SiteForecast& site : catalogue.sites) {
      for (const ForecastColumn& column : site.field->snapshot().columns) {
        if (choice.site == nullptr &&
            contains(target.box, column.point.longitude_deg(), column.point.latitude_deg()))
          choice.site = &site;
      }
    }
  } else {
    std::vector<std::string> reaching;
    reaching.reserve(candidates.size());
    for (const Candidate& candidate : candidates) reaching.push_back(candidate.site->site_id);
    const Candidate& best = best_of(candidates, target);
    choice.site = best.site;
    std::erase(reaching, best.site->site_id);
    if (!reaching.empty())
      choice.notes.push_back(note_on_choice(best, reaching, target.shape.has_value()));
  }
  if (choice.site != nullptr) {
    const std::vector<std::string> damaged = notes_on(*choice.site);
    choice.notes.insert(choice.notes.begin(), damaged.begin(), damaged.end());
  }
  return choice;
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
