#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/service/wave_source.h"
#include "fields/wave/height_error.h"
#include "ingest/cf/forecast/averaged_json.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/cf/forecast/forecast_members.h"
#include "ingest/cf/forecast/forecast_names.h"
#include "ingest/cf/forecast/provenance_json.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {
namespace {

using forecast_names::fill;
using netcdf::Type;
using netcdf::Writer;

using constants::nan;
/// Values of a chunk, 8 MiB of doubles.
constexpr std::size_t chunk_values = std::size_t{1} << 20;

/// What a snapshot promises of its sizes.
void expect_whole(const Snapshot& s) {
  expects(!s.columns.empty() && !s.time.empty(), "a forecast has columns and times");
  expects(s.members >= 1, "a forecast has a central member");
  expects(s.wind_policy.has_value(), "a forecast says where its wind beyond D comes from");
  for (const ForecastColumn& c : s.columns) {
    const std::size_t more = s.members - 1;
    expects(c.member_m_s.empty() || (c.current_m_s.size() == s.time.size() * s.depth_m.size() &&
                                     c.member_m_s.size() == more * c.current_m_s.size()),
            "a column holds members - 1 blocks of currents, or none");
    expects(c.wind_member_m_s.empty() || (c.wind_m_s.size() == s.time.size() &&
                                          c.wind_member_m_s.size() == more * c.wind_m_s.size()),
            "a column holds members - 1 blocks of wind, or none");
    expects(c.sea_level.empty() || (c.sea_level.level_m.size() == s.time.size() &&
                                    c.sea_level.sigma_m.size() == s.time.size()),
            "a column holds a level of the sea and its sigma for each time, or none");
    expects(c.wind_member_number.empty() ||
                (!c.wind_member_m_s.empty() && c.wind_member_number.size() == more),
            "every member with a wind has the number of its driver, or none has");
  }
}

/// One file being written: the snapshot with the ids of what was defined.
class ForecastWriter {
 public:
  ForecastWriter(const std::filesystem::path& file, const Snapshot& snapshot)
      : out_(Writer::create(file)),
        s_(snapshot),
        members_(out_, snapshot),
        many_(snapshot.columns.size() > 1) {}

  void write() {
    define_axes();
    define_currents();
    define_wind();
    define_sea();
    define_sea_level();
    members_.define(time_, depth_, many_ ? std::optional(column_) : std::nullopt);
    describe();
    out_.end_definitions();
    write_axes();
    write_currents();
    write_wind();
    write_sea();
    write_sea_level();
    members_.write();
    out_.close();
  }

 private:
  std::vector<int> surface_dims() const {
    return many_ ? std::vector{time_, column_} : std::vector{time_};
  }
  std::vector<int> depth_dims() const {
    return many_ ? std::vector{time_, depth_, column_} : std::vector{time_, depth_};
  }
  /// Whole arrays, cut in time where they grow large. Unlimited dimensions want chunks, and the
  /// library's own are single values.
  std::vector<std::size_t> chunks_of(const std::vector<int>& dims) const {
    std::vector<std::size_t> lengths;
    std::size_t values = 1;
    for (const int dimension : dims) {
      lengths.push_back(length_of(dimension));
      values *= lengths.back();
    }
    if (values > chunk_values) {
      const std::size_t pieces = (values + chunk_values - 1) / chunk_values;
      lengths.front() = (lengths.front() + pieces - 1) / pieces;
    }
    return lengths;
  }
  std::size_t length_of(int dimension) const {
    if (dimension == time_) return s_.time.size();
    if (dimension == depth_) return std::max<std::size_t>(1, s_.depth_m.size());
    return s_.columns.size();
  }
  std::string coordinates(bool with_depth) const {
    return std::string("time ") + (with_depth ? "depth " : "") + "latitude longitude station_name";
  }

  int define(const std::string& name, Type type, const std::vector<int>& dims,
             const std::string& standard_name, const std::string& long_name,
             const std::string& units, bool on_depth) {
    Writer::Layout layout;
    layout.chunks = chunks_of(dims);
    if (type == Type::float64) layout.fill_value = fill;
    const int id = out_.variable(name, type, dims, layout);
    if (!standard_name.empty()) out_.attribute(id, "standard_name", standard_name);
    out_.attribute(id, "long_name", long_name);
    if (!units.empty()) out_.attribute(id, "units", units);
    out_.attribute(id, "coordinates", coordinates(on_depth));
    return id;
  }

  int define_axis(const std::string& name, int dimension) {
    Writer::Layout layout;
    layout.chunks = chunks_of({dimension});
    return out_.variable(name, Type::float64, {dimension}, layout);
  }

