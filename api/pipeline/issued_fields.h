#pragma once
#include <condition_variable>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "data/store/store.h"
#include "fields/service/field.h"
#include "fields/service/published.h"

namespace slackwater::api {

/// One issued forecast as services name it.
struct IssuedForecast {
  std::string
      instance;  ///< "SITE_20250310T050000Z"; the row's number is added where two were issued at once
  store::ForecastRow row;
};

/// What is on offer at one moment: immutable, published as a whole.
struct ForecastCatalogue {
  struct SiteForecast {
    std::string site_id;
    std::string instance;
    std::shared_ptr<const Field> field;  ///< in force: never null
  };
  std::vector<IssuedForecast> instances;  ///< newest first
  std::vector<SiteForecast> sites;        ///< by site id

  [[nodiscard]] const IssuedForecast* find(const std::string& instance) const noexcept;
  /// The forecast in force for the site nearest to the place, of those that reach it; null where none does.
  [[nodiscard]] const SiteForecast* site_at(double longitude_deg,
                                            double latitude_deg) const noexcept;
};

/// Issued forecasts of a store, laid out for sampling: the one in force of each site always at hand, older ones
/// read when they are asked for and the last few kept. Follows the store: a forecast that another process
/// issues is in force here within `every`. Readers of the catalogue never wait.
class IssuedFields {
 public:
  /// @param folder  of the store, which must exist
  explicit IssuedFields(const std::filesystem::path& folder,
                        Duration every = std::chrono::seconds(2));
  ~IssuedFields();
  IssuedFields(const IssuedFields&) = delete;
  IssuedFields& operator=(const IssuedFields&) = delete;

  [[nodiscard]] std::shared_ptr<const ForecastCatalogue> catalogue() const noexcept {
    return published_.load();
  }
  /// The field of any instance; @throws Error(not_found) for a name that is not on offer.
  [[nodiscard]] std::shared_ptr<const Field> field(const std::string& instance);
  /// Reads the store now. What cannot be read is said in `trouble` and leaves the catalogue as it was.
  void refresh();
  /// The last refresh's failure; empty after one that succeeded.
  [[nodiscard]] std::string trouble() const;

 private:
  [[nodiscard]] std::shared_ptr<const Field> load(const IssuedForecast& forecast);
  void follow(Duration every);

  std::filesystem::path folder_;
  std::unique_ptr<store::Store> store_;
  Published<ForecastCatalogue> published_;
  mutable std::mutex mutex_;  ///< guards the store, the kept fields and the trouble
  std::list<std::pair<std::string, std::shared_ptr<const Field>>> kept_;  ///< last used first
  std::string trouble_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread follower_;
};

}  // namespace slackwater::api
