#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::tests {

/// One cell of a product file.
struct ProductCell {
  UtcTime time;
  double depth_m = 0;
  double latitude_deg = 0;
  double longitude_deg = 0;
};

/// A variable of a product file; `value` gives NaN where there is none (written as the fill value).
struct ProductQuantity {
  std::string name;           ///< as the provider writes it, "uo"
  std::string standard_name;  ///< CF; empty: no such attribute
  std::string unit;           ///< empty: no such attribute
  bool has_depth = false;
  std::function<double(const ProductCell&)> value;
};

/// A tiny file in the shape of a Copernicus Marine subset. Tests spoil one thing about it, then
/// write it.
struct ProductForTests {
  std::string title;
  std::map<std::string, std::string> global;  ///< further global attributes
  std::vector<UtcTime> time;                  ///< empty: a static file
  std::vector<double> depth_m;                ///< empty: no depth axis
  std::vector<double> latitude_deg{53.8, 53.9, 54.0, 54.1, 54.2};
  std::vector<double> longitude_deg{6.3, 6.4, 6.5, 6.6, 6.7};
  std::optional<UtcTime> reference_time;
  std::string cell_methods;  ///< of every quantity, "time: mean"; empty: no such attribute
  bool writes_nan = false;   ///< missing values are written as NaN, not as the fill value
  std::vector<ProductQuantity> quantities;

  [[nodiscard]] ProductQuantity& quantity(const std::string& name);
};

/// The water that all these files tell of: a semidiurnal tide with less of it near the bed, a slow
/// drift, and a wind-driven part that decays with depth. East of 6.65 E there is land. 30 m deep.
struct WaterForTests {
  static constexpr double depth_m = 30;
  static constexpr double site_latitude_deg = 54.0;
  static constexpr double site_longitude_deg = 6.5;
  static constexpr double land_east_of_deg = 6.65;
  [[nodiscard]] static double eastward_m_s(const ProductCell& cell);
  [[nodiscard]] static double northward_m_s(const ProductCell& cell);
  [[nodiscard]] static double eastward_wind_m_s(const ProductCell& cell);
  [[nodiscard]] static double northward_wind_m_s(const ProductCell& cell);
  [[nodiscard]] static double significant_height_m(const ProductCell& cell);
};

/// Hourly instants from midnight of the day, `hours` of them.
[[nodiscard]] std::vector<UtcTime> hourly_times(UtcDay day, int hours = 24);

/// uo and vo at 0, 5, 10, 20 and 30 m, analysed: no reference time.
[[nodiscard]] ProductForTests current_product(UtcDay day, int hours = 24);
/// The same water as means over so many hours (which divide a day), stamped in their middle, from
/// midnight of the day on.
[[nodiscard]] ProductForTests mean_current_product(UtcDay day, int days, int averaging_h);
/// eastward_wind and northward_wind.
[[nodiscard]] ProductForTests wind_product(UtcDay day, int hours = 24);
/// VHM0, VTPK and VMDR.
[[nodiscard]] ProductForTests wave_product(UtcDay day, int hours = 24);
/// deptho.
[[nodiscard]] ProductForTests bathymetry_product();

/// Writes it as netCDF-4 and returns the path.
std::filesystem::path write_product(const std::filesystem::path& file,
                                    const ProductForTests& product);

/// Writes the YAML of a site in that water (id "test_site", 30 m) and returns the path; `more` adds
/// lines to it.
std::filesystem::path write_site(const std::filesystem::path& file, const std::string& more = "",
                                 double latitude_deg = WaterForTests::site_latitude_deg,
                                 double longitude_deg = WaterForTests::site_longitude_deg);

}  // namespace slackwater::tests
