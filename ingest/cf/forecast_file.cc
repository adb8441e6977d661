#include "ingest/cf/forecast_file.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {
namespace {

using netcdf::Type;
using netcdf::Writer;

constexpr double fill = 9.969209968386869e+36;  // NC_FILL_DOUBLE
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// 90 % quantile of the standard normal: p10 and p90 stand this many standard deviations from the median.
constexpr double normal_p90 = 1.2815515655446004;

const char* const east_name = "eastward_sea_water_velocity";
const char* const north_name = "northward_sea_water_velocity";
const char* const sigma_name = "sea_water_velocity_component_standard_deviation";
const char* const status_name = "sea_water_velocity_status";
const char* const height_name = "sea_surface_wave_significant_height";
const char* const period_name = "sea_surface_wave_period_at_variance_spectral_density_maximum";
const char* const direction_name = "sea_surface_wave_from_direction";

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
  std::vector<int> surface_dims() const { return many_ ? std::vector{time_, column_} : std::vector{time_}; }
  std::vector<int> depth_dims() const {
    return many_ ? std::vector{time_, depth_, column_} : std::vector{time_, depth_};
  }
  std::string coordinates(bool with_depth) const {
    return std::string("time ") + (with_depth ? "depth " : "") + "latitude longitude station_name";
  }

