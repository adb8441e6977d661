#include "api/door/edr/sample/product_collection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

/// The collection of the forecasts whose quantities a product of this kind has.
const Collection& forecast_of(ProductKind kind) {
  return collection_named(std::string(name_of(kind)));
}

/// Of vectors: both components, speed, direction.
constexpr std::size_t of_a_vector = 4;

/// What products have and forecasts have not.
Parameter further(const std::string& standard_name) {
  struct Words {
    const char* name;
    const char* label;
    const char* unit;
    const char* unit_label;
  };
  constexpr std::array all{
      Words{"wind_speed_of_gust", "Gust speed", "m/s", "metre per second"},
      Words{"sea_surface_wind_wave_significant_height", "Wind sea, significant height", "m",
            "metre"},
      Words{"sea_surface_wind_wave_mean_period", "Wind sea, mean period", "s", "second"},
      Words{"sea_surface_wind_wave_from_direction", "Direction the wind sea comes from", "deg",
            "degree"},
      Words{"sea_surface_primary_swell_wave_significant_height", "Higher swell, significant height",
            "m", "metre"},
      Words{"sea_surface_primary_swell_wave_mean_period", "Higher swell, mean period", "s",
            "second"},
      Words{"sea_surface_primary_swell_wave_from_direction",
            "Direction the higher swell comes from", "deg", "degree"},
      Words{"sea_surface_secondary_swell_wave_significant_height",
            "Lower swell, significant height", "m", "metre"},
      Words{"sea_surface_secondary_swell_wave_mean_period", "Lower swell, mean period", "s",
            "second"},
      Words{"sea_surface_secondary_swell_wave_from_direction",
            "Direction the lower swell comes from", "deg", "degree"}};
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Words& words) { return words.name == standard_name; });
  expects(found != all.end(), "words for each quantity of a product");
  return {found->name, found->name, found->label, {}, found->unit, found->unit_label, {}};
}

/// Those of the forecasts' that a product of the kind has too, as they stand there.
std::vector<Parameter> shared_with_forecasts(const StoredProduct& product) {
  std::vector<Parameter> list = parameters_of(forecast_of(product.kind), 1);
  if (product.kind != ProductKind::waves) {
    list.resize(of_a_vector);
    return list;
  }
  std::erase_if(list, [&](const Parameter& parameter) {
    const auto& held = product.standard_names;
    return std::find(held.begin(), held.end(), parameter.standard_name) == held.end();
  });
  return list;
}

template <typename Sample>
void append_vectors(const Quantities<Sample>& quantities, std::span<const std::size_t> selected,
                    const std::vector<std::vector<double>>& stored,
                    std::vector<std::vector<double>>& values) {
  std::vector<Sample> samples(stored.front().size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Horizontal towards(stored[0][i], stored[1][i]);
    if (std::isnan(towards.real() + towards.imag())) continue;
    samples[i].velocity_m_s = towards;
    samples[i].status = SampleStatus::ok;
  }
  for (std::size_t p = 0; p < selected.size(); ++p) {
    if (selected[p] < of_a_vector)
      quantities[selected[p]].append(std::span<const Sample>(samples), values[p]);
  }
}

std::string longitude_text(double degrees) {
  return formatted("{:.2f} {}", std::abs(degrees), degrees < 0 ? "W" : "E");
}
std::string latitude_text(double degrees) {
  return formatted("{:.2f} {}", std::abs(degrees), degrees < 0 ? "S" : "N");
}

}  // namespace

std::string title_of(const StoredProduct& product) {
  constexpr std::array<std::string_view, 3> kinds{"Currents", "Wind", "Waves"};
  if (product.is_measured())
    return std::string(kinds[static_cast<std::size_t>(product.kind)]) + " measured by " +
           product.station;
  return std::string(kinds[static_cast<std::size_t>(product.kind)]) + " of " +
         (product.dataset_id.empty() ? product.product_id : product.dataset_id);
}

