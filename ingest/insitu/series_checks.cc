#include "ingest/insitu/series_checks.h"

#include <algorithm>
#include <cmath>

#include "ingest/quality/gross_range.h"
#include "ingest/quality/profile_consistency.h"
#include "ingest/quality/spike.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t fewest_bins_of_a_profile = 4;

/// One level of a series, taken out and put back: the tests want contiguous samples.
struct LevelView {
  SeriesValues& series;
  std::size_t level;
  std::vector<float> values;
  std::vector<SampleStatus> status;

  LevelView(SeriesValues& of, std::size_t k) : series(of), level(k) {
    for (std::size_t t = 0; t < series.times; ++t) {
      values.push_back(series.values[series.at(t, k)]);
      status.push_back(series.status[series.at(t, k)]);
    }
  }
  void put_back() const {
    for (std::size_t t = 0; t < series.times; ++t) series.status[series.at(t, level)] = status[t];
  }
};

void tell(std::vector<std::string>& warnings, const std::string& what, std::size_t count,
          const std::string& why) {
  if (count > 0)
    warnings.push_back("rejected " + std::to_string(count) + " of '" + what + "': " + why);
}

std::string range_words(double low, double high, const std::string& unit) {
  const auto number = [](double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  };
  return "outside " + number(low) + " to " + number(high) + " " + unit;
}

void check_scalar(const std::vector<UtcTime>& times, SeriesValues& series,
                  std::vector<std::string>& warnings) {
  const std::size_t outside = test_gross_range(series.gross, series.values, series.status);
  tell(warnings, series.source_name, outside,
       range_words(series.gross.low, series.gross.high, series.unit));
  if (!series.spike) return;
  std::size_t spikes = 0;
  for (std::size_t k = 0; k < series.levels; ++k) {
    LevelView view(series, k);
    spikes += test_spikes(*series.spike, times, view.values, view.status);
    view.put_back();
  }
  tell(warnings, series.source_name, spikes, "spikes");
}

void check_vector(const std::vector<UtcTime>& times, SeriesValues& east, SeriesValues& north,
                  std::vector<std::string>& warnings) {
  const std::string names = east.source_name == north.source_name
                                ? east.source_name
                                : east.source_name + ", " + north.source_name;
  const std::vector<SampleStatus> before = east.status;
  const double greatest = std::min(std::abs(east.gross.low), std::abs(east.gross.high));
  const std::size_t outside =
      test_speed_range(greatest, east.values, north.values, east.status, north.status);

  std::size_t spikes = 0;
  if (east.spike) {
    for (std::size_t k = 0; k < east.levels; ++k) {
      LevelView east_view(east, k);
      LevelView north_view(north, k);
      spikes += test_vector_spikes(*east.spike, times, east_view.values, north_view.values,
                                   east_view.status, north_view.status);
      east_view.put_back();
      north_view.put_back();
    }
  }
  if (east.levels >= fewest_bins_of_a_profile) {
    const EnsembleReport report =
        test_ensembles(east.levels, east.values, north.values, before, east.status, north.status);
    if (report.broken > 0) {
      warnings.push_back(
          "rejected " + std::to_string(report.broken) + " ensembles of '" + names +
          "' whole: a quarter or more of their bins failed the range and spike tests");
    }
    if (report.zeros > 0) {
      warnings.push_back("rejected " + std::to_string(report.zeros) + " ensembles of '" + names +
                         "' whole: every bin is exactly zero, a record that was not written");
    }
    tell(warnings, names, report.zero_bins, "exact zeros in three or more adjacent bins");
  }
  tell(warnings, names, outside,
       "vectors faster than " + std::to_string(std::lround(greatest)) + " " + east.unit);
  tell(warnings, names, spikes, "vectors that are spikes");
}

}  // namespace

void check_series(const std::vector<UtcTime>& times, std::vector<SeriesValues*>& all,
                  std::vector<std::string>& warnings) {
  for (SeriesValues* series : all) {
    const std::string& name = series->standard_name;
    if (name.starts_with("northward_")) {
      const auto partner = std::find_if(all.begin(), all.end(), [&](const SeriesValues* other) {
        return other->standard_name == "eastward_" + name.substr(10) &&
               other->values.size() == series->values.size();
      });
      if (partner != all.end()) continue;
    }
    if (name.starts_with("eastward_")) {
      const auto partner = std::find_if(all.begin(), all.end(), [&](const SeriesValues* other) {
        return other->standard_name == "northward_" + name.substr(9) &&
               other->values.size() == series->values.size();
      });
      if (partner != all.end()) {
        check_vector(times, *series, **partner, warnings);
        continue;
      }
    }
    check_scalar(times, *series, warnings);
  }
}

}  // namespace slackwater::ingest
