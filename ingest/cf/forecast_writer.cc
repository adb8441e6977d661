#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast_file.h"
#include "ingest/cf/forecast_names.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {
namespace {

using forecast_names::fill;
using netcdf::Type;
using netcdf::Writer;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// 90 % quantile of the standard normal: p10 and p90 stand this many standard deviations from the
/// median.
constexpr double normal_p90 = 1.2815515655446004;

/// One file being written: the snapshot with the ids of what was defined.
class ForecastWriter {
 public:
  ForecastWriter(const std::filesystem::path& file, const Snapshot& snapshot)
      : out_(Writer::create(file)), s_(snapshot), many_(snapshot.columns.size() > 1) {}

  void write() {
    define_axes();
    define_currents();
    define_wind();
    define_sea();
    describe();
    out_.end_definitions();
    write_axes();
    write_currents();
    write_wind();
    write_sea();
    out_.close();
  }

 private:
  std::vector<int> surface_dims() const {
    return many_ ? std::vector{time_, column_} : std::vector{time_};
  }
  std::vector<int> depth_dims() const {
    return many_ ? std::vector{time_, depth_, column_} : std::vector{time_, depth_};
  }
  std::string coordinates(bool with_depth) const {
    return std::string("time ") + (with_depth ? "depth " : "") + "latitude longitude station_name";
  }

  int define(const std::string& name, Type type, const std::vector<int>& dims,
             const std::string& standard_name, const std::string& long_name,
             const std::string& units, bool on_depth) {
    Writer::Layout layout;
    if (type == Type::float64) layout.fill_value = fill;
    const int id = out_.variable(name, type, dims, layout);
    if (!standard_name.empty()) out_.attribute(id, "standard_name", standard_name);
    out_.attribute(id, "long_name", long_name);
    if (!units.empty()) out_.attribute(id, "units", units);
    out_.attribute(id, "coordinates", coordinates(on_depth));
    return id;
  }

  void define_axes() {
    time_ = out_.dimension("time", s_.time.size());
    depth_ = out_.dimension("depth", std::max<std::size_t>(1, s_.depth_m.size()));
    if (many_) column_ = out_.dimension("column", s_.columns.size());
    const int text = out_.dimension("name_length", std::max<std::size_t>(1, s_.site_name.size()));
    time_id_ = out_.variable("time", Type::float64, {time_});
    out_.attribute(time_id_, "standard_name", "time");
    out_.attribute(time_id_, "long_name", "valid time");
    out_.attribute(time_id_, "units", "seconds since 1970-01-01 00:00:00");
    out_.attribute(time_id_, "calendar", "standard");
    out_.attribute(time_id_, "axis", "T");
    depth_id_ = out_.variable("depth", Type::float64, {depth_});
    out_.attribute(depth_id_, "standard_name", "depth");
    out_.attribute(depth_id_, "long_name", "depth below mean sea level");
    out_.attribute(depth_id_, "units", "m");
    out_.attribute(depth_id_, "positive", "down");
    out_.attribute(depth_id_, "axis", "Z");
    const std::vector<int> place = many_ ? std::vector{column_} : std::vector<int>{};
    latitude_id_ = out_.variable("latitude", Type::float64, place);
    out_.attribute(latitude_id_, "standard_name", "latitude");
    out_.attribute(latitude_id_, "long_name", "latitude of the column");
    out_.attribute(latitude_id_, "units", "degrees_north");
    longitude_id_ = out_.variable("longitude", Type::float64, place);
    out_.attribute(longitude_id_, "standard_name", "longitude");
    out_.attribute(longitude_id_, "long_name", "longitude of the column");
    out_.attribute(longitude_id_, "units", "degrees_east");
    station_id_ = out_.variable("station_name", Type::character, {text});
    out_.attribute(station_id_, "long_name", "site name");
    if (!many_) out_.attribute(station_id_, "cf_role", "timeseries_id");
    reference_id_ = out_.variable("forecast_reference_time", Type::float64, {});
    out_.attribute(reference_id_, "standard_name", "forecast_reference_time");
    out_.attribute(reference_id_, "long_name",
                   "end of the last calibrated day; lead counts from here");
    out_.attribute(reference_id_, "units", "seconds since 1970-01-01 00:00:00");
    out_.attribute(reference_id_, "calendar", "standard");
    period_id_ = out_.variable("forecast_period", Type::float64, {time_});
    out_.attribute(period_id_, "standard_name", "forecast_period");
    out_.attribute(period_id_, "long_name", "lead since the end of the last calibrated day");
    out_.attribute(period_id_, "units", "h");
    bed_id_ = out_.variable("sea_floor_depth", Type::float64, place);
    out_.attribute(bed_id_, "standard_name", "sea_floor_depth_below_geoid");
    out_.attribute(bed_id_, "long_name", "water depth used");
    out_.attribute(bed_id_, "units", "m");
  }

