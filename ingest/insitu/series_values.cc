#include "ingest/insitu/series_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/packing.h"
#include "ingest/cf/units.h"
#include "ingest/quality/flags.h"
#include "ingest/quality/sentinel.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t most_values = std::size_t{8} << 20U;

bool is_flag_variable(const netcdf::Variable& variable) {
  const bool has_words =
      variable.find("flag_meanings") != nullptr || variable.find("flags_meanings") != nullptr;
  const bool has_values =
      variable.find("flag_values") != nullptr || variable.find("flags_values") != nullptr;
  if (has_values && has_words && !variable.find("scale_factor")) {
    const std::string name = lower_case(variable.name);
    return name.ends_with("_qc") || name.ends_with("quality_control") || name.ends_with("flag") ||
           contains_ignoring_case(variable.text("standard_name").value_or(""), "flag") ||
           contains_ignoring_case(variable.text("long_name").value_or(""), "quality");
  }
  return false;
}

std::vector<double> numbers_of(const netcdf::Variable& variable, std::string_view attribute) {
  const netcdf::Attribute* found = variable.find(attribute);
  if (found == nullptr) return {};
  if (const auto* values = std::get_if<std::vector<double>>(&found->value)) return *values;
  return {};
}

std::optional<FlagScheme> scheme_of(const netcdf::Variable& flags) {
  std::string conventions;
  for (const char* attribute : {"conventions", "quality_control_conventions", "References"}) {
    conventions += flags.text(attribute).value_or("") + " ";
  }
  // The Copernicus Marine toolbox (2.5) writes `flags_values` and `flags_meanings`.
  std::vector<double> values = numbers_of(flags, "flag_values");
  if (values.empty()) values = numbers_of(flags, "flags_values");
  const std::string meanings =
      flags.text("flag_meanings").value_or(flags.text("flags_meanings").value_or(""));
  return FlagScheme::from_attributes(values, meanings, conventions);
}

/// Values of a variable in (time, level) order at one station, raw.
std::vector<double> read_time_by_level(const netcdf::File& file, const netcdf::Variable& variable,
                                       const SeriesDimensions& dimensions, std::size_t station,
                                       std::size_t times, std::size_t levels) {
  std::vector<std::size_t> start(variable.shape.size(), 0);
  std::vector<std::size_t> count(variable.shape.size(), 1);
  if (dimensions.time) count[*dimensions.time] = times;
  if (dimensions.level) count[*dimensions.level] = levels;
  if (dimensions.station) start[*dimensions.station] = station;
  std::vector<double> values(times * levels);
  file.read(variable, start, count, std::span<double>(values));
  if (dimensions.time && dimensions.level && *dimensions.level < *dimensions.time) {
    std::vector<double> turned(values.size());
    for (std::size_t k = 0; k < levels; ++k) {
      for (std::size_t t = 0; t < times; ++t) turned[t * levels + k] = values[k * times + t];
    }
    return turned;
  }
  return values;
}

/// Gives each value of a series the status that its quality flag states.
void apply_flags(const netcdf::File& file, const SeriesDimensions& dimensions, std::size_t station,
                 SeriesValues& series, std::vector<std::string>& warnings) {
  const netcdf::Variable* flags = flag_variable_of(file, *series.variable);
  if (flags == nullptr) return;
  const auto unused = [&](const std::string& why) {
    warnings.push_back("quality flags '" + flags->name + "' " + why + "; '" +
                       series.variable->name + "' counts as not checked");
  };
  if (flags->dimensions != series.variable->dimensions) return unused("have other dimensions");
  const auto scheme = scheme_of(*flags);
  if (!scheme) return unused("do not say what their numbers mean");
  const std::vector<double> raw =
      read_time_by_level(file, *flags, dimensions, station, series.times, series.levels);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (std::abs(raw[i]) < 1e9) series.status[i] = scheme->status_of(std::lround(raw[i]));
  }
}

