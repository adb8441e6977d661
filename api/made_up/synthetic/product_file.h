#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "ingest/netcdf/file.h"

namespace slackwater::api {

/// A quantity as a provider names and stores it.
struct ProductVariable {
  std::string name;  ///< "uo"
  std::string standard_name;
  std::string long_name;
  std::string unit;
  bool has_depth = false;
  /// Packed as short with this scale where it is set, else float with the fill value 9.96921e36.
  std::optional<double> packed_scale;
  double packed_offset = 0;
};

/// The axes and the globals of a product file.
struct ProductLayout {
  std::vector<UtcTime> time;    ///< instants; empty for a static file
  std::vector<double> depth_m;  ///< empty for a surface product
  std::vector<double> latitude_deg;
  std::vector<double> longitude_deg;
  std::optional<UtcTime>
      reference_time;  ///< issue of a forecast: a CF scalar `forecast_reference_time`
  std::string title;
  std::string source;
  std::string dataset_id;
  std::vector<ProductVariable> variables;
};

/// A NetCDF file being written the way Copernicus Marine subsets look: dims (time, depth, latitude,
/// longitude), time in seconds since 1970, CF-1.8 attributes, light compression. Values go in time
/// by time, NaN where there is none.
class ProductFile {
 public:
  ProductFile(const std::filesystem::path& path, ProductLayout layout);
  /// All values of one variable at one time, longitude fastest, in the unit of the variable.
  void write(std::size_t variable, std::size_t time, std::span<const double> values);
  /// Flushes and closes.
  void finish() { writer_.close(); }
  [[nodiscard]] const ProductLayout& layout() const noexcept { return layout_; }

 private:
  ProductLayout layout_;
  ingest::netcdf::Writer writer_;
  std::vector<int> ids_;
  std::vector<double> packed_;
};

}  // namespace slackwater::api
