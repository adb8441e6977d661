#pragma once
#include <array>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "api/issued/stored_products.h"
#include "data/store/store.h"
#include "fields/service/field.h"
#include "fields/service/published.h"

namespace slackwater::api {

/// One issued forecast as services name it.
struct IssuedForecast {
  /// "SITE_20250310T050000Z"; the row's number is added to all but the first stored of those that
  /// were issued at once, so that a name never passes to another forecast.
  std::string instance;
  store::ForecastRow row;  ///< without its summary and inputs
};

/// What is on offer at one moment: immutable, published as a whole.
struct ForecastCatalogue {
  struct SiteForecast {
    std::string site_id;
    std::string instance;
    std::shared_ptr<const Field> field;  ///< in force: never null
    /// Instances of more force that cannot be read: the answer is to say so.
    std::vector<std::string> passed_over;
  };
  std::vector<IssuedForecast> instances;  ///< newest first
  std::vector<SiteForecast> sites;        ///< by site id
  /// What product files hold, then what instruments measured, by id (stored_products.h): never
  /// null.
  std::shared_ptr<const std::vector<StoredProduct>> products =
      std::make_shared<const std::vector<StoredProduct>>();

  [[nodiscard]] const IssuedForecast* find(const std::string& instance) const noexcept;
  [[nodiscard]] const StoredProduct* product(const std::string& id) const noexcept;
  /// The forecast in force for the site nearest to the place, of those that reach it; null where
  /// none does.
  [[nodiscard]] const SiteForecast* site_at(double longitude_deg, double latitude_deg) const;
};

/// Issued forecasts of a store, laid out for sampling: the one in force of each site always at
/// hand, older ones read when they are asked for and the last few kept; and which products it
/// holds. Follows the store: a forecast that another process issues is in force here within
/// `every`, and a product that it ingests is listed. Readers of the catalogue never wait.
///
/// What cannot be read degrades and never ends the service: a store that is gone or locked leaves
/// the catalogue as it was, a forecast in force that cannot be read leaves its site with the newest
/// one that can, and `trouble` says so until it is mended. A store that was replaced by another
/// (restored from a copy) is followed too.
class IssuedFields {
 public:
  /// @param folder  of the store, which must exist
  explicit IssuedFields(std::filesystem::path folder, Duration every = std::chrono::seconds(2));
  ~IssuedFields();
  IssuedFields(const IssuedFields&) = delete;
  IssuedFields& operator=(const IssuedFields&) = delete;

  [[nodiscard]] std::shared_ptr<const ForecastCatalogue> catalogue() const noexcept {
    return published_.load();
  }
  /// Of the store.
  [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }
  /// The field of any instance. @throws Error(not_found) for a name that is not on offer, or no
  /// longer; Error(unavailable), without the store's paths, for one that cannot be read
  [[nodiscard]] std::shared_ptr<const Field> field(const std::string& instance);
  /// Reads the store now, if it has changed.
  void refresh();
  /// What keeps the service from being whole, without the store's paths; empty where nothing does.
  /// Never waits for a file or the catalogue.
  [[nodiscard]] std::string trouble() const;
  /// Whether the store itself could be read last time; false: new forecasts go unnoticed.
  [[nodiscard]] bool is_following() const;
  /// Fields kept beside those in force.
  [[nodiscard]] std::size_t kept() const;

 private:
  /// What tells that the catalogue's files were written or replaced.
  using Mark = std::array<std::uint64_t, 8>;
  [[nodiscard]] Mark mark() const noexcept;
  void read_store();
  void retry(const std::vector<IssuedForecast>& instances);
  [[nodiscard]] ForecastCatalogue next_catalogue(std::vector<IssuedForecast> instances,
                                                 std::vector<StoredProduct> products);
  [[nodiscard]] std::shared_ptr<const Field> in_force(const ForecastCatalogue& now,
                                                      const IssuedForecast& forecast);
  [[nodiscard]] std::shared_ptr<const Field> read(const IssuedForecast& forecast) const;
  [[nodiscard]] std::shared_ptr<const Field> kept_or_read(const IssuedForecast& forecast);
  void note(const std::string& what, const std::string& problem);
  void forget(const std::string& what);
  [[nodiscard]] bool is_whole() const;
  [[nodiscard]] std::string without_paths(std::string text) const;
  void follow(Duration every);

  std::filesystem::path folder_;
  Published<ForecastCatalogue> published_;

  std::mutex refreshing_;  ///< guards the marks; one refresh at a time
  std::optional<Mark> last_mark_;
  std::optional<Mark> settled_mark_;  ///< seen by two readings: nothing was written since the first

  mutable std::mutex keeping_;  ///< guards the kept fields; held while one is read
  std::list<std::pair<std::string, std::shared_ptr<const Field>>> kept_;  ///< last used first

  mutable std::mutex telling_;                  ///< guards what follows; never held for long
  std::map<std::string, std::string> trouble_;  ///< by instance; "" for the store itself
  std::condition_variable wake_;
  bool ends_ = false;

  std::thread follower_;
};

}  // namespace slackwater::api
