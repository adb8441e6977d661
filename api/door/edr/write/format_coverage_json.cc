#include "api/door/edr/write/format_coverage_json.h"

#include <string_view>
#include <utility>
#include <vector>

#include "api/door/edr/sample/answer_shape.h"
#include "api/door/edr/write/coverage_json_domain.h"
#include "api/door/edr/write/describe.h"
#include "api/door/edr/write/json_text.h"

namespace slackwater::api::edr {
namespace {

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
    append_referencing(out_, answer_);
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
    out_ += "\",";
    const std::vector<std::size_t> kept = append_axes(out_, c);
    if (is_alone) {
      out_ += ',';
      append_referencing(out_, answer_);
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
