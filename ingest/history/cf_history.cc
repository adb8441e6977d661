#include "ingest/history/cf_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/advice.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/numbers/statistics.h"
#include "fields/base/text.h"
#include "ingest/cf/units.h"
#include "ingest/history/read_wanted.h"
#include "ingest/history/sentinels.h"
#include "ingest/insitu/series_times.h"
#include "ingest/insitu/series_values.h"
#include "ingest/insitu/vertical_coordinate.h"

namespace slackwater::ingest {
namespace {

using constants::nan;

bool is_number(const netcdf::Variable& variable) {
  return variable.type != netcdf::Type::character && variable.type != netcdf::Type::string;
}

bool is_time(const netcdf::Variable& variable) {
  return is_number(variable) && variable.dimensions.size() == 1 &&
         contains_ignoring_case(variable.text("units").value_or(""), " since ");
}

class CfHistory {
 public:
  CfHistory(const std::filesystem::path& path, const HistoryOptions& options,
            const Vocabulary& vocabulary)
      : file_(netcdf::File::open(path)), options_(options), vocabulary_(vocabulary) {
    for (const NamedColumn& named : options.columns) {
      const netcdf::Variable* variable = file_.find(named.column);
      if (variable != nullptr && !named.unit.empty()) file_.settle(*variable, "units", named.unit);
    }
    find_offers();
  }

  HistoryOfFile read(const std::vector<std::string>& wanted) {
    HistoryOfFile answer;
    for (const netcdf::Variable& variable : file_.variables())
      answer.columns.push_back(variable.name);
    answer.offered = names_offered(offers_, options_);
    const auto read_making = [&](const Making& making, std::vector<std::string>& warnings) {
      HistorySeries series = read_one(making.first, warnings);
      if (making.second) make_of_components(series, read_one(*making.second, warnings), making);
      return series;
    };
    read_wanted(wanted, offers_, vocabulary_, read_making, answer);
    return answer;
  }

 private:
  /// The axis that a variable runs along; null where it has none.
  [[nodiscard]] const netcdf::Variable* time_of(const netcdf::Variable& variable) const {
    const netcdf::Variable* found = nullptr;
    for (const netcdf::Variable& time : file_.variables()) {
      if (!is_time(time) || &time == &variable) continue;
      if (!options_.time_column.empty() && time.name != options_.time_column) continue;
      if (std::find(variable.dimensions.begin(), variable.dimensions.end(), time.dimensions[0]) ==
          variable.dimensions.end())
        continue;
      const bool is_coordinate = time.name == time.dimensions[0];
      if (found == nullptr || is_coordinate) found = &time;
    }
    return found;
  }

  void find_offers() {
    bool has_times = false;
    for (const netcdf::Variable& variable : file_.variables()) {
      has_times |= is_time(variable);
      if (!is_number(variable) || is_time(variable) || time_of(variable) == nullptr) continue;
      const auto named =
          std::find_if(options_.columns.begin(), options_.columns.end(),
                       [&](const NamedColumn& column) { return column.column == variable.name; });
      std::string name = variable.text("standard_name").value_or("");
      if (const auto blank = name.find(' '); blank != std::string::npos) {
        continue;  // "… status_flag": what is said about values, not values
      }
      if (named != options_.columns.end())
        name = named->standard_name;
      else if (const Quantity* known = vocabulary_.by_alias(variable.name);
               name.empty() && known != nullptr)
        name = known->standard_name;
      if (name.empty()) continue;
      offers_.push_back({variable.name, current_name(name, vocabulary_),
                         variable.text("units").value_or(""), named != options_.columns.end()});
    }
    if (!has_times) refuse("found no time axis, a variable over one dimension in 'days since …'");
    if (!options_.time_column.empty() && file_.find(options_.time_column) == nullptr) {
      std::vector<std::string> names;
      for (const netcdf::Variable& variable : file_.variables()) names.push_back(variable.name);
      refuse("found no time axis '" + options_.time_column + "'" +
             did_you_mean(options_.time_column, names) + "; leave --time-column away");
    }
  }

