#include "api/edr/format_coverage_json.h"

#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "api/edr/answer_shape.h"
#include "api/edr/crs.h"
#include "api/edr/describe.h"
#include "api/edr/json_text.h"

namespace slackwater::api::edr {
namespace {

std::string_view name_of(DomainType type) {
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

/// Puts a comma before every item but the first.
class Separator {
 public:
  explicit Separator(std::string& out) : out_(out) {}
  void next() {
    if (!is_first_) out_ += ',';
    is_first_ = false;
  }

 private:
  std::string& out_;
  bool is_first_ = true;
};

class CoverageWriter {
 public:
  explicit CoverageWriter(const Answer& answer) : answer_(answer) {
    std::size_t numbers = 0;
    for (const Coverage& c : answer.coverages) {
      numbers += shape_of(c).size() * (answer.parameters.size() + 1) + 200;
    }
    out_.reserve(numbers * 9 + answer.parameters.size() * 512 + 2048);
  }

  std::string write() {
    if (answer_.coverages.size() == 1) {
      coverage(answer_.coverages.front(), true);
    } else {
      collection();
    }
    return std::move(out_);
  }

 private:
  void collection() {
    out_ += "{\"type\":\"CoverageCollection\",";
    if (!answer_.coverages.empty()) {
      out_ += "\"domainType\":\"";
      out_ += name_of(answer_.coverages.front().domain);
      out_ += "\",";
    }
    parameters();
    out_ += ',';
    referencing();
    out_ += ",\"coverages\":[";
    Separator separator(out_);
    for (const Coverage& c : answer_.coverages) {
      separator.next();
      coverage(c, false);
    }
    out_ += ']';
    provenance();
    out_ += '}';
  }

  /// @param is_alone  whether it states parameters, reference systems and provenance itself
  void coverage(const Coverage& c, bool is_alone) {
    out_ += "{\"type\":\"Coverage\",";
    if (!c.id.empty()) {
      out_ += "\"id\":";
      append_string(out_, c.id);
      out_ += ',';
    }
    out_ += "\"domain\":{\"type\":\"Domain\",\"domainType\":\"";
    out_ += name_of(c.domain);
    out_ += "\",\"axes\":{";
    std::vector<std::size_t> kept;
    if (c.domain == DomainType::trajectory) {
      kept = composite(c);
    } else {
      axes(c);
    }
    out_ += '}';
    if (is_alone) {
      out_ += ',';
      referencing();
    }
    out_ += "},";
    if (is_alone) {
      parameters();
      out_ += ',';
    }
    ranges(c, kept);
    if (is_alone) provenance();
    out_ += '}';
  }

  void coordinates(std::string_view name, const std::vector<double>& values) {
    out_ += '"';
    out_ += name;
    out_ += "\":{\"values\":[";
    Separator separator(out_);
    for (const double value : values) {
      separator.next();
      append_coordinate(out_, value);
    }
    out_ += "]}";
  }

  void time_text(UtcTime time) {
    out_ += '"';
    append_time(out_, time);
    out_ += '"';
  }

  void axes(const Coverage& c) {
    if (!c.time.empty()) {
      out_ += "\"t\":{\"values\":[";
      Separator separator(out_);
      for (const UtcTime time : c.time) {
        separator.next();
        time_text(time);
      }
      out_ += "]},";
    }
    coordinates("x", c.longitude_deg);
    out_ += ',';
    coordinates("y", c.latitude_deg);
    if (!c.vertical_m.empty()) {
      out_ += ',';
      coordinates("z", c.vertical_m);
    }
  }

  /// The composite axis of a trajectory, and z beside it where it is one for all.
  /// @return the vertices that it holds, each tuple once
  std::vector<std::size_t> composite(const Coverage& c) {
    const bool has_z = c.vertical_m.size() > 1;
    out_ += R"("composite":{"dataType":"tuple","coordinates":["t","x","y")";
    out_ += has_z ? ",\"z\"],\"values\":[" : "],\"values\":[";
    Separator separator(out_);
    std::vector<std::size_t> kept;
    std::unordered_set<std::string> seen;
    for (std::size_t i = 0; i < c.longitude_deg.size(); ++i) {
      if (std::string tuple = vertex(c, i, has_z); seen.insert(tuple).second) {
        separator.next();
        out_ += tuple;
        kept.push_back(i);
      }
    }
    out_ += "]}";
    if (c.vertical_m.size() == 1) {
      out_ += ',';
      coordinates("z", c.vertical_m);
    }
    return kept;
  }

  static std::string vertex(const Coverage& c, std::size_t i, bool has_z) {
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

  void referencing() {
    out_ += R"("referencing":[{"coordinates":["x","y"],"system":{"type":"GeographicCRS","id":")";
    out_ += crs84_uri;
    out_ += "\"}}";
    if (has_vertical(answer_)) vertical_system();
    if (has_time(answer_)) {
      out_ += R"(,{"coordinates":["t"],"system":{"type":"TemporalRS","calendar":"Gregorian"}})";
    }
    out_ += ']';
  }

  void vertical_system() {
    const bool is_depth = answer_.vertical == Vertical::depth_down;
    out_ += R"(,{"coordinates":["z"],"system":{"type":"VerticalCRS","name":{"en":")";
    out_ += is_depth ? "Depth below mean sea level" : "Height above mean sea level";
    out_ += R"("},"cs":{"csAxes":[{"name":{"en":")";
    out_ += is_depth ? "Depth" : "Height";
    out_ += R"("},"direction":")";
    out_ += is_depth ? "down" : "up";
    out_ += R"(","unit":{"label":{"en":"metre"},"symbol":{"value":"m",)"
            R"("type":"http://www.opengis.net/def/uom/UCUM/"}}}]}}})";
  }

  void parameters() {
    out_ += "\"parameters\":{";
    Separator separator(out_);
    for (const Parameter& parameter : answer_.parameters) {
      separator.next();
      append_string(out_, parameter.name);
      out_ += ':';
      append_parameter(out_, parameter, false);
    }
    out_ += '}';
  }

  /// `"shape":[...],"axisNames":[...]`, the same for all parameters of a coverage.
  static std::string axes_of_ranges(const Coverage& c, std::size_t vertices) {
    std::string shape;
    std::string names;
    const auto add = [&](std::string_view name, std::size_t length) {
      shape += (shape.empty() ? "" : ",") + std::to_string(length);
      names += (names.empty() ? "\"" : ",\"") + std::string(name) + "\"";
    };
    const bool is_grid = c.domain == DomainType::grid;
    if (c.domain == DomainType::trajectory) add("composite", vertices);
    if (c.domain == DomainType::point_series || (is_grid && !c.time.empty())) {
      add("t", c.time.size());
    }
    if (c.domain == DomainType::vertical_profile || (is_grid && !c.vertical_m.empty())) {
      add("z", c.vertical_m.size());
    }
    if (is_grid) add("y", c.latitude_deg.size());
    if (is_grid) add("x", c.longitude_deg.size());
    return "\"shape\":[" + shape + "],\"axisNames\":[" + names + "]";
  }

  void ranges(const Coverage& c, const std::vector<std::size_t>& kept) {
    const std::string axes = axes_of_ranges(c, kept.size());
    out_ += "\"ranges\":{";
    Separator separator(out_);
    for (std::size_t p = 0; p < answer_.parameters.size(); ++p) {
      separator.next();
      append_string(out_, answer_.parameters[p].name);
      out_ += R"(:{"type":"NdArray","dataType":"float",)";
      out_ += axes;
      out_ += ",\"values\":[";
      values(c.values[p], kept);
      out_ += "]}";
    }
    out_ += '}';
  }

  /// All values, or those at the vertices kept.
  void values(const std::vector<double>& all, const std::vector<std::size_t>& kept) {
    Separator separator(out_);
    if (kept.empty()) {
      for (const double value : all) {
        separator.next();
        append_value(out_, value);
      }
    }
    for (const std::size_t i : kept) {
      separator.next();
      append_value(out_, all[i]);
    }
  }

  void provenance() {
    out_ += ",\"slackwater:provenance\":";
    append_provenance(out_, answer_);
  }

  const Answer& answer_;
  std::string out_;
};

}  // namespace

std::string coverage_json(const Answer& answer) {
  expect_whole(answer);
  return CoverageWriter(answer).write();
}

}  // namespace slackwater::api::edr
