#include "ingest/cf/forecast/sampled_file_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast/forecast_names.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {
namespace {

using netcdf::Type;
using netcdf::Writer;

std::string fit_name(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  const bool has_letter = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  return has_letter ? name : "v" + name;
}

std::size_t at_least_one(std::size_t length) { return std::max<std::size_t>(1, length); }

void expect_whole(const SampledFile& c) {
  const std::size_t places = c.longitude_deg.size();
  expects(places > 0 && !c.latitude_deg.empty(), "a coverage has a place");
  std::size_t size = at_least_one(c.time.size()) * at_least_one(c.vertical_m.size());
  switch (c.layout) {
    case CoverageLayout::stations:
      expects(c.latitude_deg.size() == places && c.names.size() == places,
              "a station has both coordinates and a name");
      size *= places;
      break;
    case CoverageLayout::grid:
      size *= places * c.latitude_deg.size();
      break;
    case CoverageLayout::trajectories: {
      std::size_t vertices = 0;
      for (const std::size_t length : c.lengths) vertices += length;
      expects(c.latitude_deg.size() == places && c.time.size() == places && vertices == places &&
                  (c.vertical_m.empty() || c.vertical_m.size() == places) &&
                  c.names.size() == c.lengths.size(),
              "a vertex has coordinates and a time, a trajectory a length and a name");
      size = places;
    }
  }
  for (const CoverageVariable& variable : c.variables) {
    expects(variable.values.size() == size, "a variable has a value at each point");
  }
}

/// One file being written: the coverage with the ids of what was defined.
class CoverageWriter {
 public:
  CoverageWriter(const std::filesystem::path& file, const SampledFile& coverage)
      : out_(Writer::create(file)), c_(coverage) {}

  void write() {
    define_dimensions();
    define_coordinates();
    for (const CoverageVariable& variable : c_.variables) define(variable);
    describe();
    out_.end_definitions();
    write_coordinates();
    for (std::size_t v = 0; v < c_.variables.size(); ++v) {
      write_values(ids_[v], c_.variables[v].values);
    }
    out_.close();
  }

 private:
  bool is(CoverageLayout layout) const { return c_.layout == layout; }
  bool has_names() const { return !c_.names.empty() && !is(CoverageLayout::grid); }
  bool is_single_station() const {
    return is(CoverageLayout::stations) && c_.longitude_deg.size() == 1;
  }

  void define_dimensions() {
    if (is(CoverageLayout::trajectories)) {
      instance_ = {out_.dimension("trajectory", c_.lengths.size())};
      data_ = {out_.dimension("obs", c_.longitude_deg.size())};
      latitude_ = longitude_ = vertical_ = time_ = data_;
    } else {
      if (is(CoverageLayout::stations) && !is_single_station()) {
        instance_ = data_ = {out_.dimension("station", c_.longitude_deg.size())};
      }
      add_axis("time", c_.time.size(), time_);
      add_axis(vertical_name(), c_.vertical_m.size(), vertical_);
      if (is(CoverageLayout::grid)) {
        add_axis("latitude", c_.latitude_deg.size(), latitude_);
        add_axis("longitude", c_.longitude_deg.size(), longitude_);
      } else {
        latitude_ = longitude_ = instance_;
      }
    }
    if (!has_names()) return;
    std::size_t longest = 1;
    for (const std::string& name : c_.names) longest = std::max(longest, name.size());
    text_length_ = longest;
    text_ = out_.dimension("name_length", longest);
  }

  void add_axis(const std::string& name, std::size_t length, std::vector<int>& dimensions) {
    if (length == 0) return;
    dimensions = {out_.dimension(name, length)};
    data_.push_back(dimensions.front());
  }

  /// CF's "height" counts from the surface; heights of ours count from the geoid, as "altitude"
  /// does.
  std::string vertical_name() const { return c_.is_depth ? "depth" : "altitude"; }

  int define_coordinate(const std::string& name, const std::vector<int>& dimensions,
                        const std::string& long_name, const std::string& units) {
    const int id = out_.variable(name, Type::float64, dimensions);
    out_.attribute(id, "standard_name", name);
    out_.attribute(id, "long_name", long_name);
    out_.attribute(id, "units", units);
    return id;
  }

  void define_coordinates() {
    const bool is_axis = !is(CoverageLayout::trajectories);
    longitude_id_ = define_coordinate("longitude", longitude_, "longitude", "degrees_east");
    latitude_id_ = define_coordinate("latitude", latitude_, "latitude", "degrees_north");
    if (!c_.time.empty()) {
      time_id_ = define_coordinate("time", time_, "valid time", epoch);
      out_.attribute(time_id_, "calendar", "standard");
      if (is_axis) out_.attribute(time_id_, "axis", "T");
    }
    if (!c_.vertical_m.empty()) {
      vertical_id_ = define_coordinate(
          vertical_name(), vertical_,
          c_.is_depth ? "depth below mean sea level" : "height above mean sea level", "m");
      out_.attribute(vertical_id_, "positive", c_.is_depth ? "down" : "up");
      if (is_axis) out_.attribute(vertical_id_, "axis", "Z");
    }
    if (c_.reference_time) {
      reference_id_ =
          define_coordinate("forecast_reference_time", {}, "end of the last calibrated day", epoch);
      out_.attribute(reference_id_, "calendar", "standard");
    }
    if (has_names()) define_names();
  }

