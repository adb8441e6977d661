#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "api/made_up/synthetic/synthetic_ocean.h"
#include "fields/base/time.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bench {

/// A store with four days of hourly currents, waves and wind of a synthetic ocean, and the night's
/// weather and wave forecasts, filled by the program itself from product files.
class SyntheticStore {
 public:
  SyntheticStore();

  [[nodiscard]] const api::SyntheticOcean& ocean() const noexcept { return ocean_; }
  [[nodiscard]] UtcDay day() const noexcept { return day_; }  ///< the newest: day D
  [[nodiscard]] const std::filesystem::path& site_file() const noexcept { return site_file_; }
  [[nodiscard]] std::filesystem::path store() const { return folder_ / "store"; }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  /// A copy of the store: each timed forecast starts from the same state.
  [[nodiscard]] std::filesystem::path copy_of_store(const std::string& name) const;
  /// Arguments of `slackwater forecast` for day D, issued at 05:00 of the next one.
  [[nodiscard]] std::vector<std::string> forecast_arguments(const std::filesystem::path& store,
                                                            const std::filesystem::path& out) const;

 private:
  tests::TemporaryFolder folder_;
  api::SyntheticOcean ocean_;
  UtcDay day_;
  std::filesystem::path site_file_;
};

}  // namespace slackwater::bench
