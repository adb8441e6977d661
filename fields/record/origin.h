#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/grid/status.h"

namespace slackwater {

/// What tells where a product stands among others.
struct Rank {
  std::optional<bool> has_tide;  ///< of currents; nothing where nobody says
  bool is_regional = false;      ///< made for a region, not for the whole globe
  double spacing_deg = 0;        ///< of its grid in latitude, from the file; 0: not known
};

/// Where a piece of data came from, as far as choosing between pieces needs it.
struct Origin {
  std::vector<std::int64_t> granules;  ///< one, or two where U and V came in separate files
  DataStatus status = DataStatus::analysis;
  std::optional<UtcTime> reference_time;  ///< of a provider's forecast
  /// How long after it the product's runs are usually published; 0 where nobody says.
  Duration published_after{0};
  std::string dataset;  ///< product/dataset/levels: pieces of one dataset may be joined
  std::string product_id;
  bool is_of_named_product = true;  ///< else strangers share its `product_id`
  std::string attribution;
  std::vector<std::string> sources;  ///< sha256 of the product files
  /// When the last of those files came in; nothing where nobody wrote it down.
  std::optional<UtcTime> received;
  /// When its provider published the values, where the file says it.
  std::optional<UtcTime> published;
  Rank rank;
  int ensemble_member = 0;  ///< of a weather model; 0 is the control
  std::string station;      ///< platform of a point series
  bool contains_stokes = false;
  bool is_point_series = false;
  std::optional<double> water_depth_m;  ///< where the file of a point series states it
  /// Standard error of a measured component, where the file of a point series states it.
  std::optional<double> stated_error_m_s;
};

/// When the later of two files came in, or was published; nothing where that of either is not
/// known.
[[nodiscard]] inline std::optional<UtcTime> later_of(const std::optional<UtcTime>& a,
                                                     const std::optional<UtcTime>& b) noexcept {
  if (!a || !b) return std::nullopt;
  return *a < *b ? *b : *a;
}

/// Whether a run of a provider's forecast, which has a reference time, was there at a time:
/// published by the product's usual rule, or in hand.
[[nodiscard]] inline bool is_published_by(const Origin& run, UtcTime time) noexcept {
  if (run.received && *run.received <= time) return true;
  // Far future stays far future.
  return *run.reference_time <= time && run.published_after <= time - *run.reference_time;
}

/// Whether a piece was measured at a place: a point series of observations. Model output written as
/// a point series (`ingest --as analysis`) is a product.
[[nodiscard]] inline bool is_in_situ(const Origin& origin) noexcept {
  return origin.is_point_series && origin.status == DataStatus::observation;
}

}  // namespace slackwater
