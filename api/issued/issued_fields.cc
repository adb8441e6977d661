#include "api/issued/issued_fields.h"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "api/issued/in_force.h"
#include "data/store/layout.h"
#include "data/store/proven_content.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_kept = 4;
/// Forecasts of a site that are tried before it is left out.
constexpr std::size_t most_tries = 5;
/// Troubles that are told by name.
constexpr std::size_t most_told = 5;

/// "2025-03-10T05:00:00Z" without what a path segment need not hold.
std::string compact(UtcTime time) {
  std::string text = format_utc(time);
  std::erase_if(text, [](char c) { return c == '-' || c == ':'; });
  return text;
}

bool is_newer(const IssuedForecast& a, const IssuedForecast& b) {
  return std::tuple(a.row.day, a.row.issued, a.row.id) >
         std::tuple(b.row.day, b.row.issued, b.row.id);
}

std::vector<IssuedForecast> named(std::vector<store::ForecastRow> rows) {
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  std::vector<IssuedForecast> forecasts;
  std::set<std::string> taken;
  for (store::ForecastRow& row : rows) {
    std::string name = row.site_id + "_" + compact(row.issued);
    if (!taken.insert(name).second) name += "-" + std::to_string(row.id);
    row.summary_json = {};
    row.input_granules = {};
    forecasts.push_back({std::move(name), std::move(row)});
  }
  std::sort(forecasts.begin(), forecasts.end(), is_newer);
  return forecasts;
}

/// Of a site, the one in force first.
std::vector<const IssuedForecast*> of_site_by_force(const std::vector<IssuedForecast>& instances,
                                                    const std::string& site) {
  std::vector<const IssuedForecast*> forecasts;
  for (const IssuedForecast& forecast : instances)
    if (forecast.row.site_id == site) forecasts.push_back(&forecast);
  std::sort(forecasts.begin(), forecasts.end(),
            [](const auto* a, const auto* b) { return has_more_force(a->row, b->row); });
  return forecasts;
}

bool are_same(const std::vector<IssuedForecast>& a, const std::vector<IssuedForecast>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.instance == y.instance && x.row.id == y.row.id &&
           x.row.content_sha256 == y.row.content_sha256;
  });
}

}  // namespace

const IssuedForecast* ForecastCatalogue::find(const std::string& instance) const noexcept {
  for (const IssuedForecast& forecast : instances) {
    if (forecast.instance == instance) return &forecast;
  }
  return nullptr;
}

const StoredProduct* ForecastCatalogue::product(const std::string& id) const noexcept {
  for (const StoredProduct& product : *products)
    if (product.id == id) return &product;
  return nullptr;
}

const ForecastCatalogue::SiteForecast* ForecastCatalogue::site_at(double longitude_deg,
                                                                  double latitude_deg) const {
  std::vector<std::shared_ptr<const Field>> fields;
  for (const SiteForecast& site : sites) fields.push_back(site.field);
  const auto nearest = nearest_reaching(fields, longitude_deg, latitude_deg);
  return nearest ? &sites[*nearest] : nullptr;
}

IssuedFields::IssuedFields(std::filesystem::path folder, Duration every)
    : folder_(std::move(folder)), published_(std::make_shared<const ForecastCatalogue>()) {
  static_cast<void>(store::Store::open(folder_, store::OpenMode::read_only));
  refresh();
  follower_ = std::thread([this, every] { follow(every); });
}

IssuedFields::~IssuedFields() {
  {
    const std::lock_guard lock(telling_);
    ends_ = true;
  }
  wake_.notify_all();
  follower_.join();
}

// --- following the store ---

IssuedFields::Mark IssuedFields::mark() const noexcept {
  Mark mark{};
  const std::string file = store::catalogue_file(folder_).string();
  std::size_t i = 0;
  for (const std::string& name : {file, file + "-wal"}) {
    struct stat found {};
    const bool is_there = ::stat(name.c_str(), &found) == 0;
    mark[i++] = is_there ? found.st_ino : 0;
    mark[i++] = is_there ? static_cast<std::uint64_t>(found.st_size) : 0;
    mark[i++] = is_there ? static_cast<std::uint64_t>(found.st_mtim.tv_sec) : 0;
    mark[i++] = is_there ? static_cast<std::uint64_t>(found.st_mtim.tv_nsec) : 0;
  }
  return mark;
}

