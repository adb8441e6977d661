#include "tests/support/product_files_for_tests.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>

#include "ingest/netcdf/file.h"

namespace slackwater::tests {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

constexpr double fill = 9.969209968386869e36;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool is_land(const ProductCell& cell) {
  return cell.longitude_deg > WaterForTests::land_east_of_deg;
}

/// Phase of the M2 tide, 12.4206 h.
double tide_phase(const ProductCell& cell) {
  return 2 * std::numbers::pi * hours_between(UtcTime{}, cell.time) / 12.4206;
}

/// Slow weather, about three days long.
double weather_phase(const ProductCell& cell) {
  return 2 * std::numbers::pi * hours_between(UtcTime{}, cell.time) / 76;
}

/// A tide loses strength in the lowest metres.
double share_of_tide(const ProductCell& cell) {
  return 0.7 + 0.3 * (1 - std::exp((cell.depth_m - WaterForTests::depth_m) / 8.0));
}

int axis(Writer& writer, const char* name, int dimension, const char* unit, const char* letter) {
  const int id = writer.variable(name, Type::float64, {dimension});
  writer.attribute(id, "standard_name", name);
  writer.attribute(id, "units", unit);
  writer.attribute(id, "axis", letter);
  return id;
}

std::vector<double> seconds_of(const std::vector<UtcTime>& times) {
  std::vector<double> seconds;
  for (const UtcTime time : times) seconds.push_back(seconds_between(UtcTime{}, time));
  return seconds;
}

}  // namespace

ProductQuantity& ProductForTests::quantity(const std::string& name) {
  for (ProductQuantity& q : quantities) {
    if (q.name == name) return q;
  }
  throw std::out_of_range("no quantity " + name);
}

double WaterForTests::eastward_m_s(const ProductCell& cell) {
  if (is_land(cell)) return none;
  const double tide = 0.6 * share_of_tide(cell) * std::cos(tide_phase(cell));
  const double driven = 0.012 * eastward_wind_m_s(cell) * std::exp(-cell.depth_m / 8) *
                        std::cos(cell.depth_m / 10 + 0.8);
  return tide + driven + 0.05 + 0.02 * (cell.latitude_deg - site_latitude_deg);
}

double WaterForTests::northward_m_s(const ProductCell& cell) {
  if (is_land(cell)) return none;
  const double tide = 0.2 * share_of_tide(cell) * std::sin(tide_phase(cell));
  const double driven = -0.012 * eastward_wind_m_s(cell) * std::exp(-cell.depth_m / 8) *
                        std::sin(cell.depth_m / 10 + 0.8);
  return tide + driven - 0.03;
}

double WaterForTests::eastward_wind_m_s(const ProductCell& cell) {
  return 9 + 3 * std::sin(weather_phase(cell));
}
double WaterForTests::northward_wind_m_s(const ProductCell& cell) {
  return 2 * std::cos(weather_phase(cell));
}

double WaterForTests::significant_height_m(const ProductCell& cell) {
  return is_land(cell) ? none : 1.5 + 0.4 * std::sin(weather_phase(cell) - 0.5);
}

std::vector<UtcTime> hourly_times(UtcDay day, int hours) {
  std::vector<UtcTime> times;
  for (int h = 0; h < hours; ++h) times.push_back(UtcTime(day) + std::chrono::hours(h));
  return times;
}

ProductForTests current_product(UtcDay day, int hours) {
  ProductForTests product;
  product.title = "NWSHELF_ANALYSISFORECAST_PHY_004_013 hourly currents";
  product.time = hourly_times(day, hours);
  product.depth_m = {0, 5, 10, 20, 30};
  product.quantities = {
      {"uo", "eastward_sea_water_velocity", "m s-1", true, WaterForTests::eastward_m_s},
      {"vo", "northward_sea_water_velocity", "m s-1", true, WaterForTests::northward_m_s}};
  return product;
}

ProductForTests mean_current_product(UtcDay day, int days, int averaging_h) {
  ProductForTests product = current_product(day, 0);
  product.title = "NWSHELF_ANALYSISFORECAST_PHY_004_013 currents averaged";
  product.cell_methods = "time: mean";
  const Duration step = std::chrono::hours(averaging_h);
  for (UtcTime from(day); from < UtcTime(day) + std::chrono::days(days); from += step)
    product.time.push_back(from + step / 2);
  for (ProductQuantity& q : product.quantities) {
    q.value = [value = q.value, step](ProductCell cell) {
      const int parts = 48;
      const UtcTime from = cell.time - step / 2;
      double sum = 0;
      for (int i = 0; i < parts; ++i) {
        cell.time = from + step * (2 * i + 1) / (2 * parts);
        sum += value(cell);
      }
      return sum / parts;
    };
  }
  return product;
}

ProductForTests wind_product(UtcDay day, int hours) {
  ProductForTests product;
  product.title = "WIND_GLO_PHY_L4_NRT_012_004 hourly wind";
  product.time = hourly_times(day, hours);
  product.quantities = {
      {"eastward_wind", "eastward_wind", "m s-1", false, WaterForTests::eastward_wind_m_s},
      {"northward_wind", "northward_wind", "m s-1", false, WaterForTests::northward_wind_m_s}};
  return product;
}

