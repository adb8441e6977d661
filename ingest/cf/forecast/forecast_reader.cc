#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <system_error>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/numbers/ascends.h"
#include "ingest/cf/forecast/averaged_json.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/cf/forecast/forecast_members.h"
#include "ingest/cf/forecast/forecast_names.h"
#include "ingest/cf/forecast/provenance_json.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {
namespace {

using forecast_names::fill;

using constants::nan;

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

  Snapshot read(Members members) {
    Snapshot s;
    s.site_id = text("slackwater_site_id");
    s.site_name = text("slackwater_site_name");
    s.day = parse_day(text("slackwater_day"));
    s.issued = parse_utc(text("slackwater_issued"));
    s.wind_policy = wind_policy();
    s.seed = seed();
    s.members = count_members(in_);
    s.degraded = text("slackwater_degraded") == "true";
    s.contains_stokes = text("slackwater_contains_stokes") == "true";
    s.hindsight = in_.text("slackwater_hindsight").value_or("false") == "true";
    s.simulated_wind = in_.text("slackwater_simulated_wind").value_or("false") == "true";
    s.wind_ensemble = in_.text(forecast_names::wind_ensemble).value_or("");
    s.averaged = averaged();
    s.headline = text("slackwater_headline");
    s.attributions = lines_of(text("slackwater_attributions"));
    s.provenance = provenance();
    for (const double seconds : values("time")) {
      if (!(std::abs(seconds) < 1e12)) refuse("a time that is none");
      s.time.push_back(UtcTime(Duration(static_cast<Duration::rep>(std::llround(seconds * 1000)))));
    }
    if (in_.find(forecast_names::east) != nullptr) s.depth_m = values("depth");
    if (!ascends(s.time) || !ascends(s.depth_m)) refuse("times or depths that do not ascend");
    const std::vector<double> latitude = values("latitude");
    const std::vector<double> longitude = values("longitude");
    const std::vector<double> bed = values("sea_floor_depth");
    const std::vector<std::string> depth_sources = lines_of(text("slackwater_water_depth_sources"));
    columns_ = latitude.size();
    if (longitude.size() != columns_ || bed.size() != columns_ || s.time.empty() || columns_ == 0)
      refuse("axes of unequal length");
    s.columns.resize(columns_);
    for (std::size_t c = 0; c < columns_; ++c) {
      s.columns[c].point = GeoPoint::from_degrees(latitude[c], longitude[c]);
      s.columns[c].water_depth_m = bed[c];
      if (c < depth_sources.size()) s.columns[c].water_depth_source = depth_sources[c];
    }
    read_currents(s);
    read_wind(s);
    read_sea(s);
    read_sea_level(s);
    if (members == Members::all) read_members(in_, s, 0, columns_);
    return s;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { refuse_forecast(in_, what); }
  /// 0 where the file was written before forecasts had one.
  std::uint64_t seed() const {
    const auto found = in_.text("slackwater_seed");
    if (!found) return 0;
    std::uint64_t value = 0;
    const char* const end = found->data() + found->size();
    const auto [stop, problem] = std::from_chars(found->data(), end, value);
    if (problem != std::errc{} || stop != end) refuse("a seed that is not a number: " + *found);
    return value;
  }
  WindPolicy wind_policy() const {
    const std::string name = text("slackwater_wind_policy");
    return with_context(in_.path().string() + ": slackwater_wind_policy",
                        [&] { return wind_policy_from(name); });
  }
  /// Nothing where the file was written before forecasts said so.
  std::optional<AveragedCurrents> averaged() const {
    return with_context(in_.path().string() + ": slackwater_averaged_currents", [&] {
      return averaged_from(in_.text("slackwater_averaged_currents").value_or("null"));
    });
  }
  Provenance provenance() const {
    const std::string found = text("slackwater_provenance");
    return with_context(in_.path().string() + ": slackwater_provenance",
                        [&] { return provenance_from(found); });
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
  /// Values of a data variable over (time[, depth], column), missing as NaN; empty where the
  /// variable is absent.
  std::vector<double> data(const char* name, std::size_t per_column) const {
    if (in_.find(name) == nullptr) return {};
    std::vector<double> found = values(name);
    if (found.size() != per_column * columns_)
      refuse(std::string(name) + " has an unexpected size");
    for (double& value : found) {
      if (value == fill) value = nan;
    }
    return found;
  }

  void read_currents(Snapshot& s) const {
    const std::size_t size = s.time.size() * s.depth_m.size();
    const auto east = data(forecast_names::east, size);
    const auto north = data(forecast_names::north, size);
    const auto sigma = data(forecast_names::sigma, size);
    const auto status = data(forecast_names::status, size);
    if (east.empty()) return;
    if (north.empty() || sigma.empty() || status.empty()) refuse("the current is not whole");
    for (ForecastColumn& column : s.columns) {
      column.current_m_s.resize(size);
      column.current_sigma_m_s.resize(size);
      column.current_status.resize(size);
    }
    // In the order of the file.
    for (std::size_t o = 0, i = 0; o < size; ++o) {
      for (std::size_t c = 0; c < columns_; ++c, ++i) {
        if (!(status[i] >= 0 && status[i] < sample_status_count)) refuse("found an unknown status");
        const auto found = static_cast<SampleStatus>(static_cast<int>(status[i]));
        s.columns[c].current_status[o] = found;
        if (std::isfinite(east[i]) && std::isfinite(north[i])) {
          s.columns[c].current_m_s[o] = Horizontal(east[i], north[i]);
          s.columns[c].current_sigma_m_s[o] = sigma[i];
        } else if (has_value(found)) {
          refuse("a current without its value");
        }
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
      for (std::size_t i = c; i < east.size(); i += columns_)
        s.columns[c].wind_m_s.emplace_back(east[i], north[i]);
      s.columns[c].wind_source = sources(source, c);
    }
  }

  /// Of one column; empty where the file was written before forecasts said so.
  std::vector<double> spread_of(const std::vector<double>& height,
                                const std::vector<double>& spread, std::size_t c) const {
    std::vector<double> found;
    std::size_t missing = 0;
    for (std::size_t i = c; i < spread.size(); i += columns_) {
      if (spread[i] < 0) refuse("a wave height whose spread is negative");
      missing += std::isnan(spread[i]) && !std::isnan(height[i]) ? 1U : 0U;
      found.push_back(spread[i]);
    }
    const bool has_any = std::any_of(found.begin(), found.end(), [](double s) { return s >= 0; });
    if (!has_any) return {};
    if (missing > 0) refuse("a wave height without its spread");
    return found;
  }

  void read_sea(Snapshot& s) const {
    const auto height = data(forecast_names::wave_height, s.time.size());
    const auto period = data(forecast_names::wave_period, s.time.size());
    const auto direction = data(forecast_names::wave_direction, s.time.size());
    const auto source = data("wave_source", s.time.size());
    const auto spread = data(forecast_names::wave_height_spread, s.time.size());
    if (height.empty() || period.empty() || direction.empty() || source.empty()) return;
    for (std::size_t c = 0; c < columns_; ++c) {
      bool any = false;
      for (std::size_t i = c; i < height.size(); i += columns_) any = any || !std::isnan(height[i]);
      if (!any) continue;  // this column has none, others have
      for (std::size_t i = c; i < height.size(); i += columns_) {
        s.columns[c].sea.push_back({height[i], period[i], direction[i]});
      }
      s.columns[c].sea_source = sources(source, c);
      s.columns[c].height_spread = spread_of(height, spread, c);
    }
  }

  /// None where the file was written before forecasts had one.
  void read_sea_level(Snapshot& s) const {
    const auto level = data(forecast_names::sea_level, s.time.size());
    const auto sigma = data(forecast_names::sea_level_sigma, s.time.size());
    const auto source = data(forecast_names::sea_level_source, s.time.size());
    if (level.empty() && sigma.empty() && source.empty()) return;
    if (level.empty() || sigma.empty() || source.empty())
      refuse("the level of the sea is not whole");
    for (std::size_t c = 0; c < columns_; ++c) {
      SeaLevel found;
      bool any = false;
      for (std::size_t i = c; i < level.size(); i += columns_) {
        any = any || !std::isnan(level[i]);
        found.level_m.push_back(level[i]);
        found.sigma_m.push_back(sigma[i]);
      }
      if (!any) continue;  // this column has none, others have
      found.source = sources(source, c);
      s.columns[c].sea_level = std::move(found);
    }
  }

  netcdf::File in_;
  std::size_t columns_ = 0;
};

}  // namespace

Snapshot read_forecast(const std::filesystem::path& file, Members members) {
  return with_context("reading forecast", [&] { return ForecastReader(file).read(members); });
}

void read_members(const std::filesystem::path& file, Snapshot& snapshot, std::size_t column) {
  expects(column < snapshot.columns.size(), "read_members: a column of the snapshot");
  with_context("reading members of a forecast", [&] {
    const netcdf::File in = netcdf::File::open(file);
    if (count_members(in) != snapshot.members) {
      refuse_forecast(in, "found other members than when the forecast was read");
    }
    read_members(in, snapshot, column, 1);
  });
}

}  // namespace slackwater::ingest