  void define_names() {
    const bool is_station = is(CoverageLayout::stations);
    std::vector<int> dimensions = instance_;
    dimensions.push_back(text_);
    name_id_ = out_.variable(name_variable(), Type::character, dimensions);
    out_.attribute(name_id_, "long_name", is_station ? "name of the place" : "name of the line");
    out_.attribute(name_id_, "cf_role", is_station ? "timeseries_id" : "trajectory_id");
    if (is_station) return;
    length_id_ = out_.variable("row_size", Type::int32, instance_);
    out_.attribute(length_id_, "long_name", "number of vertices of the line");
    out_.attribute(length_id_, "sample_dimension", "obs");
  }

  std::string name_variable() const {
    return is(CoverageLayout::stations) ? "station_name" : "trajectory_name";
  }

  void define(const CoverageVariable& variable) {
    Writer::Layout layout;
    layout.fill_value = forecast_names::fill;
    const int id = out_.variable(fit_name(variable.name), Type::float64, data_, layout);
    if (!variable.standard_name.empty()) {
      out_.attribute(id, "standard_name", variable.standard_name);
    }
    out_.attribute(id, "long_name", variable.long_name);
    if (!variable.units.empty()) out_.attribute(id, "units", variable.units);
    std::string coordinates;
    if (!is(CoverageLayout::grid)) coordinates = "latitude longitude";
    if (is(CoverageLayout::trajectories)) {
      coordinates += c_.vertical_m.empty() ? " time" : " time " + vertical_name();
    }
    if (is(CoverageLayout::stations)) coordinates += " " + name_variable();
    if (c_.reference_time) coordinates += " forecast_reference_time";
    while (coordinates.starts_with(' ')) coordinates.erase(0, 1);
    if (!coordinates.empty()) out_.attribute(id, "coordinates", coordinates);
    ids_.push_back(id);
  }

  void describe() {
    out_.attribute(Writer::global, "Conventions", "CF-1.8");
    if (is(CoverageLayout::trajectories)) {
      out_.attribute(Writer::global, "featureType", "trajectory");
    } else if (is(CoverageLayout::stations) && !c_.time.empty()) {
      out_.attribute(Writer::global, "featureType",
                     c_.vertical_m.empty() ? "timeSeries" : "timeSeriesProfile");
    }
    for (const auto& [name, text] : c_.global_attributes) {
      out_.attribute(Writer::global, name, text);
    }
  }

  void write_coordinates() {
    out_.write_all(longitude_id_, c_.longitude_deg);
    out_.write_all(latitude_id_, c_.latitude_deg);
    if (!c_.vertical_m.empty()) out_.write_all(vertical_id_, c_.vertical_m);
    std::vector<double> time_s;
    for (const UtcTime time : c_.time) time_s.push_back(seconds_between(UtcTime{}, time));
    if (!time_s.empty()) out_.write_all(time_id_, time_s);
    if (c_.reference_time) {
      out_.write_all(reference_id_,
                     std::vector<double>{seconds_between(UtcTime{}, *c_.reference_time)});
    }
    if (has_names()) write_names();
    if (is(CoverageLayout::trajectories)) {
      out_.write_all(length_id_, std::vector<double>(c_.lengths.begin(), c_.lengths.end()));
    }
  }

  void write_names() {
    std::string all;
    for (const std::string& name : c_.names) {
      all += name;
      all.append(text_length_ - name.size(), '\0');
    }
    out_.write_text(name_id_, all);
  }

  void write_values(int id, std::vector<double> values) {
    for (double& value : values) {
      if (!std::isfinite(value)) value = forecast_names::fill;
    }
    out_.write_all(id, values);
  }

  static constexpr const char* epoch = "seconds since 1970-01-01 00:00:00";

  Writer out_;
  const SampledFile& c_;
  std::vector<int> instance_, time_, vertical_, latitude_, longitude_;  ///< dimensions
  std::vector<int> data_;  ///< dimensions of the variables
  int text_ = 0;
  std::size_t text_length_ = 1;
  int longitude_id_ = 0, latitude_id_ = 0, vertical_id_ = 0, time_id_ = 0, reference_id_ = 0,
      name_id_ = 0, length_id_ = 0;
  std::vector<int> ids_;
};

}  // namespace

void write_coverage(const std::filesystem::path& file, const SampledFile& coverage) {
  expect_whole(coverage);
  with_context("writing " + file.string(), [&] { CoverageWriter(file, coverage).write(); });
}

}  // namespace slackwater::ingest
