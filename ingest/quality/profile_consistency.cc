#include "ingest/quality/profile_consistency.h"

#include "fields/base/check.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t fewest_broken_bins = 2;
constexpr std::size_t broken_share = 4;  // one in four
constexpr std::size_t fewest_zero_bins = 3;

}  // namespace

EnsembleReport test_ensembles(std::size_t bins, std::span<const float> east,
                              std::span<const float> north, std::span<const SampleStatus> before,
                              std::span<SampleStatus> east_status,
                              std::span<SampleStatus> north_status) {
  expects(bins > 0 && east.size() % bins == 0, "whole ensembles");
  expects(east.size() == north.size() && east.size() == before.size() &&
              east.size() == east_status.size() && east.size() == north_status.size(),
          "two components, their statuses and the status before the tests for each sample");
  EnsembleReport report;
  const auto reject = [&](std::size_t i) {
    if (has_value(east_status[i])) east_status[i] = SampleStatus::suspect;
    if (has_value(north_status[i])) north_status[i] = SampleStatus::suspect;
  };
  const auto has_vector = [&](std::size_t i) {
    return has_value(east_status[i]) && has_value(north_status[i]);
  };
  for (std::size_t first = 0; first < east.size(); first += bins) {
    std::size_t held = 0;
    std::size_t failed = 0;
    std::size_t zeros = 0;
    for (std::size_t i = first; i < first + bins; ++i) {
      if (!has_value(before[i])) continue;
      ++held;
      if (!has_vector(i)) {
        ++failed;
      } else if (east[i] == 0.0F && north[i] == 0.0F) {
        ++zeros;
      }
    }
    if (failed >= fewest_broken_bins && failed * broken_share >= held) {
      for (std::size_t i = first; i < first + bins; ++i) reject(i);
      ++report.broken;
      continue;
    }
    if (zeros >= fewest_zero_bins && zeros == held) {
      for (std::size_t i = first; i < first + bins; ++i) reject(i);
      ++report.zeros;
      continue;
    }
    std::size_t run = 0;
    for (std::size_t i = first; i <= first + bins; ++i) {
      const bool zero = i < first + bins && has_vector(i) && east[i] == 0.0F && north[i] == 0.0F;
      if (zero) {
        ++run;
        continue;
      }
      if (run >= fewest_zero_bins) {
        for (std::size_t j = i - run; j < i; ++j) reject(j);
        report.zero_bins += run;
      }
      run = 0;
    }
  }
  return report;
}

}  // namespace slackwater::ingest