  HistorySeries read_one(std::size_t index, std::vector<std::string>& warnings) {
    const Offer& offer = offers_[index];
    const netcdf::Variable& variable = *file_.find(offer.name);
    StationAxes axes;
    axes.time = time_of(variable);
    axes.time_dimension = axes.time->dimensions[0];
    expect_one_place(variable, axes.time_dimension);
    const SeriesDimensions dimensions = dimensions_of(variable, axes.time_dimension, "");
    const SeriesValues read =
        read_series(file_, variable, dimensions, 0, unit_of(offer, variable), warnings);
    std::vector<double> weight =
        level_weights(variable, dimensions, read.levels, axes.time_dimension);
    if (is_direction(offer.standard_name)) keep_nearest(weight);
    const SeriesTimes times = series_times_of(file_, axes, warnings);
    HistorySeries series;
    series.name = offer.name;
    series.standard_name = offer.standard_name;
    series.unit = read.unit;
    series.source = file_.path().string();
    series.is_single_precision = true;
    std::size_t flagged = 0;
    for (std::size_t t = 0; t < read.times; ++t) {
      if (!times.usable[t]) continue;
      double value = 0;
      for (std::size_t k = 0; k < read.levels; ++k) {
        if (weight[k] == 0) continue;
        const SampleStatus status = read.status[read.at(t, k)];
        if (status != SampleStatus::missing && !has_value(status)) ++flagged;
        value += has_value(status) ? weight[k] * read.values[read.at(t, k)] : nan;
      }
      series.time.push_back(times.cells[t].start);
      series.value.push_back(value);
    }
    const auto tell = [&](const std::vector<std::string>& all) {
      warnings.insert(warnings.end(), all.begin(), all.end());
    };
    tell(take_as_missing(series, options_.missing, "--missing"));
    tell(reject_sentinels(series));
    if (flagged > 0)
      warnings.push_back(formatted("{} values of '{}' are flagged bad; they count as missing",
                                   flagged, offer.name));
    return series;
  }

  /// Of directions the nearer level alone counts: half-way from 350 to 10 degrees is not 180.
  static void keep_nearest(std::vector<double>& weight) {
    const auto nearest = std::max_element(weight.begin(), weight.end()) - weight.begin();
    std::fill(weight.begin(), weight.end(), 0.0);
    weight[static_cast<std::size_t>(nearest)] = 1;
  }

  static std::string unit_of(const Offer& offer, const netcdf::Variable& variable) {
    if (!offer.unit.empty()) return offer.unit;
    refuse("variable '" + variable.name + "': found no units; name them, as --column '" +
           offer.name + "=" + offer.standard_name + ":UNIT'");
  }

  /// A grid, or several stations, is more than one place.
  void expect_one_place(const netcdf::Variable& variable, const std::string& time) const {
    for (std::size_t d = 0; d < variable.dimensions.size(); ++d) {
      const std::string& name = variable.dimensions[d];
      if (name == time || variable.shape[d] == 1 || metres_of(name, time)) continue;
      const std::string cut = is_horizontal(name) ? "cdo remapnn,lon=…/lat=…, or ncks -d"
                                                  : "ncks -d " + name + ",0 IN OUT";
      refuse(
          formatted("variable '{}': found {} places along '{}', expected a series of one place; "
                    "cut it to one ({}), or `slackwater ingest` it and say --site",
                    variable.name, variable.shape[d], name, cut));
    }
  }

  /// Whether a dimension is one of latitude or longitude.
  [[nodiscard]] bool is_horizontal(const std::string& dimension) const {
    const netcdf::Variable* found = file_.find(dimension);
    const std::string units = lower_case(found == nullptr ? "" : found->text("units").value_or(""));
    return units.starts_with("degree") &&
           (units.find("east") != std::string::npos || units.find("north") != std::string::npos);
  }