/// Numbers of the file's own that stand for nothing, though no attribute says so.
void leave_out_sentinels(std::vector<double> raw, const std::string& unit, SeriesValues& series,
                         std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (std::isnan(series.values[i])) raw[i] = constants::nan;
  }
  for (const FoundSentinel& found : take_sentinels(raw))
    warnings.push_back(found.words(series.source_name, unit));
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (std::isnan(raw[i])) series.values[i] = std::numeric_limits<float>::quiet_NaN();
  }
}

}  // namespace

SeriesDimensions dimensions_of(const netcdf::Variable& variable, std::string_view time_dimension,
                               std::string_view station_dimension) {
  SeriesDimensions found;
  for (std::size_t i = 0; i < variable.dimensions.size(); ++i) {
    const std::string& name = variable.dimensions[i];
    if (name == time_dimension) {
      found.time = i;
    } else if (!station_dimension.empty() && name == station_dimension) {
      found.station = i;
    } else if (!found.level || variable.shape[*found.level] == 1) {
      found.level = i;
    } else if (variable.shape[i] != 1) {
      throw Error(ErrorKind::invalid_input,
                  "variable '" + variable.name + "': dimensions '" +
                      variable.dimensions[*found.level] + "' and '" + name +
                      "' beside time; expected one of levels: this is no point series");
    }
  }
  return found;
}

const netcdf::Variable* flag_variable_of(const netcdf::File& file,
                                         const netcdf::Variable& variable) {
  std::istringstream names(variable.text("ancillary_variables").value_or(""));
  for (std::string name; names >> name;) {
    const netcdf::Variable* found = file.find(name);
    if (found != nullptr && is_flag_variable(*found)) return found;
  }
  for (const char* ending : {"_QC", "_quality_control", "_qc", "_status"}) {
    const netcdf::Variable* found = file.find(variable.name + ending);
    if (found != nullptr && found->type != netcdf::Type::character) return found;
  }
  return nullptr;
}

std::vector<SampleStatus> flags_of(const netcdf::File& file, const netcdf::Variable& flags) {
  const auto scheme = scheme_of(flags);
  std::vector<SampleStatus> status(flags.size(), SampleStatus::not_checked);
  if (!scheme) return status;
  const std::vector<double> raw = file.read_all(flags);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (std::abs(raw[i]) < 1e9) status[i] = scheme->status_of(std::lround(raw[i]));
  }
  return status;
}

SeriesValues read_series(const netcdf::File& file, const netcdf::Variable& variable,
                         const SeriesDimensions& dimensions, std::size_t station,
                         const std::string& unit, std::vector<std::string>& warnings) {
  return with_context("variable '" + variable.name + "'", [&] {
    SeriesValues series;
    series.variable = &variable;
    series.unit = unit;
    series.source_name = variable.name;
    series.times = dimensions.time ? variable.shape[*dimensions.time] : 1;
    series.levels = dimensions.level ? variable.shape[*dimensions.level] : 1;
    if (series.levels > most_values / std::max<std::size_t>(series.times, 1)) {
      throw Error(ErrorKind::invalid_input,
                  std::to_string(series.times) + " times x " + std::to_string(series.levels) +
                      " levels; expected at most " + std::to_string(most_values) +
                      " values: split the file in time");
    }
    const auto found_unit = variable.text("units");
    if (!found_unit) {
      throw Error(ErrorKind::invalid_input, "has no units; expected something like '" + unit + "'");
    }
    Packing packing = Packing::of(variable, warnings);
    packing.convert(unit_conversion(*found_unit, unit, "variable '" + variable.name + "'"));
    const std::vector<double> raw =
        read_time_by_level(file, variable, dimensions, station, series.times, series.levels);
    packing.settle_limits(raw, variable.name, warnings);
    series.values.resize(raw.size());
    DecodeCounts counts;
    packing.decode(std::span<const double>(raw), series.values, counts);
    if (counts.outside > 0) warnings.push_back(lost_by_limits(variable.name, counts));
    if (!variable.find("scale_factor") && !variable.find("add_offset"))
      leave_out_sentinels(raw, *found_unit, series, warnings);

    series.status.assign(raw.size(), SampleStatus::not_checked);
    apply_flags(file, dimensions, station, series, warnings);
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (std::isnan(series.values[i])) series.status[i] = SampleStatus::missing;
    }
    return series;
  });
}

}  // namespace slackwater::ingest
