#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "api/edr/read/bbox.h"
#include "api/edr/read/datetime.h"
#include "api/edr/read/query_string.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api::edr {

constexpr std::size_t most_features = 10'000;
constexpr std::size_t usual_features = 1'000;

/// Which features a list is to hold: `bbox`, `datetime`, `limit` and `offset` of OGC API - Features.
class FeatureFilter {
 public:
  /// The parameters that lists of features take, beside `f`.
  [[nodiscard]] static std::span<const std::string_view> parameters() noexcept;

  /// @param href  of the list, without a query
  /// @throws Error(usage) for what cannot be read; a limit above `most_features` is cut to it
  FeatureFilter(std::string href, const QueryString& query);

  /// Whether a feature meets the box and the time, borders included. The vertical part of a box says
  /// nothing here: all features lie at the surface.
  [[nodiscard]] bool takes(const slackwater::BoundingBox& place, UtcTime from, UtcTime to) const;

  /// A FeatureCollection of those features that fall on this page, with links to itself, to its other
  /// renditions and to the next page.
  [[nodiscard]] nlohmann::json page(nlohmann::json all_taken) const;

 private:
  [[nodiscard]] std::string address(std::string_view key, const std::string& value) const;

  std::string href_;
  std::optional<Box> box_;
  std::optional<TimeRange> time_;
  std::size_t limit_ = usual_features;
  std::size_t offset_ = 0;
  std::vector<std::pair<std::string, std::string>> asked_;  ///< as it came, without the offset
};

}  // namespace slackwater::api::edr
