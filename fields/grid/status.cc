#include "fields/grid/status.h"

#include <array>

namespace slackwater {

std::string_view name_of(SampleStatus status) noexcept {
  static constexpr std::array<std::string_view, sample_status_count> names{
      "ok",           "missing",       "land",        "below_bed", "outside_area",
      "outside_time", "above_surface", "not_checked", "suspect",   "carried"};
  return names[static_cast<std::size_t>(status)];
}

namespace {
constexpr std::array<std::string_view, 5> data_status_names{"analysis", "forecast", "observation",
                                                            "persisted", "modelled"};
}

std::string_view name_of(DataStatus status) noexcept {
  return data_status_names[static_cast<std::size_t>(status)];
}

std::optional<DataStatus> data_status_from(std::string_view name) noexcept {
  for (std::size_t i = 0; i < data_status_names.size(); ++i) {
    if (data_status_names[i] == name) return static_cast<DataStatus>(i);
  }
  return std::nullopt;
}

}  // namespace slackwater