  void define_currents() {
    if (s_.depth_m.empty()) return;
    east_id_ = define(forecast_names::east, Type::float64, depth_dims(), forecast_names::east,
                      "eastward current, member 0, Eulerian", "m s-1", true);
    north_id_ = define(forecast_names::north, Type::float64, depth_dims(), forecast_names::north,
                       "northward current, member 0, Eulerian", "m s-1", true);
    for (const int id : {east_id_, north_id_}) {
      out_.attribute(id, "ancillary_variables",
                     std::string(forecast_names::status) + " " + forecast_names::sigma);
    }
    sigma_id_ = define(forecast_names::sigma, Type::float64, depth_dims(), "",
                       "standard deviation of each current component", "m s-1", true);
    status_id_ = define(forecast_names::status, Type::int8, depth_dims(), "",
                        "why a current is, or is not, there", "", true);
    const std::vector<double> flags{0, 1, 2, 3, 4, 5, 6, 7, 8};
    out_.attribute(status_id_, "flag_values", flags, Type::int8);
    out_.attribute(
        status_id_, "flag_meanings",
        "ok missing land below_bed outside_area outside_time above_surface not_checked suspect");
    for (const char* const quantile : {"_p10", "_p50", "_p90"}) {
      const std::string percent = std::string(quantile).substr(2) + " % quantile";
      quantile_ids_.push_back(define(std::string(forecast_names::east) + quantile, Type::float64,
                                     depth_dims(), "", "eastward current, " + percent, "m s-1",
                                     true));
      quantile_ids_.push_back(define(std::string(forecast_names::north) + quantile, Type::float64,
                                     depth_dims(), "", "northward current, " + percent, "m s-1",
                                     true));
    }
  }

  bool has_wind() const { return !s_.columns.front().wind_m_s.empty(); }
  bool has_sea() const { return !s_.columns.front().sea.empty(); }

  int define_source(const std::string& name, const std::string& long_name) {
    const int id = define(name, Type::int8, surface_dims(), "", long_name, "", false);
    const std::vector<double> flags{0, 1, 2, 3, 4};
    out_.attribute(id, "flag_values", flags, Type::int8);
    out_.attribute(id, "flag_meanings", "analysis forecast observation persisted modelled");
    return id;
  }

  void define_wind() {
    if (!has_wind()) return;
    wind_ids_ = {define("eastward_wind", Type::float64, surface_dims(), "eastward_wind",
                        "eastward wind at 10 m", "m s-1", false),
                 define("northward_wind", Type::float64, surface_dims(), "northward_wind",
                        "northward wind at 10 m", "m s-1", false),
                 define_source("wind_source", "where the wind comes from")};
  }

  void define_sea() {
    if (!has_sea()) return;
    sea_ids_ = {
        define(forecast_names::wave_height, Type::float64, surface_dims(),
               forecast_names::wave_height, "significant wave height", "m", false),
        define(forecast_names::wave_period, Type::float64, surface_dims(),
               forecast_names::wave_period, "peak wave period", "s", false),
        define(forecast_names::wave_direction, Type::float64, surface_dims(),
               forecast_names::wave_direction,
               "direction that waves come from, clockwise from true north", "degree", false),
        define_source("wave_source", "where the sea state comes from")};
  }

  void describe() {
    const auto global = [&](const std::string& name, const std::string& text) {
      out_.attribute(Writer::global, name, text);
    };
    global("Conventions", "CF-1.8");
    if (!many_) global("featureType", "timeSeriesProfile");
    global("title", "Slackwater current forecast for " + s_.site_name);
    global("institution", "Slackwater");
    global("source", "Ekman column model calibrated on " + format_day(s_.day));
    global("history", format_utc(s_.issued) + " issued by Slackwater");
    std::string credit;
    for (const std::string& line : s_.attributions) credit += (credit.empty() ? "" : "\n") + line;
    global("references", credit.empty() ? "none" : credit);
    global("comment", s_.headline.empty() ? "none" : s_.headline);
    global("slackwater_site_id", s_.site_id);
    global("slackwater_site_name", s_.site_name);
    global("slackwater_day", format_day(s_.day));
    global("slackwater_issued", format_utc(s_.issued));
    global("slackwater_wind_policy", s_.wind_policy);
    global("slackwater_degraded", s_.degraded ? "true" : "false");
    global("slackwater_contains_stokes", s_.contains_stokes ? "true" : "false");
    global("slackwater_headline", s_.headline);
    global("slackwater_attributions", credit);
    global("slackwater_provenance", s_.provenance_json);
    std::string depth_sources;
    for (const ForecastColumn& column : s_.columns) {
      depth_sources += (depth_sources.empty() ? "" : "\n") + column.water_depth_source;
    }
    global("slackwater_water_depth_sources", depth_sources);
  }

