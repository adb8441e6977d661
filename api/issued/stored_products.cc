#include "api/issued/stored_products.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "fields/base/encode/sha256.h"
#include "fields/base/text.h"
#include "ingest/pieces.h"

namespace slackwater::api {
namespace {

constexpr std::array kinds{ProductKind::currents, ProductKind::wind, ProductKind::waves};

bool holds(const store::GranuleRow& row, const std::string& name) {
  return std::find(row.standard_names.begin(), row.standard_names.end(), name) !=
         row.standard_names.end();
}

bool holds_any(const store::GranuleRow& row, ProductKind kind) {
  const auto& names = quantities_of(kind);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return holds(row, name); });
}

/// What tells one dataset from another, as a text. Files on other levels cannot be joined. Files
/// that name neither their product nor their dataset may be anybody's: those are one that cover
/// the same place.
std::string dataset_of(const store::GranuleRow& row, ProductKind kind) {
  std::string text = std::string(name_of(kind)) + '/' + row.product_id + '/' + row.dataset_id +
                     '/' + std::to_string(static_cast<int>(row.vertical));
  if (row.lowest_level_m && row.highest_level_m)
    text += formatted("@{:.3f}-{:.3f}", *row.lowest_level_m, *row.highest_level_m);
  if (!ingest::is_nobodys(row.product_id)) return text;
  const BoundingBox& box = row.bounds;
  return text + formatted("/{},{},{},{}", box.west_deg, box.south_deg, box.east_deg, box.north_deg);
}

/// What a path segment holds without being encoded.
std::string fit_for_a_path(std::string text) {
  for (char& c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter >= 128 || (std::isalnum(letter) == 0 && c != '.' && c != '_' && c != '-')) c = '_';
  }
  return text;
}

BoundingBox around(const BoundingBox& a, const BoundingBox& b) {
  const bool is_cut = a.west_deg > a.east_deg || b.west_deg > b.east_deg;
  const bool is_alike = a.west_deg == b.west_deg && a.east_deg == b.east_deg;
  BoundingBox box{std::min(a.west_deg, b.west_deg), std::min(a.south_deg, b.south_deg),
                  std::max(a.east_deg, b.east_deg), std::max(a.north_deg, b.north_deg)};
  if (is_cut) {
    box.west_deg = is_alike ? a.west_deg : -180;
    box.east_deg = is_alike ? a.east_deg : 180;
  }
  return box;
}

template <typename Value>
void add_once(std::vector<Value>& list, const Value& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

void add(StoredProduct& product, const store::GranuleRow& row) {
  if (product.granules.empty()) {
    product.product_id = row.product_id;
    product.dataset_id = row.dataset_id;
    product.from = *row.first_time;
    product.to = *row.last_time;
    product.bounds = row.bounds;
    product.vertical = row.vertical;
    product.lowest_level_m = row.lowest_level_m;
    product.highest_level_m = row.highest_level_m;
  }
  product.from = std::min(product.from, *row.first_time);
  product.to = std::max(product.to, *row.last_time);
  product.bounds = around(product.bounds, row.bounds);
  if (row.lowest_level_m)
    product.lowest_level_m = std::min(*row.lowest_level_m, *product.lowest_level_m);
  if (row.highest_level_m)
    product.highest_level_m = std::max(*row.highest_level_m, *product.highest_level_m);
  if (!row.attribution.empty()) add_once(product.attributions, row.attribution);
  const bool is_forecast = row.status == DataStatus::forecast;
  if (!is_forecast) product.has_analysis = true;
  if (is_forecast && row.reference_time) add_once(product.runs, *row.reference_time);
  product.granules.push_back(row);
}

/// Its names in the order of the kind; of a vector both components, or it is none.
bool settle_names(StoredProduct& product) {
  for (const std::string& name : quantities_of(product.kind)) {
    const bool is_held =
        std::any_of(product.granules.begin(), product.granules.end(),
                    [&](const store::GranuleRow& row) { return holds(row, name); });
    if (is_held) product.standard_names.push_back(name);
  }
  if (product.kind == ProductKind::waves) return true;
  const auto& all = quantities_of(product.kind);
  const auto& held = product.standard_names;
  return held.size() >= vector_components &&
         std::equal(all.begin(), all.begin() + vector_components, held.begin());
}

constexpr double same_place_m = 500;

/// Of the box about a platform.
GeoPoint middle_of(const BoundingBox& box) {
  const double east = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  return GeoPoint::from_degrees(0.5 * (box.south_deg + box.north_deg),
                                std::remainder(0.5 * (box.west_deg + east), 360.0));
}

/// Whether a series is one more of what a platform measured.
bool is_of(const StoredProduct& instrument, const store::GranuleRow& row, ProductKind kind) {
  return instrument.kind == kind && instrument.station == row.station &&
         instrument.product_id == row.product_id && instrument.dataset_id == row.dataset_id &&
         instrument.vertical == row.vertical &&
         distance_m(middle_of(instrument.granules.front().bounds), middle_of(row.bounds)) <=
             same_place_m;
}

std::string plain_id(const StoredProduct& product) {
  return "product-" + std::string(name_of(product.kind)) + "-" +
         fit_for_a_path(product.dataset_id.empty() ? product.product_id : product.dataset_id);
}

}  // namespace

