#include "tests/support/point_series_for_tests.h"

#include <cmath>
#include <numbers>

#include "ingest/netcdf/file.h"

namespace slackwater::tests {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;
using Layout = SeriesLevelsForTests;

constexpr double fill = 9.969209968386869e36;

/// One of the two numbers that are written for a vector.
struct Part {
  std::string name;
  std::string standard_name;
  std::string unit;
  std::function<double(Horizontal)> of;
};

std::vector<Part> parts_of(const PointSeriesForTests& series) {
  const bool wind = series.depth_m.empty();
  const std::string what = wind ? "wind" : "sea_water_velocity";
  if (!series.as_speed_and_direction) {
    return {
        {"eastward_" + what, "eastward_" + what, "m s-1", [](Horizontal v) { return v.real(); }},
        {"northward_" + what, "northward_" + what, "m s-1", [](Horizontal v) { return v.imag(); }}};
  }
  // A wind comes from, a current goes to.
  const double sign = wind ? -1 : 1;
  const auto degrees = [sign](Horizontal v) {
    const double angle = std::atan2(sign * v.real(), sign * v.imag()) * 180.0 / std::numbers::pi;
    return angle < 0 ? angle + 360 : angle;
  };
  return {{"speed", wind ? "wind_speed" : "sea_water_speed", "m s-1",
           [](Horizontal v) { return std::abs(v); }},
          {"direction", wind ? "wind_from_direction" : "sea_water_velocity_to_direction", "degree",
           degrees}};
}

class SeriesWriter {
 public:
  SeriesWriter(const std::filesystem::path& file, const PointSeriesForTests& series)
      : series_(series), writer_(Writer::create(file)) {}

  void write() {
    time_dimension_ = writer_.dimension("time", series_.time.size());
    time_ = writer_.variable("time", Type::float64, {time_dimension_});
    writer_.attribute(time_, "standard_name", "time");
    writer_.attribute(time_, "units", "seconds since 1970-01-01 00:00:00");
    define_place();
    define_levels();
    define_values();
    writer_.attribute(Writer::global, "Conventions", "CF-1.8");
    for (const auto& [name, text] : series_.global) writer_.attribute(Writer::global, name, text);
    const bool profile = !series_.depth_m.empty() && series_.levels != Layout::own_variables &&
                         series_.levels != Layout::own_stations;
    writer_.attribute(Writer::global, "featureType", profile ? "timeSeriesProfile" : "timeSeries");
    writer_.attribute(Writer::global, "platform_code", series_.station);
    if (series_.water_depth_m)
      writer_.attribute(Writer::global, "water_depth", *series_.water_depth_m);
    writer_.end_definitions();
    fill_axes();
    for (const auto& [id, values] : values_) writer_.write_all(id, values);
    writer_.close();
  }

 private:
  [[nodiscard]] bool over_stations() const {
    return series_.levels == Layout::station_axis || series_.levels == Layout::own_stations;
  }
  [[nodiscard]] std::size_t stations() const {
    return series_.levels == Layout::own_stations ? series_.depth_m.size() : 1;
  }

  void define_place() {
    std::vector<int> dimensions;
    if (over_stations()) {
      station_dimension_ = writer_.dimension("station", stations());
      dimensions = {station_dimension_};
    }
    latitude_ = writer_.variable("lat", Type::float64, dimensions);
    writer_.attribute(latitude_, "standard_name", "latitude");
    writer_.attribute(latitude_, "units", "degrees_north");
    longitude_ = writer_.variable("lon", Type::float64, dimensions);
    writer_.attribute(longitude_, "standard_name", "longitude");
    writer_.attribute(longitude_, "units", "degrees_east");
  }

  int vertical(const std::string& name, const std::vector<int>& dimensions,
               const std::string& standard_name, const std::string& positive) {
    const int id = writer_.variable(name, Type::float64, dimensions);
    writer_.attribute(id, "standard_name", standard_name);
    writer_.attribute(id, "units", "m");
    writer_.attribute(id, "positive", positive);
    return id;
  }

  void define_levels() {
    const std::vector<double>& depths = series_.depth_m;
    if (depths.empty()) {
      values_.emplace_back(vertical("height", {}, "height", "up"), std::vector<double>{10.0});
      return;
    }
    if (series_.levels == Layout::own_variables) {
      for (const double depth : depths) {
        values_.emplace_back(vertical("depth" + suffix(depth), {}, "depth", "down"),
                             std::vector<double>{depth});
      }
      return;
    }
    if (series_.levels == Layout::own_stations) {
      values_.emplace_back(vertical("depth", {station_dimension_}, "depth", "down"), depths);
      return;
    }
    const bool up = series_.levels == Layout::upwards;
    const bool bed = series_.levels == Layout::above_bed;
    const std::string name = up || bed ? "z" : "depth";
    level_dimension_ = writer_.dimension(name, depths.size());
    std::vector<double> levels;
    for (const double depth : depths)
      levels.push_back(up ? -depth : bed ? *series_.water_depth_m - depth : depth);
    const int id = vertical(name, {level_dimension_},
                            up    ? "altitude"
                            : bed ? "height_above_sea_floor"
                                  : "depth",
                            up || bed ? "up" : "down");
    values_.emplace_back(id, levels);
  }

