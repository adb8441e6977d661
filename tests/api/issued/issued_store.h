#pragma once
#include <filesystem>
#include <string>

#include "data/store/layout.h"
#include "data/store/store.h"
#include "tests/api/issued/commit_made_up.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests {

/// A store into which made-up forecasts are issued, each commit through a Store of its own, as
/// another process would.
class IssuedStore {
 public:
  IssuedStore() { static_cast<void>(open()); }

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  void move_to(const std::filesystem::path& elsewhere) {
    std::filesystem::rename(path_, elsewhere);
  }
  [[nodiscard]] std::filesystem::path beside(const std::string& name) const {
    return folder_ / name;
  }

  /// A small forecast issued at 05:00 of the day after `day`; `mark` is its central current
  /// everywhere, m/s.
  [[nodiscard]] static Snapshot small(const std::string& site, int days_later, double mark) {
    MadeUpForecast size;
    size.levels = 3;
    size.hours = 6;
    size.members = 2;
    Snapshot made = made_up_forecast(size);
    made.site_id = site;
    made.day += std::chrono::days(days_later);
    made.issued += std::chrono::days(days_later);
    for (UtcTime& time : made.time) time += std::chrono::days(days_later);
    for (ForecastColumn& column : made.columns)
      column.current_m_s.assign(column.current_m_s.size(), Horizontal(mark, -mark));
    return made;
  }

  std::int64_t issue(const Snapshot& made, ForecastOrigin origin = ForecastOrigin::forecast) {
    store::Store store = open();
    return commit_made_up(store, made, origin);
  }

  /// The content file of a stored forecast.
  [[nodiscard]] std::filesystem::path file_of(std::int64_t id) const {
    for (const store::ForecastRow& row : open().list_forecasts())
      if (row.id == id) return store::content_file(path_, row.content_sha256);
    return {};
  }

  /// What was issued before, and its files, are gone.
  void prune_issued_before(UtcTime time) {
    store::PruneOptions options;
    options.older_than = time;
    options.forecasts = true;
    open().prune(options);
  }

 private:
  [[nodiscard]] store::Store open() const {
    return store::Store::open(path_, store::OpenMode::create_or_write);
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "store";
};

}  // namespace slackwater::tests