ProductForTests wave_product(UtcDay day, int hours) {
  ProductForTests product;
  product.title = "NWSHELF_ANALYSISFORECAST_WAV_004_014 hourly waves";
  product.time = hourly_times(day, hours);
  const auto wet = [](double value) {
    return [value](const ProductCell& cell) { return is_land(cell) ? none : value; };
  };
  product.quantities = {{"VHM0", "sea_surface_wave_significant_height", "m", false,
                         WaterForTests::significant_height_m},
                        {"VTPK", "sea_surface_wave_period_at_variance_spectral_density_maximum",
                         "s", false, wet(6.5)},
                        {"VMDR", "sea_surface_wave_from_direction", "degree", false, wet(265)}};
  return product;
}

ProductForTests bathymetry_product() {
  ProductForTests product;
  product.title = "NWSHELF_ANALYSISFORECAST_PHY_004_013 bathymetry";
  product.quantities = {
      {"deptho", "sea_floor_depth_below_geoid", "m", false,
       [](const ProductCell& cell) { return is_land(cell) ? none : WaterForTests::depth_m; }}};
  return product;
}

std::filesystem::path write_product(const std::filesystem::path& file,
                                    const ProductForTests& product) {
  Writer writer = Writer::create(file);
  writer.attribute(Writer::global, "Conventions", "CF-1.8");
  writer.attribute(Writer::global, "title", product.title);
  for (const auto& [name, text] : product.global) writer.attribute(Writer::global, name, text);
  std::vector<int> plane;
  int time_id = -1;
  int depth_id = -1;
  int depth_dimension = -1;
  if (!product.time.empty()) {
    plane.push_back(writer.dimension("time", product.time.size()));
    time_id = axis(writer, "time", plane.back(), "seconds since 1970-01-01T00:00:00Z", "T");
    writer.attribute(time_id, "calendar", "gregorian");
  }
  if (!product.depth_m.empty()) {
    depth_dimension = writer.dimension("depth", product.depth_m.size());
    depth_id = axis(writer, "depth", depth_dimension, "m", "Z");
    writer.attribute(depth_id, "positive", "down");
  }
  const int latitude = writer.dimension("latitude", product.latitude_deg.size());
  const int longitude = writer.dimension("longitude", product.longitude_deg.size());
  const int latitude_id = axis(writer, "latitude", latitude, "degrees_north", "Y");
  const int longitude_id = axis(writer, "longitude", longitude, "degrees_east", "X");
  int reference_id = -1;
  if (product.reference_time) {
    reference_id = writer.variable("forecast_reference_time", Type::float64, {});
    writer.attribute(reference_id, "standard_name", "forecast_reference_time");
    writer.attribute(reference_id, "units", "seconds since 1970-01-01T00:00:00Z");
  }
  std::vector<int> ids;
  for (const ProductQuantity& q : product.quantities) {
    std::vector<int> dimensions = plane;
    if (q.has_depth && depth_dimension >= 0) dimensions.push_back(depth_dimension);
    dimensions.insert(dimensions.end(), {latitude, longitude});
    ids.push_back(writer.variable(q.name, Type::float32, dimensions,
                                  {.chunks = {}, .deflate = 0, .fill_value = fill}));
    if (!q.standard_name.empty()) writer.attribute(ids.back(), "standard_name", q.standard_name);
    if (!q.unit.empty()) writer.attribute(ids.back(), "units", q.unit);
    if (!product.cell_methods.empty())
      writer.attribute(ids.back(), "cell_methods", product.cell_methods);
  }
  writer.end_definitions();
  if (time_id >= 0) writer.write_all(time_id, seconds_of(product.time));
  if (depth_id >= 0) writer.write_all(depth_id, product.depth_m);
  writer.write_all(latitude_id, product.latitude_deg);
  writer.write_all(longitude_id, product.longitude_deg);
  if (reference_id >= 0) writer.write_all(reference_id, seconds_of({*product.reference_time}));

  const std::vector<UtcTime> times =
      product.time.empty() ? std::vector<UtcTime>{UtcTime{}} : product.time;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const ProductQuantity& q = product.quantities[i];
    const bool deep = q.has_depth && !product.depth_m.empty();
    const std::vector<double> depths = deep ? product.depth_m : std::vector<double>{0.0};
    std::vector<float> values;
    for (const UtcTime time : times) {
      for (const double depth : depths) {
        for (const double y : product.latitude_deg) {
          for (const double x : product.longitude_deg) {
            const double value = q.value({time, depth, y, x});
            values.push_back(
                static_cast<float>(std::isnan(value) && !product.writes_nan ? fill : value));
          }
        }
      }
    }
    std::vector<std::size_t> shape;
    if (!product.time.empty()) shape.push_back(times.size());
    if (deep) shape.push_back(depths.size());
    shape.push_back(product.latitude_deg.size());
    shape.push_back(product.longitude_deg.size());
    writer.write(ids[i], std::vector<std::size_t>(shape.size(), 0), shape,
                 std::span<const float>(values));
  }
  writer.close();
  return file;
}

std::filesystem::path write_site(const std::filesystem::path& file, const std::string& more,
                                 double latitude_deg, double longitude_deg) {
  std::ofstream stream(file);
  stream << "id: test_site\nname: Test site\nlatitude_deg: " << latitude_deg
         << "\nlongitude_deg: " << longitude_deg << "\nwater_depth_m: " << WaterForTests::depth_m
         << "\n"
         << more;
  return file;
}

}  // namespace slackwater::tests