  void write_axes() {
    std::vector<double> time;
    std::vector<double> lead;
    const UtcTime reference = UtcTime(s_.day) + std::chrono::days(1);
    for (const UtcTime stamp : s_.time) {
      time.push_back(seconds_between(UtcTime{}, stamp));
      lead.push_back(hours_between(reference, stamp));
    }
    out_.write_all(time_id_, time);
    out_.write_all(period_id_, lead);
    out_.write_all(depth_id_, s_.depth_m.empty() ? std::vector<double>{0.0} : s_.depth_m);
    std::vector<double> latitude;
    std::vector<double> longitude;
    std::vector<double> bed;
    for (const ForecastColumn& column : s_.columns) {
      latitude.push_back(column.point.latitude_deg());
      longitude.push_back(column.point.longitude_deg());
      bed.push_back(column.water_depth_m);
    }
    out_.write_all(latitude_id_, latitude);
    out_.write_all(longitude_id_, longitude);
    out_.write_all(bed_id_, bed);
    out_.write_text(station_id_, s_.site_name);
    out_.write_all(reference_id_, std::vector<double>{seconds_between(UtcTime{}, reference)});
  }

  template <typename Value>
  void put(int id, std::size_t per_time, Value value) {
    std::vector<double> values;
    values.reserve(s_.time.size() * per_time * s_.columns.size());
    for (std::size_t o = 0; o < s_.time.size() * per_time; ++o) {
      for (const ForecastColumn& column : s_.columns) {
        const double v = value(column, o);
        values.push_back(std::isnan(v) ? fill : v);
      }
    }
    out_.write_all(id, values);
  }

  void write_currents() {
    const std::size_t levels = s_.depth_m.size();
    if (levels == 0) return;
    const auto current = [](bool north, double sigmas) {
      return [north, sigmas](const ForecastColumn& c, std::size_t o) {
        if (!has_value(c.current_status[o])) return nan;
        const double middle = north ? c.current_m_s[o].imag() : c.current_m_s[o].real();
        return sigmas == 0 ? middle : middle + sigmas * c.current_sigma_m_s[o];
      };
    };
    put(east_id_, levels, current(false, 0));
    put(north_id_, levels, current(true, 0));
    put(sigma_id_, levels, [](const ForecastColumn& c, std::size_t o) {
      return has_value(c.current_status[o]) ? c.current_sigma_m_s[o] : nan;
    });
    put(status_id_, levels, [](const ForecastColumn& c, std::size_t o) {
      return static_cast<double>(c.current_status[o]);
    });
    std::size_t next = 0;
    for (const double sigmas : {-normal_p90, 0.0, normal_p90}) {
      put(quantile_ids_[next++], levels, current(false, sigmas));
      put(quantile_ids_[next++], levels, current(true, sigmas));
    }
  }

  void write_wind() {
    if (wind_ids_.empty()) return;
    const auto at = [](const ForecastColumn& c, std::size_t o) {
      return o < c.wind_m_s.size() ? c.wind_m_s[o] : Horizontal(nan, nan);
    };
    put(wind_ids_[0], 1, [&](const ForecastColumn& c, std::size_t o) { return at(c, o).real(); });
    put(wind_ids_[1], 1, [&](const ForecastColumn& c, std::size_t o) { return at(c, o).imag(); });
    put(wind_ids_[2], 1, [](const ForecastColumn& c, std::size_t o) {
      return o < c.wind_source.size() ? static_cast<double>(c.wind_source[o]) : 0.0;
    });
  }

  void write_sea() {
    if (sea_ids_.empty()) return;
    const auto at = [](const ForecastColumn& c, std::size_t o) {
      return o < c.sea.size() ? c.sea[o] : SeaState{nan, nan, nan};
    };
    put(sea_ids_[0], 1,
        [&](const ForecastColumn& c, std::size_t o) { return at(c, o).significant_height_m; });
    put(sea_ids_[1], 1,
        [&](const ForecastColumn& c, std::size_t o) { return at(c, o).peak_period_s; });
    put(sea_ids_[2], 1,
        [&](const ForecastColumn& c, std::size_t o) { return at(c, o).from_direction_deg; });
    put(sea_ids_[3], 1, [](const ForecastColumn& c, std::size_t o) {
      return o < c.sea_source.size() ? static_cast<double>(c.sea_source[o]) : 0.0;
    });
  }

  Writer out_;
  const Snapshot& s_;
  bool many_;
  int time_ = 0, depth_ = 0, column_ = 0;
  int time_id_ = 0, depth_id_ = 0, latitude_id_ = 0, longitude_id_ = 0, station_id_ = 0,
      reference_id_ = 0, period_id_ = 0, bed_id_ = 0, east_id_ = 0, north_id_ = 0, sigma_id_ = 0,
      status_id_ = 0;
  std::vector<int> quantile_ids_, wind_ids_, sea_ids_;
};

}  // namespace

void write_forecast(const std::filesystem::path& file, const Snapshot& snapshot) {
  expects(!snapshot.columns.empty() && !snapshot.time.empty(), "a forecast has columns and times");
  with_context("writing forecast " + file.string(),
               [&] { ForecastWriter(file, snapshot).write(); });
}

}  // namespace slackwater::ingest
