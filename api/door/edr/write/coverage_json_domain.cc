#include "api/door/edr/write/coverage_json_domain.h"

#include <unordered_set>

#include "api/door/edr/read/crs.h"
#include "api/door/edr/sample/answer_shape.h"
#include "api/door/edr/write/json_text.h"

namespace slackwater::api::edr {
namespace {

void append_coordinates(std::string& out, std::string_view name,
                        const std::vector<double>& values) {
  out += '"';
  out += name;
  out += "\":{\"values\":[";
  Separator separator(out);
  for (const double value : values) {
    separator.next();
    append_coordinate(out, value);
  }
  out += "]}";
}

void append_times(std::string& out, const std::vector<UtcTime>& times) {
  out += "\"t\":{\"values\":[";
  Separator separator(out);
  for (const UtcTime time : times) {
    separator.next();
    out += '"';
    append_time(out, time);
    out += '"';
  }
  out += "]},";
}

std::string vertex_of(const Coverage& c, std::size_t i, bool has_z) {
  std::string tuple = "[\"";
  append_time(tuple, at_vertex(c.time, i));
  tuple += "\",";
  append_coordinate(tuple, c.longitude_deg[i]);
  tuple += ',';
  append_coordinate(tuple, c.latitude_deg[i]);
  if (has_z) {
    tuple += ',';
    append_coordinate(tuple, c.vertical_m[i]);
  }
  return tuple + "]";
}

/// The composite axis of a trajectory, and z beside it where it is one for all.
std::vector<std::size_t> append_composite(std::string& out, const Coverage& c) {
  const bool has_z = c.vertical_m.size() > 1;
  out += R"("composite":{"dataType":"tuple","coordinates":["t","x","y")";
  out += has_z ? ",\"z\"],\"values\":[" : "],\"values\":[";
  Separator separator(out);
  std::vector<std::size_t> kept;
  std::unordered_set<std::string> seen;
  for (std::size_t i = 0; i < c.longitude_deg.size(); ++i) {
    if (std::string tuple = vertex_of(c, i, has_z); seen.insert(tuple).second) {
      separator.next();
      out += tuple;
      kept.push_back(i);
    }
  }
  out += "]}";
  if (c.vertical_m.size() == 1) {
    out += ',';
    append_coordinates(out, "z", c.vertical_m);
  }
  return kept;
}

void append_vertical_system(std::string& out, bool is_depth) {
  out += R"(,{"coordinates":["z"],"system":{"type":"VerticalCRS","name":{"en":")";
  out += is_depth ? "Depth below mean sea level" : "Height above mean sea level";
  out += R"("},"cs":{"csAxes":[{"name":{"en":")";
  out += is_depth ? "Depth" : "Height";
  out += R"("},"direction":")";
  out += is_depth ? "down" : "up";
  out += R"(","unit":{"label":{"en":"metre"},"symbol":{"value":"m",)"
         R"("type":"http://www.opengis.net/def/uom/UCUM/"}}}]}}})";
}

}  // namespace

std::string_view name_of(DomainType type) noexcept {
  switch (type) {
    case DomainType::point:
      return "Point";
    case DomainType::point_series:
      return "PointSeries";
    case DomainType::vertical_profile:
      return "VerticalProfile";
    case DomainType::grid:
      return "Grid";
    case DomainType::trajectory:
      return "Trajectory";
  }
  return "Grid";
}

std::vector<std::size_t> append_axes(std::string& out, const Coverage& coverage) {
  out += "\"axes\":{";
  std::vector<std::size_t> kept;
  if (coverage.domain == DomainType::trajectory) {
    kept = append_composite(out, coverage);
  } else {
    if (!coverage.time.empty()) append_times(out, coverage.time);
    append_coordinates(out, "x", coverage.longitude_deg);
    out += ',';
    append_coordinates(out, "y", coverage.latitude_deg);
    if (!coverage.vertical_m.empty()) {
      out += ',';
      append_coordinates(out, "z", coverage.vertical_m);
    }
  }
  out += '}';
  return kept;
}

void append_referencing(std::string& out, const Answer& answer) {
  out += R"("referencing":[{"coordinates":["x","y"],"system":{"type":"GeographicCRS","id":")";
  out += crs84_uri;
  out += "\"}}";
  if (has_vertical(answer)) append_vertical_system(out, answer.vertical == Vertical::depth_down);
  if (has_time(answer)) {
    out += R"(,{"coordinates":["t"],"system":{"type":"TemporalRS","calendar":"Gregorian"}})";
  }
  out += ']';
}

}  // namespace slackwater::api::edr
