#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fields/site/site.h"
#include "twin/risk/alpha_factor.h"
#include "twin/risk/height_errors.h"

namespace slackwater::api {

/// How the margins of practice are had: from tables, or for waves from the errors of forecasts.
class AlphaPractice {
 public:
  /// The tables of some files; none: the one of data/alpha.
  /// @throws Error(not_found), Error(invalid_input), also for two of one variable
  [[nodiscard]] static AlphaPractice of_tables(const std::vector<std::filesystem::path>& files);
  /// Worked out from the errors of forecast wave heights (`alpha_by_errors`).
  [[nodiscard]] static AlphaPractice of_errors(twin::HeightErrors errors);

  /// Nothing where practice has no factor for limits of this kind.
  [[nodiscard]] std::optional<twin::AlphaFactor> at(const twin::Limit& limit,
                                                    double period_h) const;
  /// "DNV-OS-H101 (2011), table 4-1, base case".
  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::string source() const;

 private:
  std::vector<twin::AlphaTable> tables_;
  std::optional<twin::HeightErrors> errors_;
};

/// The record of data/alpha: the errors of forecast wave heights where nothing nearer is known.
[[nodiscard]] twin::HeightErrors published_height_errors();

/// How the wave heights of a site's issued forecasts erred so far, by day of lead, scored anew from
/// what the store holds (`verify`); none where nothing was issued or no truth is in.
[[nodiscard]] std::vector<twin::VerifiedHeights> verified_heights(
    const Site& site, const std::filesystem::path& store_folder, int threads);

}  // namespace slackwater::api
