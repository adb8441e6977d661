#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "api/issued/stored_products.h"
#include "fields/grid/status.h"

namespace slackwater::api {

/// What is wanted of a stored product: a box, and a stretch of time.
struct ProductWindow {
  /// Its longitudes in any turn, west <= east.
  double west_deg = 0;
  double south_deg = 0;
  double east_deg = 0;
  double north_deg = 0;
  UtcTime from{};  ///< both ends included
  UtcTime to{};
};

/// Values of a product, each of `StoredProduct::standard_names` and behind them the hours from the
/// run that forecast it (`forecast_period`, h): 0 where it was analysed, NaN where the file does
/// not say when it was run. Each over time x level x place, the place fastest; NaN: no value.
struct ProductValues {
  std::vector<std::vector<double>> value;
  /// Per level and SampleStatus: at how many times and places it came instead of a value.
  std::vector<std::array<std::size_t, sample_status_count>> absent;
  std::set<std::string> runs;     ///< "analysis", "forecast of 2024-06-11T00:00:00Z"
  std::set<std::string> sources;  ///< sha256 of the product files
  bool contains_stokes = false;
  std::size_t most_members = 0;  ///< of the ensemble whose mean some values are; 0: of none
  Duration averaged{0};          ///< the longest interval whose mean a value is; 0: instants
};

/// A product as it is stored, seen through a window: its own times, levels and cells, and its
/// values by the rules that a forecast's data go by: bilinear between wet cells, and exact at a
/// cell (fields/interpolate); linear between levels; of several files at one time the analysis
/// before the forecast of the newest run (`choose`, fields/record). Nothing is interpolated in
/// time.
///
/// Opens content files that are whole alone (data/store/proven_content.h); what is damaged is left
/// out and told. Keeps the axes, never values: those are read some times at once.
class ProductView {
 public:
  /// Files that one view may open.
  static constexpr std::size_t most_files = 1000;

  /// @param store  the store's folder
  /// @throws Error(usage) where the window reaches into more files than `most_files`;
  /// Error(unavailable), without the store's paths, where none of those it reaches can be read
  ProductView(std::filesystem::path store, const StoredProduct& product,
              const ProductWindow& window);

  /// Centres of its time cells in the window, ascending.
  [[nodiscard]] const std::vector<UtcTime>& time() const noexcept { return time_; }
  /// Ascending; empty without a vertical.
  [[nodiscard]] const std::vector<double>& levels_m() const noexcept { return levels_m_; }
  /// Of its cell centres in the box, as the box counts longitudes; ascending.
  [[nodiscard]] const std::vector<double>& longitude_deg() const noexcept { return longitude_deg_; }
  [[nodiscard]] const std::vector<double>& latitude_deg() const noexcept { return latitude_deg_; }
  /// Damaged files that were left out.
  [[nodiscard]] std::size_t damaged() const noexcept { return damaged_; }

  /// @param places    in the window's box
  /// @param times     of `time()`, ascending
  /// @param levels_m  empty without a vertical
  /// @throws Error(usage) where one time of the cells around the places is more than `most_read`;
  /// Error(unavailable) for a file that cannot be read
  [[nodiscard]] ProductValues values(std::span<const GeoPoint> places,
                                     std::span<const UtcTime> times,
                                     std::span<const double> levels_m) const;

  /// Values of one quantity held in memory at once: 64 MB.
  static constexpr std::size_t most_read = 16'000'000;

 private:
  std::filesystem::path store_;
  const StoredProduct& product_;
  ProductWindow window_;
  std::vector<const store::GranuleRow*> granules_;
  std::vector<UtcTime> time_;
  std::vector<double> levels_m_;
  std::vector<double> longitude_deg_;
  std::vector<double> latitude_deg_;
  std::size_t cells_a_time_ = 0;  ///< cells x levels that are read for one time of one file
  std::size_t stored_times_ = 0;  ///< of all files; more than `time_` where runs overlap
  std::size_t damaged_ = 0;
};

}  // namespace slackwater::api
