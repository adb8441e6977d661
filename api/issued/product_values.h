#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "api/issued/stored_products.h"
#include "fields/grid/status.h"

namespace slackwater::api {

/// What is wanted of a stored product: a box, and a stretch of time.
struct ProductWindow {
  /// Its longitudes in any turn, west <= east, at most 360 apart.
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
/// What instruments measured is given as it is: at its own place whatever place is asked for, at
/// its own times and depths, and only where its quality is good: what was rejected, and what nobody
/// checked, is absent. Where two files have a value the later ingested counts.
///
/// Opens content files that are whole alone (data/store/proven_content.h); what is damaged is left
/// out and told. Keeps the axes, never values: those are read some times at once.
class ProductView {
 public:
  /// Files that one view may open.
  static constexpr std::size_t most_files = 1000;

  /// Values, of all quantities and runs, that are held in memory at once: 128 MB.
  static constexpr std::size_t most_read = 32'000'000;

  /// @param store  the store's folder
  /// @param most   values that may be held in memory at once
  /// @throws Error(usage) where the window reaches into more files than `most_files`;
  /// Error(unavailable), without the store's paths, where none of those it reaches can be read
  ProductView(std::filesystem::path store, const StoredProduct& product,
              const ProductWindow& window, std::size_t most = most_read);

  /// Its instants in the window and the means whose time overlaps it, ascending by centre.
  [[nodiscard]] const std::vector<TimeCell>& time() const noexcept { return time_; }
  /// Ascending; empty without a vertical.
  [[nodiscard]] const std::vector<double>& levels_m() const noexcept { return levels_m_; }
  /// Of its cell centres in the box, as the box counts longitudes; ascending.
  [[nodiscard]] const std::vector<double>& longitude_deg() const noexcept { return longitude_deg_; }
  [[nodiscard]] const std::vector<double>& latitude_deg() const noexcept { return latitude_deg_; }
  /// Damaged files that were left out.
  [[nodiscard]] std::size_t damaged() const noexcept { return damaged_; }

  /// At which levels values are wanted.
  enum class Levels {
    all_at_each,   ///< at each place all of them
    one_for_each,  ///< at each place its own: as many as places, and one level in the values
  };
  /// @param places    in the window's box
  /// @param times     centres of `time()`, ascending, without gaps
  /// @param levels_m  empty without a vertical
  /// @throws Error(usage) where the files hold more than `most` values at one of the times around
  /// the places; Error(unavailable) for a file that cannot be read
  [[nodiscard]] ProductValues values(std::span<const GeoPoint> places,
                                     std::span<const UtcTime> times,
                                     std::span<const double> levels_m,
                                     Levels which = Levels::all_at_each) const;

 private:
  [[nodiscard]] ProductValues measured(std::span<const UtcTime> times,
                                       std::span<const double> levels_m) const;

  std::filesystem::path store_;
  const StoredProduct& product_;
  ProductWindow window_;
  std::size_t most_read_;
  std::vector<const store::GranuleRow*> granules_;
  std::vector<TimeCell> time_;
  std::vector<double> levels_m_;
  std::vector<double> longitude_deg_;
  std::vector<double> latitude_deg_;
  std::map<UtcTime, std::size_t> stored_;  ///< how many values are read at a centre, of all runs
  std::size_t damaged_ = 0;
};

}  // namespace slackwater::api
