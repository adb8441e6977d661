#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/error.h"
#include "ingest/cf/granule_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/gridded.h"
#include "ingest/netcdf/file.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::tests {

/// A product file of one variable on a small grid, with every oddity a knob. As it stands it is a
/// sound file of hourly eastward currents.
struct TinyProduct {
  using Type = netcdf::Type;
  using Writer = netcdf::Writer;

  std::vector<double> time{0, 1, 2};
  std::string time_units = "hours since 2024-03-01 00:00:00";
  std::string calendar = "standard";
  Type time_type = Type::float64;
  std::vector<double> depth{0.5, 10.0};
  std::string depth_name = "depth";
  std::optional<std::string> depth_units = "m";
  std::optional<std::string> depth_positive = "down";
  Type depth_type = Type::float32;
  std::vector<double> latitude{50, 51, 52};
  std::vector<double> longitude{1, 2, 3, 4};
  std::string name = "uo";
  std::string standard_name = "eastward_sea_water_velocity";
  std::optional<std::string> unit = "m s-1";
  Type type = Type::float32;
  std::optional<double> fill;
  std::vector<std::string> order{"time", "depth", "latitude", "longitude"};
  std::map<std::string, std::string> global;
  /// Raw value at (time, level, row, column), indices along the vectors above.
  std::function<double(std::size_t, std::size_t, std::size_t, std::size_t)> value =
      [](std::size_t t, std::size_t k, std::size_t j, std::size_t i) {
        return 0.1 * static_cast<double>(t) + 0.01 * static_cast<double>(k) +
               0.001 * static_cast<double>(j) + 0.0001 * static_cast<double>(i);
      };
  /// Further definitions: attributes of the variable, other variables; returns what to write
  /// afterwards.
  std::function<std::function<void(Writer&)>(Writer&, int variable,
                                             const std::map<std::string, int>& dimensions)>
      more;

  void write(const std::filesystem::path& path) const {
    Writer writer = Writer::create(path);
    std::map<std::string, int> dimensions;
    std::map<std::string, int> coordinates;
    const auto axis = [&](const std::string& axis_name, const std::vector<double>& values,
                          Type axis_type) {
      const bool used = std::find(order.begin(), order.end(), axis_name) != order.end();
      if (values.empty()) return -1;
      std::vector<int> along;
      if (used) along = {dimensions[axis_name] = writer.dimension(axis_name, values.size())};
      return coordinates[axis_name] = writer.variable(axis_name, axis_type, along);
    };
    const int time_id = axis("time", time, time_type);
    if (time_id >= 0) {
      writer.attribute(time_id, "standard_name", "time");
      writer.attribute(time_id, "units", time_units);
      writer.attribute(time_id, "calendar", calendar);
    }
    const int depth_id = axis(depth_name, depth, depth_type);
    if (depth_id >= 0) {
      if (depth_units) writer.attribute(depth_id, "units", *depth_units);
      if (depth_positive) writer.attribute(depth_id, "positive", *depth_positive);
    }
    const int latitude_id = axis("latitude", latitude, Type::float64);
    writer.attribute(latitude_id, "units", "degrees_north");
    const int longitude_id = axis("longitude", longitude, Type::float64);
    writer.attribute(longitude_id, "units", "degrees_east");

    std::vector<int> shape;
    for (const std::string& dimension : order) shape.push_back(dimensions.at(dimension));
    Writer::Layout layout;
    layout.fill_value = fill;
    const int id = writer.variable(name, type, shape, layout);
    if (!standard_name.empty()) writer.attribute(id, "standard_name", standard_name);
    if (unit) writer.attribute(id, "units", *unit);
    writer.attribute(id, "coordinates", "time " + depth_name + " latitude longitude");
    for (const auto& [key, text] : global) writer.attribute(Writer::global, key, text);
    std::function<void(Writer&)> afterwards;
    if (more) afterwards = more(writer, id, dimensions);
    writer.end_definitions();
    if (time_id >= 0) writer.write_all(time_id, time);
    if (depth_id >= 0) writer.write_all(depth_id, depth);
    writer.write_all(latitude_id, latitude);
    writer.write_all(longitude_id, longitude);
    writer.write_all(id, values());
    if (afterwards) afterwards(writer);
    writer.close();
  }

 private:
  [[nodiscard]] std::vector<double> values() const {
    const std::map<std::string, std::size_t> lengths{
        {"time", std::max<std::size_t>(time.size(), 1)},
        {depth_name, std::max<std::size_t>(depth.size(), 1)},
        {"latitude", latitude.size()},
        {"longitude", longitude.size()}};
    std::size_t size = 1;
    for (const std::string& dimension : order) size *= lengths.at(dimension);
    std::vector<double> all(size);
    for (std::size_t n = 0; n < size; ++n) {
      std::map<std::string, std::size_t> at{
          {"time", 0}, {depth_name, 0}, {"latitude", 0}, {"longitude", 0}};
      std::size_t rest = n;
      for (auto dimension = order.rbegin(); dimension != order.rend(); ++dimension) {
        at[*dimension] = rest % lengths.at(*dimension);
        rest /= lengths.at(*dimension);
      }
      all[n] = value(at["time"], at[depth_name], at["latitude"], at["longitude"]);
    }
    return all;
  }
};

inline const ProductCatalogue& products() {
  static const ProductCatalogue catalogue =
      ProductCatalogue::load(slackwater::tests::source_folder() / "data" / "products");
  return catalogue;
}

/// A decoded file with its folder.
struct Decoded {
  std::unique_ptr<slackwater::tests::TemporaryFolder> folder;
  Ingested ingested;

  [[nodiscard]] const Granule& granule(std::size_t n = 0) const {
    return ingested.granules.at(n).granule;
  }
  /// All values of a variable.
  [[nodiscard]] GriddedField field(std::string_view standard_name, std::size_t n = 0) const {
    const GranuleFile file = GranuleFile::open(ingested.granules.at(n).content_file);
    const Grid& grid = file.granule().grid;
    return file.read(standard_name, 0, grid.times(), 0, grid.rows(), 0, grid.columns());
  }
  [[nodiscard]] std::string warnings() const {
    std::string all;
    for (const std::string& warning : ingested.warnings) all += warning + "\n";
    return all;
  }
};

inline Decoded decode(const TinyProduct& product, const IngestOptions& options = {}) {
  Decoded decoded{std::make_unique<slackwater::tests::TemporaryFolder>(), {}};
  product.write(*decoded.folder / "product.nc");
  decoded.ingested = decode_gridded(netcdf::File::open(*decoded.folder / "product.nc"), products(),
                                    options, decoded.folder->path());
  return decoded;
}

/// The message of the Error that the work must throw; "nothing was thrown" if it does not.
template <typename Work>
std::string message_of(Work&& work) {
  try {
    work();
  } catch (const Error& error) {
    return std::string(name_of(error.kind())) + ": " + error.message();
  }
  return "nothing was thrown";
}

inline std::string refusal_of(const TinyProduct& product, const IngestOptions& options = {}) {
  return message_of([&] { (void)decode(product, options); });
}

}  // namespace slackwater::ingest::tests