std::string description_of(const StoredProduct& product) {
  if (product.is_measured()) {
    return sentence("what the instruments of " + product.station + " measured of " +
                    std::string(name_of(product.kind)) + ", product " + product.product_id) +
           " Given where they stand, at their own times and levels: nothing is interpolated. Only "
           "values whose quality was checked and found good; what is not is null.";
  }
  std::string text = sentence(
      "the product's own values of " + std::string(name_of(product.kind)) + " as stored, " +
      (product.dataset_id.empty() ? "product " + product.product_id
                                  : "dataset " + product.dataset_id + " of " + product.product_id));
  text +=
      " Given at its own times, levels and cells; between cells and levels interpolated, in "
      "time never.";
  if (product.runs.empty()) return text;
  if (product.has_analysis) {
    text += " Analyses stand before forecasts, and of these the newest run.";
  } else if (product.runs.size() > 1) {
    text += " Of several runs the newest speaks.";
  }
  const std::string first = format_utc(product.runs.front());
  text += product.runs.size() > 1
              ? " Runs from " + first + " to " + format_utc(product.runs.back()) +
                    "; forecast_period tells them apart."
              : " The run of " + first + "; forecast_period counts from it.";
  return text;
}

std::string held_text(const StoredProduct& product) {
  if (product.is_measured()) {
    return product.station + " measures at " + position_text(place_of(product)) +
           " and is asked within some 5 km of it, " + format_utc(product.from) + "/" +
           format_utc(product.to);
  }
  return "the product holds " + longitude_text(product.bounds.west_deg) + " to " +
         longitude_text(product.bounds.east_deg) + ", " + latitude_text(product.bounds.south_deg) +
         " to " + latitude_text(product.bounds.north_deg) + ", " + format_utc(product.from) + "/" +
         format_utc(product.to);
}

GeoPoint place_of(const StoredProduct& measured) {
  const slackwater::BoundingBox& box = measured.bounds;
  const double east = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  return GeoPoint::from_degrees(0.5 * (box.south_deg + box.north_deg),
                                std::remainder(0.5 * (box.west_deg + east), 360.0));
}

std::string own_location(const StoredProduct& measured) {
  return measured.id.substr(std::string("instrument-").size() + name_of(measured.kind).size() + 1);
}

Vertical vertical_of(const StoredProduct& product) {
  if (product.vertical == VerticalKind::depth_m) return Vertical::depth_down;
  return product.vertical == VerticalKind::height_m ? Vertical::height_up : Vertical::none;
}

std::vector<Parameter> parameters_of(const StoredProduct& product) {
  std::vector<Parameter> list = shared_with_forecasts(product);
  for (const std::string& name : product.standard_names) {
    if (std::none_of(list.begin(), list.end(),
                     [&](const Parameter& one) { return one.standard_name == name; }))
      list.push_back(further(name));
  }
  for (Parameter& parameter : list) {
    const bool is_direction = parameter.unit == "deg";
    parameter.method = product.is_measured() ? "measured" : "product";
    parameter.description = parameter.label +
                            (is_direction ? ", degrees clockwise from true north" : "") +
                            (product.is_measured() ? ", as measured" : ", as the product has it");
  }
  if (product.is_measured()) return list;
  list.push_back({"forecast_period", "forecast_period", "Forecast period",
                  "Hours from the provider's run to the time: 0 of an analysis, null where the "
                  "files do not say when it was run",
                  "h", "hour", "product"});
  return list;
}

std::vector<std::vector<double>> values_of(const StoredProduct& product,
                                           std::span<const std::size_t> selected,
                                           std::vector<std::vector<double>> stored) {
  std::vector<std::vector<double>> values(selected.size());
  const auto& quantities = forecast_of(product.kind).quantities;
  if (product.kind == ProductKind::currents)
    append_vectors(std::get<Quantities<CurrentSample>>(quantities), selected, stored, values);
  if (product.kind == ProductKind::wind)
    append_vectors(std::get<Quantities<WindSample>>(quantities), selected, stored, values);
  const bool is_vector = product.kind != ProductKind::waves;
  for (std::size_t p = 0; p < selected.size(); ++p) {
    if (!is_vector) values[p] = stored[selected[p]];
    if (is_vector && selected[p] >= of_a_vector)
      values[p] = stored[vector_components + selected[p] - of_a_vector];
  }
  return values;
}

bool is_for_products(std::string_view query) noexcept {
  return query == "position" || query == "radius" || query == "area" || query == "cube";
}

}  // namespace slackwater::api::edr
