#include "ingest/history/observation_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "fields/base/constants.h"
#include "fields/base/encode/csv.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/history/read_wanted.h"
#include "ingest/history/sentinels.h"
#include "ingest/history/written_time.h"
#include "ingest/quality/flags.h"

namespace slackwater::ingest {
namespace {

/// One value at one depth.
struct Observation {
  UtcTime time{};
  double depth_m = 0;
  double value = 0;
};

std::optional<double> decimal_in(const std::string& cell) {
  double value = 0;
  const char* const end = cell.data() + cell.size();
  const auto [stop, problem] = std::from_chars(cell.data(), end, value);
  if (problem != std::errc{} || stop != end || cell.empty() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// The value at a depth, between two observations linearly; NaN outside.
/// @param nearest  the nearer one alone: half-way from 350 to 10 degrees is not 180
double at_depth(const std::vector<Observation>& column, double depth_m, bool nearest) {
  const Observation* above = nullptr;
  const Observation* below = nullptr;
  for (const Observation& one : column) {
    if (one.depth_m <= depth_m && (above == nullptr || one.depth_m > above->depth_m)) above = &one;
    if (one.depth_m >= depth_m && (below == nullptr || one.depth_m < below->depth_m)) below = &one;
  }
  if (above == nullptr || below == nullptr) return constants::nan;
  if (above->depth_m == below->depth_m) return above->value;
  const double share = (depth_m - above->depth_m) / (below->depth_m - above->depth_m);
  if (nearest) return share > 0.5 ? below->value : above->value;
  return (1 - share) * above->value + share * below->value;
}

class ObservationTable {
 public:
  ObservationTable(const std::filesystem::path& file, const HistoryOptions& options,
                   const Vocabulary& vocabulary)
      : file_(file), options_(options), vocabulary_(vocabulary) {
    std::set<std::string> platforms;
    for_each_row([&](const std::vector<std::string>& cells) {
      variables_.insert(cells[at_.at("variable")]);
      platforms.insert(cells[at_.at("platform_id")]);
    });
    if (platforms.size() > 1)
      refuse(
          formatted("found {} platforms ({}), expected one: keep the rows of one, or subset to "
                    "one place",
                    platforms.size(), joined(platforms, ", ").substr(0, 200)));
    find_offers();
  }

  HistoryOfFile read(const std::vector<std::string>& wanted) {
    HistoryOfFile answer;
    answer.columns.assign(variables_.begin(), variables_.end());
    answer.offered = names_offered(offers_, options_);
    const auto read_making = [&](const Making& making, std::vector<std::string>& warnings) {
      HistorySeries series = series_of(offers_[making.first], warnings);
      if (making.second)
        make_of_components(series, series_of(offers_[*making.second], warnings), making);
      return series;
    };
    read_wanted(wanted, offers_, vocabulary_, read_making, answer);
    return answer;
  }

 private:
  template <typename Visit>
  void for_each_row(const Visit& visit) {
    std::ifstream in(file_, std::ios::binary);
    std::string line;
    at_.clear();
    std::size_t columns = 0;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      std::string_view text = line;
      if (number == 1 && text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
      text = trimmed(text);
      if (text.empty() || text.starts_with('#')) continue;
      with_context("line " + std::to_string(number), [&] {
        const auto cells = csv_cells(text);
        if (!cells) refuse("found a quote that is not closed; expected \" in pairs");
        if (at_.empty()) {
          for (std::size_t i = 0; i < cells->size(); ++i) at_.emplace((*cells)[i], i);
          columns = cells->size();
          return;
        }
        if (cells->size() != columns)
          refuse(formatted("found {} cells, expected {} as in the line of names", cells->size(),
                           columns));
        visit(*cells);
      });
    }
  }

  void find_offers() {
    for (const std::string& variable : variables_) {
      const auto named =
          std::find_if(options_.columns.begin(), options_.columns.end(),
                       [&](const NamedColumn& column) { return column.column == variable; });
      const Quantity* quantity = vocabulary_.by_alias(variable);
      if (named != options_.columns.end()) {
        quantity = vocabulary_.by_standard_name(named->standard_name);
        const std::string unit = quantity == nullptr ? "" : quantity->unit;
        offers_.push_back({variable, current_name(named->standard_name, vocabulary_),
                           named->unit.empty() ? unit : named->unit, true});
      } else if (quantity != nullptr) {
        offers_.push_back(
            {variable, quantity->standard_name, quantity->unit == "K" ? "degC" : quantity->unit});
      }
    }
  }

  HistorySeries series_of(const Offer& offer, std::vector<std::string>& warnings) {
    if (offer.unit.empty())
      refuse("variable '" + offer.name + "': found no unit; name it, as --column '" + offer.name +
             "=" + offer.standard_name + ":UNIT'");
    HistorySeries series;
    series.name = offer.name;
    series.standard_name = offer.standard_name;
    series.unit = offer.unit;
    series.source = file_.string();
    const std::vector<Observation> all = observations_of(offer.name, warnings);
    const std::set<double> depths = [&] {
      std::set<double> found;
      for (const Observation& one : all) found.insert(one.depth_m);
      return found;
    }();
    if (depths.size() > 1 && !options_.depth_m)
      refuse(
          formatted("variable '{}': found {} depths, from {:g} to {:g} m; say which with --depth "
                    "METRES",
                    offer.name, depths.size(), *depths.begin(), *depths.rbegin()));
    const bool is_outside = depths.size() > 1 && (*options_.depth_m < *depths.begin() ||
                                                  *options_.depth_m > *depths.rbegin());
    if (is_outside)
      refuse(formatted("variable '{}': found --depth {:g}, expected {:g} to {:g} m", offer.name,
                       *options_.depth_m, *depths.begin(), *depths.rbegin()));
    for (std::size_t i = 0; i < all.size();) {
      std::vector<Observation> column;
      for (; i < all.size() && (column.empty() || all[i].time == column.front().time); ++i)
        column.push_back(all[i]);
      series.time.push_back(column.front().time);
      series.value.push_back(depths.size() == 1 ? column.front().value
                                                : at_depth(column, *options_.depth_m,
                                                           is_direction(offer.standard_name)));
    }
    for (std::string& told : take_as_missing(series, options_.missing, "--missing"))
      warnings.push_back(std::move(told));
    for (std::string& told : reject_sentinels(series)) warnings.push_back(std::move(told));
    return series;
  }

  std::vector<Observation> observations_of(const std::string& variable,
                                           std::vector<std::string>& warnings) {
    const auto scheme = FlagScheme::from_attributes({}, "", "Copernicus");
    std::vector<Observation> all;
    std::size_t flagged = 0;
    for_each_row([&](const std::vector<std::string>& cells) {
      if (cells[at_.at("variable")] != variable) return;
      const std::string& written = cells[at_.at("time")];
      const auto time = read_written_time(written);
      if (!time) refuse("found '" + written + "' where a time was expected");
      if (!time->offset && !options_.assume_utc)
        refuse("found '" + written +
               "', a time without a zone; expected a Z behind it. If the times are UTC say "
               "--assume-utc");
      if (!all.empty() && time->utc() < all.back().time)
        refuse("time runs backward: " + format_utc(time->utc()) + " after " +
               format_utc(all.back().time) + "; sort the rows of '" + variable + "'");
      const auto depth = at_.contains("depth") ? decimal_in(cells[at_.at("depth")]) : std::nullopt;
      Observation one{time->utc(), depth.value_or(0),
                      decimal_in(cells[at_.at("value")]).value_or(constants::nan)};
      bool is_repeated = false;
      for (auto other = all.rbegin(); other != all.rend() && other->time == one.time; ++other)
        is_repeated |= other->depth_m == one.depth_m;
      if (is_repeated)
        refuse("found a second value of '" + variable + "' at " + format_utc(one.time) +
               formatted(" in {:g} m; drop duplicates", one.depth_m));
      if (at_.contains("value_qc") && !std::isnan(one.value)) {
        const auto flag = decimal_in(cells[at_.at("value_qc")]);
        if (flag && !has_value(scheme->status_of(std::lround(*flag)))) {
          one.value = constants::nan;
          ++flagged;
        }
      }
      all.push_back(one);
    });
    if (flagged > 0)
      warnings.push_back(formatted("{} of {} values of '{}' are flagged bad; they count as missing",
                                   flagged, all.size(), variable));
    return all;
  }

  std::filesystem::path file_;
  const HistoryOptions& options_;
  const Vocabulary& vocabulary_;
  std::map<std::string, std::size_t, std::less<>> at_;  ///< of a column, by its name
  std::set<std::string> variables_;
  std::vector<Offer> offers_;
};

}  // namespace

bool is_observation_table(const std::vector<std::string>& columns) {
  const auto has = [&](std::string_view name) {
    return std::find(columns.begin(), columns.end(), name) != columns.end();
  };
  return has("variable") && has("platform_id") && has("time") && has("value");
}

HistoryOfFile read_observation_table(const std::filesystem::path& file,
                                     const std::vector<std::string>& wanted,
                                     const HistoryOptions& options, const Vocabulary& vocabulary) {
  return ObservationTable(file, options, vocabulary).read(wanted);
}

}  // namespace slackwater::ingest
