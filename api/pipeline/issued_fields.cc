#include "api/pipeline/issued_fields.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "fields/base/error.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_kept = 4;

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
  std::vector<IssuedForecast> forecasts;
  for (store::ForecastRow& row : rows) {
    std::string name = row.site_id + "_" + compact(row.issued);
    forecasts.push_back({std::move(name), std::move(row)});
  }
  std::sort(forecasts.begin(), forecasts.end(), is_newer);
  // The newest of those issued at once keeps the plain name.
  std::set<std::string> taken;
  for (IssuedForecast& forecast : forecasts) {
    if (!taken.insert(forecast.instance).second) {
      forecast.instance += "-" + std::to_string(forecast.row.id);
      taken.insert(forecast.instance);
    }
  }
  return forecasts;
}

/// Of a site: what was issued as a forecast comes before what was made in hindsight.
const IssuedForecast* in_force(const std::vector<IssuedForecast>& newest_first,
                               const std::string& site) {
  const IssuedForecast* hindcast = nullptr;
  for (const IssuedForecast& forecast : newest_first) {
    if (forecast.row.site_id != site) continue;
    if (forecast.row.origin == "forecast") return &forecast;
    if (hindcast == nullptr) hindcast = &forecast;
  }
  return hindcast;
}

}  // namespace

const IssuedForecast* ForecastCatalogue::find(const std::string& instance) const noexcept {
  for (const IssuedForecast& forecast : instances) {
    if (forecast.instance == instance) return &forecast;
  }
  return nullptr;
}

const ForecastCatalogue::SiteForecast* ForecastCatalogue::site_at(
    double longitude_deg, double latitude_deg) const noexcept {
  const SiteForecast* nearest = nullptr;
  double nearest_deg2 = 0;
  for (const SiteForecast& site : sites) {
    const Place place{longitude_deg, latitude_deg, 0, {}};
    BedSample bed;
    site.field->sample_bed({&place, 1}, {&bed, 1});
    if (bed.status == SampleStatus::outside_area) continue;
    const GeoPoint& centre = site.field->snapshot().columns.front().point;
    const double east = std::remainder(longitude_deg - centre.longitude_deg(), 360.0) *
                        std::cos(centre.latitude.radians());
    const double north = latitude_deg - centre.latitude_deg();
    const double deg2 = east * east + north * north;
    if (nearest != nullptr && deg2 >= nearest_deg2) continue;
    nearest = &site;
    nearest_deg2 = deg2;
  }
  return nearest;
}

IssuedFields::IssuedFields(const std::filesystem::path& folder, Duration every)
    : folder_(folder),
      store_(
          std::make_unique<store::Store>(store::Store::open(folder, store::OpenMode::read_only))),
      published_(std::make_shared<const ForecastCatalogue>()) {
  refresh();
  follower_ = std::thread([this, every] { follow(every); });
}

IssuedFields::~IssuedFields() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  follower_.join();
}

std::shared_ptr<const Field> IssuedFields::load(const IssuedForecast& forecast) {
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
    if (kept->first != forecast.row.content_sha256) continue;
    kept_.splice(kept_.begin(), kept_, kept);
    return kept_.front().second;
  }
  auto snapshot = std::make_shared<const Snapshot>(
      ingest::read_forecast(store_->content_path(forecast.row.content_sha256)));
  kept_.emplace_front(forecast.row.content_sha256, std::make_shared<const Field>(snapshot));
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front().second;
}

void IssuedFields::refresh() {
  const std::lock_guard lock(mutex_);
  try {
    auto next = std::make_shared<ForecastCatalogue>();
    next->instances = named(store_->list_forecasts());
    const std::shared_ptr<const ForecastCatalogue> now = published_.load();
    if (std::equal(next->instances.begin(), next->instances.end(), now->instances.begin(),
                   now->instances.end(), [](const auto& a, const auto& b) {
                     return a.instance == b.instance && a.row.id == b.row.id;
                   })) {
      trouble_.clear();
      return;
    }
    std::set<std::string> sites;
    for (const IssuedForecast& forecast : next->instances) sites.insert(forecast.row.site_id);
    for (const std::string& site : sites) {
      const IssuedForecast* forecast = in_force(next->instances, site);
      std::shared_ptr<const Field> field;
      for (const auto& before : now->sites) {
        if (before.instance == forecast->instance) field = before.field;
      }
      if (!field) field = load(*forecast);
      next->sites.push_back({site, forecast->instance, std::move(field)});
    }
    published_.store(std::move(next));
    trouble_.clear();
  } catch (const std::exception& problem) {
    trouble_ = problem.what();
  }
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
  const std::lock_guard lock(mutex_);
  return load(*forecast);
}

std::string IssuedFields::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void IssuedFields::follow(Duration every) {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, every, [this] { return ends_; })) {
    lock.unlock();
    refresh();
    lock.lock();
  }
}

}  // namespace slackwater::api
