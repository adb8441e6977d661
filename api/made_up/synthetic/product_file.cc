#include "api/made_up/synthetic/product_file.h"

#include <array>
#include <cmath>
#include <utility>

#include "fields/base/check.h"

namespace slackwater::api {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

constexpr double float_fill = 9.969209968386869e36;
constexpr double short_fill = -32767;
constexpr UtcTime unix_epoch{};

struct AxisAttributes {
  const char* standard_name;
  const char* unit;
  const char* axis;
};

int define_axis(Writer& writer, const std::string& name, int dimension, Type type,
                const AxisAttributes& attributes) {
  const int id = writer.variable(name, type, {dimension});
  writer.attribute(id, "standard_name", attributes.standard_name);
  writer.attribute(id, "units", attributes.unit);
  writer.attribute(id, "axis", attributes.axis);
  return id;
}

/// The bounds of an axis, as copernicusmarine writes them.
void describe_range(Writer& writer, int id, const std::vector<double>& values) {
  writer.attribute(id, "valid_min", std::array{values.front()}, Type::float32);
  writer.attribute(id, "valid_max", std::array{values.back()}, Type::float32);
}

}  // namespace

ProductFile::ProductFile(const std::filesystem::path& path, ProductLayout layout)
    : layout_(std::move(layout)), writer_(Writer::create(path)) {
  expects(!layout_.latitude_deg.empty() && !layout_.longitude_deg.empty(), "a product has a grid");
  writer_.attribute(Writer::global, "Conventions", "CF-1.8");
  writer_.attribute(Writer::global, "title", layout_.title);
  writer_.attribute(Writer::global, "source", layout_.source);
  writer_.attribute(Writer::global, "institution",
                    "Slackwater synthetic ocean (not a measurement)");
  writer_.attribute(Writer::global, "credit",
                    "Synthetic data with known truth, made by Slackwater");
  writer_.attribute(Writer::global, "references", "http://marine.copernicus.eu");
  writer_.attribute(Writer::global, "dataset_id", layout_.dataset_id);

  std::vector<int> plane;
  std::vector<std::size_t> plane_chunk;
  int time_id = -1;
  int depth_id = -1;
  int depth_dimension = -1;
  if (!layout_.time.empty()) {
    const int dimension = writer_.dimension("time", layout_.time.size());
    time_id = define_axis(writer_, "time", dimension, Type::int64,
                          {"time", "seconds since 1970-01-01T00:00:00Z", "T"});
    writer_.attribute(time_id, "calendar", "gregorian");
    plane.push_back(dimension);
    plane_chunk.push_back(1);
  }
  if (!layout_.depth_m.empty()) {
    depth_dimension = writer_.dimension("depth", layout_.depth_m.size());
    depth_id = define_axis(writer_, "depth", depth_dimension, Type::float32, {"depth", "m", "Z"});
    writer_.attribute(depth_id, "positive", "down");
    describe_range(writer_, depth_id, layout_.depth_m);
  }
  const int latitude = writer_.dimension("latitude", layout_.latitude_deg.size());
  const int longitude = writer_.dimension("longitude", layout_.longitude_deg.size());
  const int latitude_id =
      define_axis(writer_, "latitude", latitude, Type::float32, {"latitude", "degrees_north", "Y"});
  const int longitude_id = define_axis(writer_, "longitude", longitude, Type::float32,
                                       {"longitude", "degrees_east", "X"});
  describe_range(writer_, latitude_id, layout_.latitude_deg);
  describe_range(writer_, longitude_id, layout_.longitude_deg);
  int reference_id = -1;
  if (layout_.reference_time) {
    reference_id = writer_.variable("forecast_reference_time", Type::float64, {});
    writer_.attribute(reference_id, "standard_name", "forecast_reference_time");
    writer_.attribute(reference_id, "units", "seconds since 1970-01-01T00:00:00Z");
    writer_.attribute(reference_id, "calendar", "gregorian");
  }

  for (const ProductVariable& variable : layout_.variables) {
    std::vector<int> dimensions = plane;
    std::vector<std::size_t> chunks = plane_chunk;
    if (variable.has_depth) {
      dimensions.push_back(depth_dimension);
      chunks.push_back(layout_.depth_m.size());
    }
    dimensions.insert(dimensions.end(), {latitude, longitude});
    chunks.insert(chunks.end(), {layout_.latitude_deg.size(), layout_.longitude_deg.size()});
    const bool packed = variable.packed_scale.has_value();
    const int id = writer_.variable(
        variable.name, packed ? Type::int16 : Type::float32, dimensions,
        {.chunks = chunks, .deflate = 1, .fill_value = packed ? short_fill : float_fill});
    writer_.attribute(id, "standard_name", variable.standard_name);
    writer_.attribute(id, "long_name", variable.long_name);
    writer_.attribute(id, "units", variable.unit);
    if (packed) {
      writer_.attribute(id, "scale_factor", *variable.packed_scale);
      writer_.attribute(id, "add_offset", variable.packed_offset);
    }
    ids_.push_back(id);
  }
  writer_.end_definitions();

  if (time_id >= 0) {
    std::vector<double> seconds;
    for (const UtcTime time : layout_.time) seconds.push_back(seconds_between(unix_epoch, time));
    writer_.write_all(time_id, seconds);
  }
  if (depth_id >= 0) writer_.write_all(depth_id, layout_.depth_m);
  writer_.write_all(latitude_id, layout_.latitude_deg);
  writer_.write_all(longitude_id, layout_.longitude_deg);
  if (layout_.reference_time) {
    writer_.write_all(reference_id,
                      std::array{seconds_between(unix_epoch, *layout_.reference_time)});
  }
}

void ProductFile::write(std::size_t variable, std::size_t time, std::span<const double> values) {
  const ProductVariable& about = layout_.variables.at(variable);
  std::vector<std::size_t> start;
  std::vector<std::size_t> count;
  if (!layout_.time.empty()) {
    start.push_back(time);
    count.push_back(1);
  }
  if (about.has_depth) {
    start.push_back(0);
    count.push_back(layout_.depth_m.size());
  }
  start.insert(start.end(), {0, 0});
  count.insert(count.end(), {layout_.latitude_deg.size(), layout_.longitude_deg.size()});
  packed_.assign(values.begin(), values.end());
  for (double& value : packed_) {
    if (std::isnan(value)) {
      value = about.packed_scale ? short_fill : float_fill;
    } else if (about.packed_scale) {
      value = std::round((value - about.packed_offset) / *about.packed_scale);
      expects(std::abs(value) < 32767, "a packed value fits into a short");
    }
  }
  writer_.write(ids_.at(variable), start, count, packed_);
}

}  // namespace slackwater::api
