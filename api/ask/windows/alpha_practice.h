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
  /// The tables of some files. Of wave heights, where none of them is, that of data/alpha. No
  /// source that could be read has factors for wind, so that there are none but a user's.
  /// @throws Error(not_found), Error(invalid_input), also for two of one variable
  [[nodiscard]] static AlphaPractice of_tables(const std::vector<std::filesystem::path>& files);
  /// Of wave heights worked out from the errors of their forecasts (`alpha_by_errors`), of others
  /// the tables of some files.
  /// @throws as `of_tables`, also for a table of wave heights
  [[nodiscard]] static AlphaPractice of_errors(
      twin::HeightErrors errors, const std::vector<std::filesystem::path>& files = {});

  /// Nothing where practice has no factor for limits of this kind.
  /// @param bound  of the limit then: of one with a table that of the sea
  [[nodiscard]] std::optional<twin::AlphaFactor> at(const twin::Limit& limit, double bound,
                                                    double period_h) const;
  /// "DNV-OS-H101 (2011), table 4-1, base case"; of several, each with what it is for.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::string source() const;

 private:
  void add(const std::filesystem::path& file);
  [[nodiscard]] bool has(twin::LimitVariable variable) const;
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