void IssuedFields::refresh() {
  const std::lock_guard lock(refreshing_);
  try {
    const Mark now = mark();
    if (settled_mark_ == now && is_whole()) return;
    read_store();
    // A clock of files ticks in milliseconds: what was written within one tick shows at the second
    // look.
    settled_mark_ = last_mark_ == now ? last_mark_ : std::nullopt;
    last_mark_ = now;
    forget("");
  } catch (const std::exception& problem) {
    note("", problem.what());
  }
}

/// The catalogue is opened anew each time: what was opened once would not see that the store was
/// replaced.
void IssuedFields::read_store() {
  store::Store store = store::Store::open(folder_, store::OpenMode::read_only);
  std::vector<IssuedForecast> instances = named(store.list_forecasts());
  const std::vector<store::GranuleRow> granules = store.find_granules({});
  std::vector<StoredProduct> products = stored_products(granules);
  for (StoredProduct& instrument : stored_instruments(granules))
    products.push_back(std::move(instrument));
  const bool was_whole = is_whole();
  retry(instances);
  const std::shared_ptr<const ForecastCatalogue> now = published_.load();
  if (was_whole && are_same(instances, now->instances) && products == *now->products) return;
  published_.store(std::make_shared<const ForecastCatalogue>(
      next_catalogue(std::move(instances), std::move(products))));
}

/// What could not be read may have been mended.
void IssuedFields::retry(const std::vector<IssuedForecast>& instances) {
  std::vector<std::string> noted;
  {
    const std::lock_guard lock(telling_);
    for (const auto& [what, problem] : trouble_)
      if (!what.empty() && noted.size() < most_tries) noted.push_back(what);
  }
  for (const IssuedForecast& forecast : instances) {
    if (std::find(noted.begin(), noted.end(), forecast.instance) == noted.end()) continue;
    try {
      static_cast<void>(read(forecast));
      forget(forecast.instance);
    } catch (const std::exception& problem) {
      note(forecast.instance, problem.what());
    }
  }
}

ForecastCatalogue IssuedFields::next_catalogue(std::vector<IssuedForecast> instances,
                                               std::vector<StoredProduct> products) {
  const std::shared_ptr<const ForecastCatalogue> now = published_.load();
  ForecastCatalogue next;
  next.instances = std::move(instances);
  next.products = products == *now->products
                      ? now->products
                      : std::make_shared<const std::vector<StoredProduct>>(std::move(products));
  std::set<std::string> sites;
  std::set<std::string> names{""};
  for (const IssuedForecast& forecast : next.instances) {
    sites.insert(forecast.row.site_id);
    names.insert(forecast.instance);
  }
  for (const std::string& site : sites) {
    std::vector<std::string> passed_over;
    for (const IssuedForecast* forecast : of_site_by_force(next.instances, site)) {
      if (passed_over.size() == most_tries) break;
      if (std::shared_ptr<const Field> field = in_force(*now, *forecast)) {
        next.sites.push_back({site, forecast->instance, std::move(field), std::move(passed_over)});
        break;
      }
      passed_over.push_back(forecast->instance);
    }
  }
  const std::lock_guard lock(telling_);
  std::erase_if(trouble_, [&](const auto& entry) { return !names.contains(entry.first); });
  return next;
}

/// The field of a forecast, from what is in force now or from its file; null, and noted, where it
/// cannot be read.
std::shared_ptr<const Field> IssuedFields::in_force(const ForecastCatalogue& now,
                                                    const IssuedForecast& forecast) {
  for (const auto& before : now.sites) {
    const IssuedForecast* issued = now.find(before.instance);
    if (issued != nullptr && issued->row.content_sha256 == forecast.row.content_sha256)
      return before.field;
  }
  try {
    std::shared_ptr<const Field> field = read(forecast);
    forget(forecast.instance);
    return field;
  } catch (const std::exception& problem) {
    note(forecast.instance, problem.what());
    return nullptr;
  }
}