std::string_view name_of(ProductKind kind) noexcept {
  constexpr std::array<std::string_view, 3> names{"currents", "wind", "waves"};
  return names[static_cast<std::size_t>(kind)];
}

const std::vector<std::string>& quantities_of(ProductKind kind) {
  static const std::array<std::vector<std::string>, 3> names{
      {{"eastward_sea_water_velocity", "northward_sea_water_velocity"},
       {"eastward_wind", "northward_wind", "wind_speed_of_gust"},
       {"sea_surface_wave_significant_height",
        "sea_surface_wave_period_at_variance_spectral_density_maximum",
        "sea_surface_wave_from_direction", "sea_surface_wind_wave_significant_height",
        "sea_surface_wind_wave_mean_period", "sea_surface_wind_wave_from_direction",
        "sea_surface_primary_swell_wave_significant_height",
        "sea_surface_primary_swell_wave_mean_period",
        "sea_surface_primary_swell_wave_from_direction",
        "sea_surface_secondary_swell_wave_significant_height",
        "sea_surface_secondary_swell_wave_mean_period",
        "sea_surface_secondary_swell_wave_from_direction"}}};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<StoredProduct> stored_products(const std::vector<store::GranuleRow>& granules) {
  std::map<std::string, StoredProduct> by_dataset;
  for (const store::GranuleRow& row : granules) {
    if (row.is_point_series || !row.first_time || row.status == DataStatus::observation) continue;
    for (const ProductKind kind : kinds) {
      if (!holds_any(row, kind)) continue;
      StoredProduct& product = by_dataset[dataset_of(row, kind)];
      product.kind = kind;
      add(product, row);
    }
  }
  for (auto each = by_dataset.begin(); each != by_dataset.end();)
    each = settle_names(each->second) ? std::next(each) : by_dataset.erase(each);
  std::map<std::string, int> named;
  for (const auto& [key, product] : by_dataset) ++named[plain_id(product)];
  std::vector<StoredProduct> products;
  for (auto& [key, product] : by_dataset) {
    std::sort(product.runs.begin(), product.runs.end());
    product.id = plain_id(product);
    if (named[product.id] > 1 || ingest::is_nobodys(product.product_id))
      product.id += "-" + sha256_of_text(key).substr(0, 6);
    products.push_back(std::move(product));
  }
  std::sort(products.begin(), products.end(),
            [](const StoredProduct& a, const StoredProduct& b) { return a.id < b.id; });
  return products;
}

std::vector<StoredProduct> stored_instruments(const std::vector<store::GranuleRow>& granules) {
  std::vector<const store::GranuleRow*> rows;
  for (const store::GranuleRow& row : granules)
    if (row.is_point_series && row.first_time && row.status == DataStatus::observation)
      rows.push_back(&row);
  // As they were ingested: what comes later takes no name from what was there.
  std::sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  std::vector<StoredProduct> instruments;
  for (const store::GranuleRow* row : rows) {
    for (const ProductKind kind : kinds) {
      if (!holds_any(*row, kind) || row->station.empty()) continue;
      auto found = std::find_if(instruments.begin(), instruments.end(),
                                [&](const StoredProduct& one) { return is_of(one, *row, kind); });
      if (found == instruments.end()) {
        found = instruments.emplace(instruments.end());
        found->kind = kind;
        found->station = row->station;
      }
      add(*found, *row);
    }
  }
  std::set<std::string> taken;
  for (StoredProduct& one : instruments) {
    one.id = "instrument-" + std::string(name_of(one.kind)) + "-" + fit_for_a_path(one.station);
    if (!taken.insert(one.id).second) {
      const GeoPoint place = middle_of(one.granules.front().bounds);
      one.id += "-" + sha256_of_text(formatted("{}/{}/{}/{:.3f},{:.3f}", one.product_id,
                                               one.dataset_id, static_cast<int>(one.vertical),
                                               place.latitude_deg(), place.longitude_deg()))
                          .substr(0, 6);
      taken.insert(one.id);
    }
  }
  std::vector<StoredProduct> whole;
  for (StoredProduct& one : instruments)
    if (settle_names(one)) whole.push_back(std::move(one));
  std::sort(whole.begin(), whole.end(),
            [](const StoredProduct& a, const StoredProduct& b) { return a.id < b.id; });
  return whole;
}

}  // namespace slackwater::api
