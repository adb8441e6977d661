#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/door/edr/read/bbox.h"
#include "api/door/edr/read/datetime.h"
#include "api/door/edr/read/query_string.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api::edr {

constexpr std::size_t most_features = 10'000;
constexpr std::size_t usual_features = 1'000;

/// Which features a list is to hold: `bbox`, `datetime`, `limit` and
/// `offset` of OGC API - Features.
class FeatureFilter {
 public:
  /// The parameters that lists of features take, beside `f`.
  [[nodiscard]] static std::span<const std::string_view> parameters() noexcept;

  /// @throws Error(usage) for what cannot be read; a limit above `most_features` is cut to it
  explicit FeatureFilter(const QueryString& query);

  /// Whether a feature meets the box and the time, borders included. The vertical part of a box
  /// says nothing here: all features lie at the surface.
  [[nodiscard]] bool takes(const slackwater::BoundingBox& place, UtcTime from, UtcTime to) const;

  /// Of the features that are taken, how many to pass over and how many to show.
  [[nodiscard]] std::size_t offset() const noexcept { return offset_; }
  [[nodiscard]] std::size_t limit() const noexcept { return limit_; }
  /// The query as it came, without the offset and the format.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& asked() const noexcept {
    return asked_;
  }

 private:
  std::optional<Box> box_;
  std::optional<TimeRange> time_;
  std::size_t limit_ = usual_features;
  std::size_t offset_ = 0;
  std::vector<std::pair<std::string, std::string>> asked_;
};

}  // namespace slackwater::api::edr
