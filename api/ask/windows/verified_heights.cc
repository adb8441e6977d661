#include <algorithm>
#include <cmath>

#include "api/ask/windows/alpha_practice.h"
#include "api/pipeline/verify.h"
#include "calibration/verify/skill_entry.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

using calibration::SkillEntry;

/// Sums over the forecasts of one day of lead, each hour of them one pair.
struct Sums {
  double pairs = 0;
  double error = 0;
  double squares = 0;
  double height = 0;
  double height_pairs = 0;
  std::size_t forecasts = 0;

  void add(const calibration::ScalarScore& score) {
    const auto n = static_cast<double>(score.n);
    pairs += n;
    error += n * score.bias;
    squares += n * score.rmse * score.rmse;
    ++forecasts;
    // The scatter index is the deviation over the mean of the truth.
    const double deviation =
        std::sqrt(std::max(0.0, score.rmse * score.rmse - score.bias * score.bias));
    if (score.scatter_index && *score.scatter_index > 0) {
      height += n * deviation / *score.scatter_index;
      height_pairs += n;
    }
  }
  [[nodiscard]] twin::VerifiedHeights heights(const calibration::LeadBin& lead) const {
    twin::VerifiedHeights out;
    out.from_h = lead.from_h;
    out.to_h = lead.to_h;
    out.forecasts = forecasts;
    out.pairs = static_cast<std::size_t>(pairs);
    out.bias_m = error / pairs;
    out.sigma_m = std::sqrt(std::max(0.0, squares / pairs - out.bias_m * out.bias_m));
    out.mean_height_m = height_pairs > 0 ? height / height_pairs : 0;
    return out;
  }
};

}  // namespace

std::vector<twin::VerifiedHeights> verified_heights(const Site& site,
                                                    const std::filesystem::path& store_folder,
                                                    int threads) {
  calibration::VerifyOptions options;
  options.only = ForecastOrigin::forecast;
  options.bands = {{0, calibration::whole_column_m, false}};
  options.by_hour = false;
  options.threads = threads;
  std::vector<SkillEntry> entries;
  try {
    store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
    entries = verify(store, site, options).entries;
  } catch (const Error& problem) {
    // Nothing issued, or no truth in: nothing is known yet.
    if (problem.kind() != ErrorKind::not_found) throw;
  }
  std::vector<twin::VerifiedHeights> out;
  for (const calibration::LeadBin& lead : options.leads) {
    Sums sums;
    for (const SkillEntry& entry : entries)
      if (entry.variable == calibration::wave_variable && entry.scalar && entry.scalar->n > 0 &&
          entry.method == calibration::Method::forecast && entry.lead == lead)
        sums.add(*entry.scalar);
    if (sums.forecasts > 0) out.push_back(sums.heights(lead));
  }
  return out;
}

}  // namespace slackwater::api
