#pragma once
#include <cmath>
#include <functional>
#include <string>

#include "fields/base/error.h"
#include "tests/api/door/edr/product_service_for_tests.h"
#include "tests/support/made_up_forecast.h"

// Products that a store holds, and what their collections are called: for the tests of each.

namespace slackwater::tests::edr_products {

using nlohmann::json;

inline const UtcDay day = parse_day("2025-03-10");
inline const UtcTime midnight(day);
inline constexpr const char* currents =
    "/collections/product-currents-NWSHELF_ANALYSISFORECAST_PHY_004_013";
inline constexpr const char* wind = "/collections/product-wind-WIND_GLO_PHY_L4_NRT_012_004";
/// Values stand in files as float, and in answers with six digits: half of the sixth, and a little
/// for float, of values below 10 and of values below 100.
inline constexpr double rounding = 6e-6;
inline constexpr double rounding_of_tens = 6e-5;

inline std::string waves_of(const ProductServiceForTests& service) {
  for (const auto& product : *service.catalogue()->products)
    if (product.kind == api::ProductKind::waves) return "/collections/" + product.id;
  return "none";
}

inline const ProductServiceForTests& all_kinds() {
  static ProductServiceForTests service;
  static const bool is_filled = [] {
    service.with(current_product(day)).with(wind_product(day)).with(wave_product(day));
    return true;
  }();
  static_cast<void>(is_filled);
  return service;
}

inline ProductForTests forecast_of(UtcDay first, UtcTime run, double eastward_m_s) {
  ProductForTests product = current_product(first);
  product.reference_time = run;
  product.quantity("uo").value = [=](const ProductCell& cell) {
    return cell.longitude_deg > WaterForTests::land_east_of_deg ? std::nan("") : eastward_m_s;
  };
  return product;
}

/// Of January, February and March.
inline ProductForTests monthly_means() {
  ProductForTests product = current_product(day);
  product.global = {{"source", "cmems_mod_nws_phy-cur_anfc_1.5km_P1M-m"}};
  product.depth_m = {0, 5};
  product.time = {parse_utc("2025-01-16T12:00:00Z"), parse_utc("2025-02-15T00:00:00Z"),
                  parse_utc("2025-03-16T12:00:00Z")};
  return product;
}

inline Snapshot forecast_at(const std::string& site, double latitude_deg, double longitude_deg) {
  MadeUpForecast size;
  size.hours = 6;
  size.members = 2;
  Snapshot made = made_up_forecast(size);
  made.site_id = site;
  made.columns.front().point = GeoPoint::from_degrees(latitude_deg, longitude_deg);
  return made;
}

inline std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.message();
  }
  return "none";
}

inline std::string notes_of(const json& answer) {
  return answer.at("slackwater:provenance").at("notes").dump();
}

}  // namespace slackwater::tests::edr_products