  void define_axes() {
    // Unlimited, since CF would have `realization` and `column` stand before time and depth, where
    // tools that read profiles do not look for them. CF's rule of the order (§2.4) is checked for
    // axes of fixed length only.
    time_ = out_.unlimited_dimension("time");
    depth_ = out_.unlimited_dimension("depth");
    if (many_) column_ = out_.dimension("column", s_.columns.size());
    const int text = out_.dimension("name_length", std::max<std::size_t>(1, s_.site_name.size()));
    time_id_ = define_axis("time", time_);
    out_.attribute(time_id_, "standard_name", "time");
    out_.attribute(time_id_, "long_name", "valid time");
    out_.attribute(time_id_, "units", "seconds since 1970-01-01 00:00:00");
    out_.attribute(time_id_, "calendar", "standard");
    out_.attribute(time_id_, "axis", "T");
    depth_id_ = define_axis("depth", depth_);
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
    period_id_ = define_axis("forecast_period", time_);
    out_.attribute(period_id_, "standard_name", "forecast_period");
    out_.attribute(period_id_, "long_name", "lead since the end of the last calibrated day");
    out_.attribute(period_id_, "units", "hours");  // cdo does not know "h"
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
    const std::vector<double> flags{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    out_.attribute(status_id_, "flag_values", flags, Type::int8);
    out_.attribute(
        status_id_, "flag_meanings",
        "ok missing land below_bed outside_area outside_time above_surface not_checked suspect "
        "carried");
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

  /// At any column: one may lack what the others have.
  bool has_wind() const {
    return std::any_of(s_.columns.begin(), s_.columns.end(),
                       [](const ForecastColumn& c) { return !c.wind_m_s.empty(); });
  }
  bool has_sea() const {
    return std::any_of(s_.columns.begin(), s_.columns.end(),
                       [](const ForecastColumn& c) { return !c.sea.empty(); });
  }

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
    if (const std::string sources = wave_sources_text(s_); !sources.empty())
      for (const int id : sea_ids_) out_.attribute(id, "comment", sources);
    define_height_spread();
  }

  void define_height_spread() {
    if (std::all_of(s_.columns.begin(), s_.columns.end(),
                    [](const ForecastColumn& c) { return c.height_spread.empty(); }))
      return;
    const std::string name = forecast_names::wave_height;
    spread_ids_ = {define(forecast_names::wave_height_spread, Type::float64, surface_dims(), "",
                          "standard deviation of the error of ln(significant wave height + 0.3 m)",
                          "1", false)};
    for (const char* const quantile : {"_p10", "_p90"})
      spread_ids_.push_back(
          define(name + quantile, Type::float64, surface_dims(), "",
                 "significant wave height, " + std::string(quantile).substr(2) + " % quantile", "m",
                 false));
    out_.attribute(sea_ids_.front(), "ancillary_variables", forecast_names::wave_height_spread);
  }

  void define_sea_level() {
    const bool has_level =
        std::any_of(s_.columns.begin(), s_.columns.end(),
                    [](const ForecastColumn& c) { return !c.sea_level.empty(); });
    if (!has_level) return;
    const std::string name = forecast_names::sea_level;
    level_ids_ = {define(name, Type::float64, surface_dims(), name,
                         "level of the sea above mean sea level, member 0", "m", false),
                  define(forecast_names::sea_level_sigma, Type::float64, surface_dims(), "",
                         "standard deviation of the level of the sea", "m", false),
                  define_source(forecast_names::sea_level_source,
                                "where the level of the sea comes from: forecast, of its product; "
                                "modelled, by harmonic tide")};
    for (const char* const quantile : {"_p10", "_p50", "_p90"}) {
      const std::string percent = std::string(quantile).substr(2) + " % quantile";
      level_ids_.push_back(define(name + quantile, Type::float64, surface_dims(), "",
                                  "level of the sea, " + percent, "m", false));
    }
    out_.attribute(
        level_ids_.front(), "ancillary_variables",
        std::string(forecast_names::sea_level_sigma) + " " + forecast_names::sea_level_source);
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
    const std::string credit = joined(s_.attributions, "\n");
    global("references", credit.empty() ? "none" : credit);
    global("comment", s_.headline.empty() ? "none" : s_.headline);
    global("slackwater_site_id", s_.site_id);
    global("slackwater_site_name", s_.site_name);
    global("slackwater_day", format_day(s_.day));
    global("slackwater_issued", format_utc(s_.issued));
    global("slackwater_wind_policy", std::string(name_of(*s_.wind_policy)));
    global("slackwater_seed", std::to_string(s_.seed));
    global("slackwater_degraded", s_.degraded ? "true" : "false");
    global("slackwater_contains_stokes", s_.contains_stokes ? "true" : "false");
    global("slackwater_hindsight", s_.hindsight ? "true" : "false");
    global("slackwater_simulated_wind", s_.simulated_wind ? "true" : "false");
    if (!s_.wind_ensemble.empty()) global(forecast_names::wind_ensemble, s_.wind_ensemble);
    global("slackwater_averaged_currents", averaged_json(s_.averaged));
    global("slackwater_headline", s_.headline);
    global("slackwater_attributions", credit);
    global("slackwater_provenance", provenance_json(s_.provenance));
    std::string depth_sources;
    for (const ForecastColumn& column : s_.columns) {
      depth_sources += (depth_sources.empty() ? "" : "\n") + column.water_depth_source;
    }
    global("slackwater_water_depth_sources", depth_sources);
  }

  void write_axis(int id, const std::vector<double>& values) {
    out_.write(id, std::vector<std::size_t>{0}, std::vector{values.size()}, values);
  }

  void write_axes() {
    std::vector<double> time;
    std::vector<double> lead;
    const UtcTime reference = UtcTime(s_.day) + std::chrono::days(1);
    for (const UtcTime stamp : s_.time) {
      time.push_back(seconds_between(UtcTime{}, stamp));
      lead.push_back(hours_between(reference, stamp));
    }
    // These give the unlimited dimensions their length, which all later writes go by.
    write_axis(time_id_, time);
    write_axis(depth_id_, s_.depth_m.empty() ? std::vector<double>{0.0} : s_.depth_m);
    out_.write_all(period_id_, lead);
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
    const auto current = [](bool north, auto pick) {
      return [north, pick](const ForecastColumn& c, std::size_t o) {
        if (!has_value(c.current_status[o])) return nan;
        const Horizontal w =
            pick(CurrentSample{c.current_m_s[o], c.current_sigma_m_s[o], c.current_status[o]});
        return north ? w.imag() : w.real();
      };
    };
    const auto central = [](const CurrentSample& sample) { return sample.velocity_m_s; };
    put(east_id_, levels, current(false, central));
    put(north_id_, levels, current(true, central));
    put(sigma_id_, levels, [](const ForecastColumn& c, std::size_t o) {
      return has_value(c.current_status[o]) ? c.current_sigma_m_s[o] : nan;
    });
    put(status_id_, levels, [](const ForecastColumn& c, std::size_t o) {
      return static_cast<double>(c.current_status[o]);
    });
    std::size_t next = 0;
    for (const auto quantile :
         {&CurrentQuantiles::p10_m_s, &CurrentQuantiles::p50_m_s, &CurrentQuantiles::p90_m_s}) {
      const auto pick = [quantile](const CurrentSample& sample) {
        return quantiles_of(sample).*quantile;
      };
      put(quantile_ids_[next++], levels, current(false, pick));
      put(quantile_ids_[next++], levels, current(true, pick));
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
    if (spread_ids_.empty()) return;
    const auto spread = [](const ForecastColumn& c, std::size_t o) {
      return o < c.height_spread.size() ? c.height_spread[o] : nan;
    };
    const auto height = [&](double z) {
      return [&at, &spread, z](const ForecastColumn& c, std::size_t o) {
        return height_error::height_at(at(c, o).significant_height_m, spread(c, o), z);
      };
    };
    put(spread_ids_[0], 1, spread);
    put(spread_ids_[1], 1, height(-constants::normal_p90));
    put(spread_ids_[2], 1, height(constants::normal_p90));
  }

  void write_sea_level() {
    if (level_ids_.empty()) return;
    const auto at = [](const ForecastColumn& c, std::size_t o) {
      if (c.sea_level.empty())
        return SeaLevelSample{nan, nan, SampleStatus::ok};  // written as fill
      return SeaLevelSample{c.sea_level.level_m[o], c.sea_level.sigma_m[o], SampleStatus::ok};
    };
    put(level_ids_[0], 1, [&](const auto& c, std::size_t o) { return at(c, o).level_m; });
    put(level_ids_[1], 1, [&](const auto& c, std::size_t o) { return at(c, o).sigma_m; });
    put(level_ids_[2], 1, [](const ForecastColumn& c, std::size_t o) {
      return o < c.sea_level.source.size() ? static_cast<double>(c.sea_level.source[o]) : 0.0;
    });
    put(level_ids_[3], 1,
        [&](const auto& c, std::size_t o) { return quantiles_of(at(c, o)).p10_m; });
    put(level_ids_[4], 1,
        [&](const auto& c, std::size_t o) { return quantiles_of(at(c, o)).p50_m; });
    put(level_ids_[5], 1,
        [&](const auto& c, std::size_t o) { return quantiles_of(at(c, o)).p90_m; });
  }

  Writer out_;
  const Snapshot& s_;
  MemberWriter members_;
  bool many_;
  int time_ = 0, depth_ = 0, column_ = 0;
  int time_id_ = 0, depth_id_ = 0, latitude_id_ = 0, longitude_id_ = 0, station_id_ = 0,
      reference_id_ = 0, period_id_ = 0, bed_id_ = 0, east_id_ = 0, north_id_ = 0, sigma_id_ = 0,
      status_id_ = 0;
  std::vector<int> quantile_ids_, wind_ids_, sea_ids_, spread_ids_, level_ids_;
};

}  // namespace

void write_forecast(const std::filesystem::path& file, const Snapshot& snapshot) {
  expect_whole(snapshot);
  with_context("writing forecast " + file.string(),
               [&] { ForecastWriter(file, snapshot).write(); });
}

}  // namespace slackwater::ingest
