#include "api/door/edr/read/feature_filter.h"

#include <algorithm>
#include <array>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"

namespace slackwater::api::edr {
namespace {

std::size_t whole_number(const QueryString& query, std::string_view key, std::size_t least,
                         std::size_t otherwise) {
  const auto text = query.find(key);
  if (!text) return otherwise;
  const auto count = count_of(*text);
  if (!count || *count < least) {
    throw bad_parameter(key, *text, "a whole number from " + std::to_string(least));
  }
  return *count;
}

/// Whether two boxes meet, on whichever turn of the globe each is written.
bool meet(const Box& box, const slackwater::BoundingBox& place) {
  if (place.south_deg > box.north_deg || place.north_deg < box.south_deg) return false;
  const double west = place.west_deg;
  const double east = place.east_deg < west ? place.east_deg + 360 : place.east_deg;
  for (const double turn : {-360.0, 0.0, 360.0, 720.0}) {
    if (west + turn <= box.east_deg && east + turn >= box.west_deg) return true;
  }
  return false;
}

}  // namespace

std::span<const std::string_view> FeatureFilter::parameters() noexcept {
  static constexpr std::array<std::string_view, 4> names{"bbox", "datetime", "limit", "offset"};
  return names;
}

FeatureFilter::FeatureFilter(const QueryString& query) {
  if (const auto text = query.find("bbox")) box_ = parse_bbox(*text).box;
  if (const auto text = query.find("datetime")) time_ = parse_datetime(*text);
  limit_ = std::min(whole_number(query, "limit", 1, usual_features), most_features);
  offset_ = whole_number(query, "offset", 0, 0);
  for (const auto& [key, value] : query.all()) {
    if (key != "offset" && key != "f") asked_.emplace_back(key, value);
  }
}

bool FeatureFilter::takes(const slackwater::BoundingBox& place, UtcTime from, UtcTime to) const {
  if (box_ && !meet(*box_, place)) return false;
  return !time_ || ((!time_->from || *time_->from <= to) && (!time_->to || from <= *time_->to));
}

}  // namespace slackwater::api::edr
