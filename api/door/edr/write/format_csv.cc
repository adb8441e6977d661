#include "api/door/edr/write/format_csv.h"

#include <cmath>
#include <string_view>
#include <utility>

#include "api/door/edr/sample/answer_shape.h"
#include "api/door/edr/write/json_text.h"

namespace slackwater::api::edr {
namespace {

class RowWriter {
 public:
  explicit RowWriter(const Answer& answer)
      : answer_(answer), has_level_(has_vertical(answer)), has_time_(has_time(answer)) {}

  std::string write() {
    header();
    for (const Coverage& c : answer_.coverages) {
      if (c.domain == DomainType::trajectory) {
        for (std::size_t i = 0; i < c.longitude_deg.size(); ++i) row(c, i, i, i, i, i);
      } else {
        rows(c);
      }
    }
    return std::move(out_);
  }

 private:
  /// A field, in quotes where it needs them.
  void field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
      out_ += text;
      return;
    }
    out_ += '"';
    for (const char c : text) {
      if (c == '"') out_ += '"';
      out_ += c;
    }
    out_ += '"';
  }

  void header() {
    out_ = "longitude,latitude";
    if (has_level_) (out_ += ',') += vertical_name(answer_);
    if (has_time_) out_ += ",time";
    for (const Parameter& parameter : answer_.parameters) {
      out_ += ',';
      field(parameter.name + (parameter.unit.empty() ? "" : " [" + parameter.unit + "]"));
    }
    out_ += "\r\n";
  }

  void rows(const Coverage& c) {
    const AxisLengths shape = shape_of(c);
    std::size_t index = 0;
    for (std::size_t t = 0; t < shape.t; ++t) {
      for (std::size_t z = 0; z < shape.z; ++z) {
        for (std::size_t y = 0; y < shape.y; ++y) {
          for (std::size_t x = 0; x < shape.x; ++x) row(c, t, z, y, x, index++);
        }
      }
    }
  }

  void row(const Coverage& c, std::size_t t, std::size_t z, std::size_t y, std::size_t x,
           std::size_t index) {
    append_coordinate(out_, c.longitude_deg[x]);
    out_ += ',';
    append_coordinate(out_, c.latitude_deg[y]);
    if (has_level_) {
      out_ += ',';
      if (!c.vertical_m.empty()) append_coordinate(out_, at_vertex(c.vertical_m, z));
    }
    if (has_time_) {
      out_ += ',';
      if (!c.time.empty()) append_time(out_, at_vertex(c.time, t));
    }
    for (const auto& values : c.values) {
      out_ += ',';
      if (std::isfinite(values[index])) append_value(out_, values[index]);
    }
    out_ += "\r\n";
  }

  const Answer& answer_;
  bool has_level_;
  bool has_time_;
  std::string out_;
};

}  // namespace

std::string csv(const Answer& answer) {
  expect_whole(answer);
  return RowWriter(answer).write();
}

}  // namespace slackwater::api::edr