void IssuedFields::follow(Duration every) {
  std::unique_lock lock(telling_);
  while (!wake_.wait_for(lock, every, [this] { return ends_; })) {
    lock.unlock();
    refresh();
    lock.lock();
  }
}

// --- one forecast ---

std::shared_ptr<const Field> IssuedFields::read(const IssuedForecast& forecast) const {
  return std::make_shared<const Field>(std::make_shared<const Snapshot>(
      ingest::read_forecast(store::proven_content(folder_, forecast.row.content_sha256))));
}

std::shared_ptr<const Field> IssuedFields::kept_or_read(const IssuedForecast& forecast) {
  const std::lock_guard lock(keeping_);
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
    if (kept->first != forecast.row.content_sha256) continue;
    kept_.splice(kept_.begin(), kept_, kept);
    return kept_.front().second;
  }
  kept_.emplace_front(forecast.row.content_sha256, nullptr);
  try {
    kept_.front().second = read(forecast);
  } catch (...) {
    kept_.pop_front();
    throw;
  }
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front().second;
}

std::shared_ptr<const Field> IssuedFields::field(const std::string& instance) {
  const std::shared_ptr<const ForecastCatalogue> now = catalogue();
  for (const auto& site : now->sites) {
    if (site.instance == instance) return site.field;
  }
  const IssuedForecast* forecast = now->find(instance);
  if (forecast == nullptr) {
    throw Error(ErrorKind::not_found, "found no instance '" + instance +
                                          "'; the collection's /instances lists what there is");
  }
  try {
    std::shared_ptr<const Field> field = kept_or_read(*forecast);
    forget(instance);
    return field;
  } catch (const std::exception& problem) {
    refresh();
    if (catalogue()->find(instance) == nullptr) {
      throw Error(
          ErrorKind::not_found,
          "the instance '" + instance +
              "' was pruned from the store; the collection's /instances lists what there is");
    }
    note(instance, problem.what());
    throw Error(ErrorKind::unavailable,
                "the forecast '" + instance +
                    "' is in the catalogue but cannot be read now; ask for "
                    "another instance, and tell the operator (see /health)");
  }
}

std::size_t IssuedFields::kept() const {
  const std::lock_guard lock(keeping_);
  return kept_.size();
}

// --- what is wrong ---

void IssuedFields::note(const std::string& what, const std::string& problem) {
  {
    const std::lock_guard lock(telling_);
    std::string& noted = trouble_[what];
    if (noted == problem) return;
    noted = problem;
  }
  log_event(LogLevel::error, what.empty() ? "store cannot be read" : "forecast cannot be read",
            {{"instance", what}, {"problem", problem}});
}

void IssuedFields::forget(const std::string& what) {
  const std::lock_guard lock(telling_);
  trouble_.erase(what);
}

bool IssuedFields::is_whole() const {
  const std::lock_guard lock(telling_);
  return trouble_.empty();
}

bool IssuedFields::is_following() const {
  const std::lock_guard lock(telling_);
  return !trouble_.contains("");
}

std::string IssuedFields::trouble() const {
  const std::lock_guard lock(telling_);
  std::string text;
  std::size_t told = 0;
  for (const auto& [what, problem] : trouble_) {
    if (told++ == most_told)
      return text + "; and " + std::to_string(trouble_.size() - most_told) + " more";
    text += (text.empty() ? "" : "; ") + (what.empty() ? "" : what + ": ") + problem;
  }
  return without_paths(std::move(text));
}

std::string IssuedFields::without_paths(std::string text) const {
  // A relative path may be as short as ".": then it is known by the slash behind it.
  const std::string path = folder_.is_absolute() ? folder_.string() : folder_.string() + "/";
  const std::string instead = folder_.is_absolute() ? "STORE" : "STORE/";
  for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at + 1))
    text.replace(at, path.size(), instead);
  return text;
}

}  // namespace slackwater::api
