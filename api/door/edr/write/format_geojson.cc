#include "api/door/edr/write/format_geojson.h"

#include <string_view>
#include <utility>
#include <vector>

#include "api/door/edr/sample/answer_shape.h"
#include "api/door/edr/write/describe.h"
#include "api/door/edr/write/json_text.h"
#include "fields/base/error.h"

namespace slackwater::api::edr {
namespace {

/// What a feature says: a place, and where its values stand.
struct Place {
  const Coverage& coverage;
  std::vector<UtcTime> time;
  std::vector<double> vertical_m;
  std::size_t y = 0;
  std::size_t x = 0;
  bool is_vertex = false;
};

class FeatureWriter {
 public:
  explicit FeatureWriter(const Answer& answer) : answer_(answer) {
    names_ = "\"parameter-name\":[";
    for (const Parameter& parameter : answer.parameters) {
      if (names_.back() != '[') names_ += ',';
      append_string(names_, parameter.name);
    }
    names_ += "],\"edrqueryendpoint\":";
    append_string(names_, answer.query_url);
  }

  std::string write() {
    out_ = "{\"type\":\"FeatureCollection\",\"features\":[";
    for (const Coverage& c : answer_.coverages) features(c);
    out_ += "],\"parameters\":[";
    for (std::size_t p = 0; p < answer_.parameters.size(); ++p) {
      if (p > 0) out_ += ',';
      append_parameter(out_, answer_.parameters[p], true);
    }
    out_ += "],\"numberReturned\":" + std::to_string(count_);
    links();
    out_ += ",\"slackwater:provenance\":";
    append_provenance(out_, answer_);
    out_ += '}';
    return std::move(out_);
  }

 private:
  void features(const Coverage& c) {
    if (c.domain == DomainType::trajectory) {
      for (std::size_t i = 0; i < c.longitude_deg.size(); ++i) feature(vertex(c, i));
      return;
    }
    for (std::size_t y = 0; y < c.latitude_deg.size(); ++y) {
      for (std::size_t x = 0; x < c.longitude_deg.size(); ++x) {
        feature({c, c.time, c.vertical_m, y, x, false});
      }
    }
  }

  static Place vertex(const Coverage& c, std::size_t i) {
    Place place{c, {at_vertex(c.time, i)}, {}, i, i, true};
    if (!c.vertical_m.empty()) place.vertical_m = {at_vertex(c.vertical_m, i)};
    return place;
  }

  void feature(const Place& place) {
    if (count_++ > 0) out_ += ',';
    out_ += "{\"type\":\"Feature\",\"id\":" + std::to_string(count_);
    out_ += ",\"geometry\":{\"type\":\"Point\",\"coordinates\":[";
    append_coordinate(out_, place.coverage.longitude_deg[place.x]);
    out_ += ',';
    append_coordinate(out_, place.coverage.latitude_deg[place.y]);
    out_ += "]},\"properties\":{";
    datetime(place.time);
    out_ += ",\"label\":";
    append_string(out_, place.coverage.id.empty() ? answer_.title : place.coverage.id);
    out_ += ',';
    out_ += names_;
    axes(place);
    for (std::size_t p = 0; p < answer_.parameters.size(); ++p) {
      out_ += ',';
      append_string(out_, answer_.parameters[p].name);
      out_ += ':';
      values(place, place.coverage.values[p]);
    }
    out_ += "}}";
  }

  /// The instant, or first/last.
  void datetime(const std::vector<UtcTime>& times) {
    out_ += "\"datetime\":\"";
    if (!times.empty()) append_time(out_, times.front());
    if (times.size() > 1) {
      out_ += '/';
      append_time(out_, times.back());
    }
    out_ += '"';
  }

  void axes(const Place& place) {
    if (!place.time.empty()) {
      out_ += ",\"time\":[";
      for (const UtcTime& time : place.time) {
        out_ += &time == place.time.data() ? "\"" : ",\"";
        append_time(out_, time);
        out_ += '"';
      }
      out_ += ']';
    }
    if (!place.vertical_m.empty()) {
      out_ += ",\"" + std::string(vertical_name(answer_)) + "\":[";
      for (const double& level : place.vertical_m) {
        if (&level != place.vertical_m.data()) out_ += ',';
        append_coordinate(out_, level);
      }
      out_ += ']';
    }
  }

  void values(const Place& place, const std::vector<double>& all) {
    if (place.is_vertex) {
      append_value(out_, all[place.x]);
      return;
    }
    const AxisLengths shape = shape_of(place.coverage);
    if (shape.t > 1) out_ += '[';
    for (std::size_t t = 0; t < shape.t; ++t) {
      if (t > 0) out_ += ',';
      if (shape.z > 1) out_ += '[';
      for (std::size_t z = 0; z < shape.z; ++z) {
        if (z > 0) out_ += ',';
        append_value(out_, all[shape.index(t, z, place.y, place.x)]);
      }
      if (shape.z > 1) out_ += ']';
    }
    if (shape.t > 1) out_ += ']';
  }

  void links() {
    if (answer_.links.empty()) return;
    out_ += ",\"links\":[";
    for (const Answer::Link& link : answer_.links) {
      out_ += out_.back() == '[' ? "{\"rel\":" : ",{\"rel\":";
      append_string(out_, link.rel);
      out_ += ",\"type\":";
      append_string(out_, link.type);
      out_ += ",\"href\":";
      append_string(out_, link.href);
      out_ += '}';
    }
    out_ += ']';
  }

  const Answer& answer_;
  std::string names_;
  std::string out_;
  std::size_t count_ = 0;
};

/// A feature costs some 400 bytes beside its numbers.
constexpr std::size_t most_features = 250'000;

void expect_few_features(const Answer& answer) {
  std::size_t features = 0;
  for (const Coverage& c : answer.coverages) {
    const AxisLengths shape = shape_of(c);
    features += shape.x * shape.y;
  }
  if (features <= most_features) return;
  throw Error(ErrorKind::usage, "f: found 'GeoJSON' for " + std::to_string(features) +
                                    " places; expected at most " + std::to_string(most_features) +
                                    "; ask for fewer, or for f=CoverageJSON or f=NetCDF");
}

}  // namespace

std::string geojson(const Answer& answer) {
  expect_whole(answer);
  expect_few_features(answer);
  return FeatureWriter(answer).write();
}

}  // namespace slackwater::api::edr
