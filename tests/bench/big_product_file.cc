#include "tests/bench/big_product_file.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "ingest/netcdf/file.h"

namespace slackwater::bench {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

constexpr float fill = 9.96921e36F;
constexpr int period = 2003;  // a prime: no two neighbouring chunks alike

/// Between -1.5 and 1.5 m/s.
float value_of_phase(std::size_t phase) {
  return static_cast<float>(static_cast<int>(phase % period) - 1001) * 0.0015F;
}

int axis(Writer& writer, const std::string& name, int dimension, const std::string& unit,
         const std::string& letter) {
  const int id = writer.variable(name, Type::float32, {dimension});
  writer.attribute(id, "standard_name", name);
  writer.attribute(id, "units", unit);
  writer.attribute(id, "axis", letter);
  return id;
}

}  // namespace

BigProductFile::BigProductFile(std::filesystem::path path, const Shape& shape)
    : path_(std::move(path)), shape_(shape) {}

UtcTime BigProductFile::time(std::size_t t) const {
  return add_hours(parse_utc("2025-03-03T00:00:00Z"), static_cast<double>(t));
}
double BigProductFile::latitude_deg(std::size_t j) { return 30 + static_cast<double>(j) / 32; }
double BigProductFile::longitude_deg(std::size_t i) { return -20 + static_cast<double>(i) / 32; }
double BigProductFile::level_m(std::size_t k) { return 0.5 + 3.0 * static_cast<double>(k); }

float BigProductFile::value(std::size_t component, std::size_t t, std::size_t k, std::size_t j,
                            std::size_t i) const {
  const bool land = i < shape_.columns / 8 && j < shape_.rows / 3;
  const bool below_bed = j > 7 * shape_.rows / 10 && 3 * k > 2 * shape_.levels;
  if (land || below_bed) return std::numeric_limits<float>::quiet_NaN();
  return value_of_phase(997 * component + 7 * t + 13 * k + 3 * j + 5 * i);
}

void BigProductFile::write() const {
  const Shape& s = shape_;
  Writer writer = Writer::create(path_);
  writer.attribute(Writer::global, "Conventions", "CF-1.8");
  writer.attribute(Writer::global, "title", "A large product file for benchmarks");
  writer.attribute(Writer::global, "source", "made from the indices of each value");
  const int time_dimension = writer.dimension("time", s.times);
  const int depth_dimension = writer.dimension("depth", s.levels);
  const int latitude_dimension = writer.dimension("latitude", s.rows);
  const int longitude_dimension = writer.dimension("longitude", s.columns);
  const int time_id = writer.variable("time", Type::float64, {time_dimension});
  writer.attribute(time_id, "standard_name", "time");
  writer.attribute(time_id, "units", "seconds since 1970-01-01T00:00:00Z");
  writer.attribute(time_id, "calendar", "gregorian");
  writer.attribute(time_id, "axis", "T");
  const int depth_id = axis(writer, "depth", depth_dimension, "m", "Z");
  writer.attribute(depth_id, "positive", "down");
  const int latitude_id = axis(writer, "latitude", latitude_dimension, "degrees_north", "Y");
  const int longitude_id = axis(writer, "longitude", longitude_dimension, "degrees_east", "X");
  std::array<int, 2> ids{};
  for (std::size_t c = 0; c < 2; ++c) {
    ids[c] = writer.variable(
        c == 0 ? "uo" : "vo", Type::float32,
        {time_dimension, depth_dimension, latitude_dimension, longitude_dimension},
        {{1, s.chunk_levels, s.chunk_rows, s.chunk_columns}, 0, static_cast<double>(fill)});
    writer.attribute(ids[c], "standard_name",
                     c == 0 ? "eastward_sea_water_velocity" : "northward_sea_water_velocity");
    writer.attribute(ids[c], "units", "m s-1");
  }
  writer.end_definitions();

  const auto write_axis = [&](int id, std::size_t length, auto&& at) {
    std::vector<double> values;
    for (std::size_t n = 0; n < length; ++n) values.push_back(at(n));
    writer.write_all(id, values);
  };
  write_axis(time_id, s.times, [&](std::size_t t) {
    return static_cast<double>(time(t).time_since_epoch().count()) / 1000.0;
  });
  write_axis(depth_id, s.levels, level_m);
  write_axis(latitude_id, s.rows, latitude_deg);
  write_axis(longitude_id, s.columns, longitude_deg);

  std::vector<float> block(s.chunk_levels * s.chunk_rows * s.columns);
  for (std::size_t t = 0; t < s.times; ++t) {
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t k0 = 0; k0 < s.levels; k0 += s.chunk_levels) {
        for (std::size_t j0 = 0; j0 < s.rows; j0 += s.chunk_rows) {
          float* to = block.data();
          for (std::size_t k = k0; k < k0 + s.chunk_levels; ++k) {
            for (std::size_t j = j0; j < j0 + s.chunk_rows; ++j) {
              for (std::size_t i = 0; i < s.columns; ++i) {
                const float v = value(c, t, k, j, i);
                *to++ = std::isnan(v) ? fill : v;
              }
            }
          }
          const std::array start{t, k0, j0, std::size_t{0}};
          const std::array count{std::size_t{1}, s.chunk_levels, s.chunk_rows, s.columns};
          writer.write(ids[c], start, count, std::span<const float>(block));
        }
      }
    }
  }
  writer.close();
}

}  // namespace slackwater::bench