  static std::string suffix(double depth) {
    return "_" + std::to_string(static_cast<int>(depth)) + "m";
  }

  int quantity(const Part& part, const std::string& name, const std::vector<int>& dimensions,
               const std::string& coordinates) {
    const int id = writer_.variable(name, Type::float32, dimensions, {{}, 0, fill});
    if (!series_.bare) writer_.attribute(id, "standard_name", part.standard_name);
    writer_.attribute(id, "units", part.unit);
    writer_.attribute(id, "coordinates", coordinates);
    if (series_.standard_error_m_s && part.unit == "m s-1") state_error(part, name, id, dimensions);
    return id;
  }

  /// The standard error of a variable, in cm/s: files choose their units.
  void state_error(const Part& part, const std::string& name, int of,
                   const std::vector<int>& dimensions) {
    const int id = writer_.variable(name + "_error", Type::float32, dimensions, {{}, 0, fill});
    writer_.attribute(of, "ancillary_variables", name + "_error");
    writer_.attribute(id, "standard_name", part.standard_name + " standard_error");
    writer_.attribute(id, "units", "cm s-1");
    const std::size_t levels = dimensions.size() > 1 ? series_.depth_m.size() : 1;
    values_.emplace_back(
        id, std::vector<double>(series_.time.size() * levels, 100 * *series_.standard_error_m_s));
  }

  [[nodiscard]] double value_of(const Part& part, UtcTime time, double depth) const {
    const Horizontal value = series_.value(time, depth);
    return std::isnan(value.real()) ? fill : part.of(value);
  }

  void define_values() {
    for (const Part& part : parts_of(series_)) {
      if (!series_.depth_m.empty() && series_.levels == Layout::own_variables) {
        for (const double depth : series_.depth_m) {
          const int id = quantity(part, part.name + suffix(depth), {time_dimension_},
                                  "lat lon depth" + suffix(depth));
          values_.emplace_back(id, column(part, depth));
        }
        continue;
      }
      values_.emplace_back(quantity(part, part.name, dimensions_of_value(), "lat lon"),
                           table(part));
      if (series_.flag) define_flags(part);
    }
  }

  /// Of (time, depth) or (time).
  void define_flags(const Part& part) {
    const int id = writer_.variable(part.name + "_QC", Type::float32, dimensions_of_value());
    writer_.attribute(id, "conventions", "OceanSITES reference table 2");
    std::vector<double> flags;
    const std::vector<double> surface{0};
    for (const UtcTime time : series_.time)
      for (const double depth : series_.depth_m.empty() ? surface : series_.depth_m)
        flags.push_back(series_.flag(time, depth));
    values_.emplace_back(id, flags);
  }

  [[nodiscard]] std::vector<int> dimensions_of_value() const {
    if (series_.depth_m.empty()) return {time_dimension_};
    switch (series_.levels) {
      case Layout::own_stations:
        return {station_dimension_, time_dimension_};
      case Layout::station_axis:
        return {station_dimension_, time_dimension_, level_dimension_};
      case Layout::depth_axis_first:
        return {level_dimension_, time_dimension_};
      default:
        return {time_dimension_, level_dimension_};
    }
  }

  [[nodiscard]] std::vector<double> column(const Part& part, double depth) const {
    std::vector<double> values;
    for (const UtcTime time : series_.time) values.push_back(value_of(part, time, depth));
    return values;
  }

  [[nodiscard]] std::vector<double> table(const Part& part) const {
    if (series_.depth_m.empty()) return column(part, 0);
    std::vector<double> values;
    const bool by_depth =
        series_.levels == Layout::own_stations || series_.levels == Layout::depth_axis_first;
    if (by_depth) {
      for (const double depth : series_.depth_m) {
        const std::vector<double> one = column(part, depth);
        values.insert(values.end(), one.begin(), one.end());
      }
      return values;
    }
    for (const UtcTime time : series_.time)
      for (const double depth : series_.depth_m) values.push_back(value_of(part, time, depth));
    return values;
  }

  void fill_axes() {
    std::vector<double> seconds;
    for (const UtcTime time : series_.time) seconds.push_back(seconds_between(UtcTime{}, time));
    writer_.write_all(time_, seconds);
    writer_.write_all(latitude_, std::vector<double>(stations(), series_.latitude_deg));
    writer_.write_all(longitude_, std::vector<double>(stations(), series_.longitude_deg));
  }

  const PointSeriesForTests& series_;
  Writer writer_;
  int time_dimension_ = 0;
  int station_dimension_ = 0;
  int level_dimension_ = 0;
  int time_ = 0;
  int latitude_ = 0;
  int longitude_ = 0;
  std::vector<std::pair<int, std::vector<double>>> values_;
};

}  // namespace

std::filesystem::path write_point_series(const std::filesystem::path& file,
                                         const PointSeriesForTests& series) {
  SeriesWriter(file, series).write();
  return file;
}

std::vector<UtcTime> stepping_times(UtcDay day, int days, int minutes) {
  std::vector<UtcTime> times;
  for (int m = 0; m < days * 1440; m += minutes)
    times.push_back(UtcTime(day) + std::chrono::minutes(m));
  return times;
}

}  // namespace slackwater::tests