  int define(const std::string& name, Type type, const std::vector<int>& dims, const std::string& standard_name,
             const std::string& long_name, const std::string& units, bool on_depth) {
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
    out_.attribute(reference_id_, "long_name", "end of the last calibrated day; lead counts from here");
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
    east_id_ = define(east_name, Type::float64, depth_dims(), east_name, "eastward current, member 0, Eulerian",
                      "m s-1", true);
    north_id_ = define(north_name, Type::float64, depth_dims(), north_name,
                       "northward current, member 0, Eulerian", "m s-1", true);
    for (const int id : {east_id_, north_id_}) {
      out_.attribute(id, "ancillary_variables", std::string(status_name) + " " + sigma_name);
    }
    sigma_id_ = define(sigma_name, Type::float64, depth_dims(), "",
                       "standard deviation of each current component", "m s-1", true);
    status_id_ = define(status_name, Type::int8, depth_dims(), "", "why a current is, or is not, there", "", true);
    const std::vector<double> flags{0, 1, 2, 3, 4, 5, 6, 7, 8};
    out_.attribute(status_id_, "flag_values", flags, Type::int8);
    out_.attribute(status_id_, "flag_meanings",
                   "ok missing land below_bed outside_area outside_time above_surface not_checked suspect");
    for (const char* const quantile : {"_p10", "_p50", "_p90"}) {
      const std::string percent = std::string(quantile).substr(2) + " % quantile";
      quantile_ids_.push_back(define(east_name + std::string(quantile), Type::float64, depth_dims(), "",
                                     "eastward current, " + percent, "m s-1", true));
      quantile_ids_.push_back(define(north_name + std::string(quantile), Type::float64, depth_dims(), "",
                                     "northward current, " + percent, "m s-1", true));
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
    wind_ids_ = {define("eastward_wind", Type::float64, surface_dims(), "eastward_wind", "eastward wind at 10 m",
                        "m s-1", false),
                 define("northward_wind", Type::float64, surface_dims(), "northward_wind",
                        "northward wind at 10 m", "m s-1", false),
                 define_source("wind_source", "where the wind comes from")};
  }

  void define_sea() {
    if (!has_sea()) return;
    sea_ids_ = {define(height_name, Type::float64, surface_dims(), height_name, "significant wave height", "m", false),
                define(period_name, Type::float64, surface_dims(), period_name, "peak wave period", "s", false),
                define(direction_name, Type::float64, surface_dims(), direction_name,
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
    put(status_id_, levels,
        [](const ForecastColumn& c, std::size_t o) { return static_cast<double>(c.current_status[o]); });
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
    put(sea_ids_[0], 1, [&](const ForecastColumn& c, std::size_t o) { return at(c, o).significant_height_m; });
    put(sea_ids_[1], 1, [&](const ForecastColumn& c, std::size_t o) { return at(c, o).peak_period_s; });
    put(sea_ids_[2], 1, [&](const ForecastColumn& c, std::size_t o) { return at(c, o).from_direction_deg; });
    put(sea_ids_[3], 1, [](const ForecastColumn& c, std::size_t o) {
      return o < c.sea_source.size() ? static_cast<double>(c.sea_source[o]) : 0.0;
    });
  }

  Writer out_;
  const Snapshot& s_;
  bool many_;
  int time_ = 0, depth_ = 0, column_ = 0;
  int time_id_ = 0, depth_id_ = 0, latitude_id_ = 0, longitude_id_ = 0, station_id_ = 0, reference_id_ = 0,
      period_id_ = 0, bed_id_ = 0, east_id_ = 0, north_id_ = 0, sigma_id_ = 0, status_id_ = 0;
  std::vector<int> quantile_ids_, wind_ids_, sea_ids_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

/// One file being read.
class ForecastReader {
 public:
  explicit ForecastReader(const std::filesystem::path& path) : in_(netcdf::File::open(path)) {}

  Snapshot read() {
    Snapshot s;
    s.site_id = text("slackwater_site_id");
    s.site_name = text("slackwater_site_name");
    s.day = parse_day(text("slackwater_day"));
    s.issued = parse_utc(text("slackwater_issued"));
    s.wind_policy = text("slackwater_wind_policy");
    s.degraded = text("slackwater_degraded") == "true";
    s.contains_stokes = text("slackwater_contains_stokes") == "true";
    s.headline = text("slackwater_headline");
    s.attributions = lines_of(text("slackwater_attributions"));
    s.provenance_json = text("slackwater_provenance");
    for (const double seconds : values("time")) {
      s.time.push_back(UtcTime(Duration(static_cast<Duration::rep>(std::llround(seconds * 1000)))));
    }
    if (in_.find(east_name) != nullptr) s.depth_m = values("depth");
    const std::vector<double> latitude = values("latitude");
    const std::vector<double> longitude = values("longitude");
    const std::vector<double> bed = values("sea_floor_depth");
    const std::vector<std::string> depth_sources = lines_of(text("slackwater_water_depth_sources"));
    columns_ = latitude.size();
    if (longitude.size() != columns_ || bed.size() != columns_ || s.time.empty()) refuse("axes of unequal length");
    s.columns.resize(columns_);
    for (std::size_t c = 0; c < columns_; ++c) {
      s.columns[c].point = GeoPoint::from_degrees(latitude[c], longitude[c]);
      s.columns[c].water_depth_m = bed[c];
      if (c < depth_sources.size()) s.columns[c].water_depth_source = depth_sources[c];
    }
    read_currents(s);
    read_wind(s);
    read_sea(s);
    return s;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(ErrorKind::invalid_input, in_.path().string() + ": " + what +
                                              "; expected a forecast written by Slackwater; run `slackwater store check`");
  }
  std::string text(const char* name) const {
    if (auto found = in_.text(name)) return *found;
    refuse(std::string("found no attribute ") + name);
  }
  std::vector<double> values(const char* name) const {
    const netcdf::Variable* variable = in_.find(name);
    if (variable == nullptr) refuse(std::string("found no variable ") + name);
    return in_.read_all(*variable);
  }
  /// Values of a data variable over (time[, depth], column), missing as NaN; empty where the variable is absent.
  std::vector<double> data(const char* name, std::size_t per_column) const {
    if (in_.find(name) == nullptr) return {};
    std::vector<double> found = values(name);
    if (found.size() != per_column * columns_) refuse(std::string(name) + " has an unexpected size");
    for (double& value : found) {
      if (value == fill) value = nan;
    }
    return found;
  }

  void read_currents(Snapshot& s) const {
    const std::size_t size = s.time.size() * s.depth_m.size();
    const auto east = data(east_name, size);
    const auto north = data(north_name, size);
    const auto sigma = data(sigma_name, size);
    const auto status = data(status_name, size);
    if (east.empty()) return;
    if (north.empty() || sigma.empty() || status.empty()) refuse("the current is not whole");
    for (std::size_t c = 0; c < columns_; ++c) {
      ForecastColumn& column = s.columns[c];
      for (std::size_t o = 0; o < size; ++o) {
        const std::size_t i = o * columns_ + c;
        const bool there = !std::isnan(east[i]) && !std::isnan(north[i]);
        column.current_m_s.push_back(there ? Horizontal(east[i], north[i]) : Horizontal{});
        column.current_sigma_m_s.push_back(there ? sigma[i] : 0.0);
        if (!(status[i] >= 0 && status[i] <= 8)) refuse("found an unknown status");
        column.current_status.push_back(static_cast<SampleStatus>(static_cast<int>(status[i])));
      }
    }
  }

  std::vector<DataStatus> sources(const std::vector<double>& flags, std::size_t c) const {
    std::vector<DataStatus> result;
    for (std::size_t i = c; i < flags.size(); i += columns_) {
      if (!(flags[i] >= 0 && flags[i] <= 4)) refuse("found an unknown source");
      result.push_back(static_cast<DataStatus>(static_cast<int>(flags[i])));
    }
    return result;
  }

  void read_wind(Snapshot& s) const {
    const auto east = data("eastward_wind", s.time.size());
    const auto north = data("northward_wind", s.time.size());
    const auto source = data("wind_source", s.time.size());
    if (east.empty() || north.empty() || source.empty()) return;
    for (std::size_t c = 0; c < columns_; ++c) {
      if (std::isnan(east[c])) continue;
      for (std::size_t i = c; i < east.size(); i += columns_) s.columns[c].wind_m_s.emplace_back(east[i], north[i]);
      s.columns[c].wind_source = sources(source, c);
    }
  }

  void read_sea(Snapshot& s) const {
    const auto height = data(height_name, s.time.size());
    const auto period = data(period_name, s.time.size());
    const auto direction = data(direction_name, s.time.size());
    const auto source = data("wave_source", s.time.size());
    if (height.empty() || period.empty() || direction.empty() || source.empty()) return;
    for (std::size_t c = 0; c < columns_; ++c) {
      for (std::size_t i = c; i < height.size(); i += columns_) {
        s.columns[c].sea.push_back({height[i], period[i], direction[i]});
      }
      s.columns[c].sea_source = sources(source, c);
    }
  }

  netcdf::File in_;
  std::size_t columns_ = 0;
};

}  // namespace

void write_forecast(const std::filesystem::path& file, const Snapshot& snapshot) {
  expects(!snapshot.columns.empty() && !snapshot.time.empty(), "a forecast has columns and times");
  with_context("writing forecast " + file.string(), [&] { ForecastWriter(file, snapshot).write(); });
}

Snapshot read_forecast(const std::filesystem::path& file) {
  return with_context("reading forecast", [&] { return ForecastReader(file).read(); });
}

}  // namespace slackwater::ingest