  /// The variable that gives the levels of a dimension: its own, or a depth beside each value.
  [[nodiscard]] const netcdf::Variable* levels_along(const std::string& dimension,
                                                     const std::string& time) const {
    if (const netcdf::Variable* own = file_.find(dimension);
        own != nullptr && own->dimensions == std::vector<std::string>{dimension})
      return own;
    for (const netcdf::Variable& variable : file_.variables()) {
      const auto& along = variable.dimensions;
      const bool over_both = along.size() == 2 &&
                             std::find(along.begin(), along.end(), dimension) != along.end() &&
                             std::find(along.begin(), along.end(), time) != along.end();
      const bool over_levels = along == std::vector<std::string>{dimension};
      if ((over_both || over_levels) && is_depth_coordinate(variable)) return &variable;
    }
    return nullptr;
  }

  /// Metres of the levels along a dimension, positive, in the order of the file; where they change
  /// in time their medians. Nothing where a dimension counts no levels.
  [[nodiscard]] std::optional<std::vector<double>> metres_of(const std::string& dimension,
                                                             const std::string& time) const {
    const netcdf::Variable* levels = levels_along(dimension, time);
    if (levels == nullptr) return std::nullopt;
    UnitConversion unit;
    try {
      unit = unit_conversion(levels->text("units").value_or(""), "m", dimension);
    } catch (const Error&) {
      return std::nullopt;
    }
    std::vector<double> values = file_.read_all(*levels);
    for (double& level : values) level = std::abs(unit.scale * level + unit.offset);
    if (levels->dimensions.size() == 1) return values;
    const bool level_last = levels->dimensions[1] == dimension;
    const std::size_t count = levels->shape[level_last ? 1 : 0];
    const std::size_t times = levels->shape[level_last ? 0 : 1];
    std::vector<double> medians;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<double> here;
      for (std::size_t t = 0; t < times; ++t) {
        const double value = values[level_last ? t * count + k : k * times + t];
        if (value <= 12000) here.push_back(value);  // else missing: no sea is deeper
      }
      medians.push_back(here.empty() ? nan : upper_median(std::move(here)));
    }
    return medians;
  }

  /// How much each level counts at the depth that was asked for.
  [[nodiscard]] std::vector<double> level_weights(const netcdf::Variable& variable,
                                                  const SeriesDimensions& dimensions,
                                                  std::size_t levels,
                                                  const std::string& time) const {
    std::vector<double> weight(levels, 0);
    if (levels == 1) return {1.0};
    const std::string& name = variable.dimensions[*dimensions.level];
    const std::vector<double> metres = metres_of(name, time).value();
    if (!options_.depth_m)
      refuse(
          formatted("variable '{}': found {} levels along '{}', from {:g} to {:g} m; say which "
                    "with --depth METRES",
                    variable.name, levels, name, metres.front(), metres.back()));
    const double wanted = *options_.depth_m;
    for (std::size_t k = 0; k < levels; ++k) {
      if (metres[k] == wanted) {
        weight[k] = 1;
        return weight;
      }
    }
    for (std::size_t k = 0; k + 1 < levels; ++k) {
      const double share = (wanted - metres[k]) / (metres[k + 1] - metres[k]);
      if (!(share > 0 && share < 1)) continue;
      weight[k] = 1 - share;
      weight[k + 1] = share;
      return weight;
    }
    refuse(formatted("variable '{}': found --depth {:g}, expected {:g} to {:g} m", variable.name,
                     wanted, *std::min_element(metres.begin(), metres.end()),
                     *std::max_element(metres.begin(), metres.end())));
  }

  netcdf::File file_;
  const HistoryOptions& options_;
  const Vocabulary& vocabulary_;
  std::vector<Offer> offers_;
};

}  // namespace

HistoryOfFile read_cf_history(const std::filesystem::path& file,
                              const std::vector<std::string>& wanted, const HistoryOptions& options,
                              const Vocabulary& vocabulary) {
  return CfHistory(file, options, vocabulary).read(wanted);
}

}  // namespace slackwater::ingest
