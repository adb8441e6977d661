#include "ingest/cf/cell_methods.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "fields/base/text.h"

namespace slackwater::ingest {
namespace {

struct Word {
  std::string_view word;
  std::string_view meaning;
};

/// Methods that give no field of the quantity (CF, appendix E, and what writers say instead).
constexpr std::array statistics{
    Word{"maximum", "maximum"},
    Word{"max", "maximum"},
    Word{"minimum", "minimum"},
    Word{"min", "minimum"},
    Word{"median", "median"},
    Word{"mode", "mode"},
    Word{"range", "range"},
    Word{"mid_range", "middle of the range"},
    Word{"standard_deviation", "standard deviation"},
    Word{"std", "standard deviation"},
    Word{"stddev", "standard deviation"},
    Word{"variance", "variance"},
    Word{"var", "variance"},
    Word{"spread", "spread"},
    Word{"sum", "sum"},
    Word{"sum_of_squares", "sum of squares"},
    Word{"accumulation", "accumulation"},
    Word{"root_mean_square", "root mean square"},
    Word{"rms", "root mean square"},
    Word{"percentile", "percentile"},
    Word{"quantile", "quantile"},
    Word{"probability", "probability"},
    Word{"maximum_absolute_value", "largest size"},
    Word{"minimum_absolute_value", "smallest size"},
    Word{"mean_absolute_value", "mean size"},
    Word{"mean_of_upper_decile", "mean of the upper decile"},
};

/// Words of a short name or at its ends, "uo_std", "max_u10".
constexpr std::array name_words{
    Word{"std", "standard deviation"},
    Word{"stdev", "standard deviation"},
    Word{"stddev", "standard deviation"},
    Word{"sd", "standard deviation"},
    Word{"spread", "spread"},
    Word{"variance", "variance"},
    Word{"percentile", "percentile"},
    Word{"quantile", "quantile"},
    Word{"prob", "probability"},
    Word{"probability", "probability"},
    Word{"rmse", "error"},
    Word{"rms", "root mean square"},
    Word{"error", "error"},
    Word{"err", "error"},
    Word{"max", "maximum"},
    Word{"maximum", "maximum"},
    Word{"min", "minimum"},
    Word{"minimum", "minimum"},
    Word{"median", "median"},
    Word{"anom", "anomaly"},
    Word{"anomaly", "anomaly"},
};

/// Phrases of a long name; single words would meet "spectral variance density maximum".
constexpr std::array long_words{
    Word{"standard deviation", "standard deviation"},
    Word{"standard error", "standard error"},
    Word{"ensemble spread", "spread"},
    Word{"spread of", "spread"},
    Word{"percentile", "percentile"},
    Word{"quantile", "quantile"},
    Word{"probability", "probability"},
    Word{"interquartile", "interquartile range"},
    Word{"root mean square error", "error"},
    Word{"large anomaly index", "large anomaly index"},
};

/// Modifiers of standard names (CF, appendix C).
constexpr std::array modifiers{"standard_error", "status_flag", "number_of_observations",
                               "detection_minimum"};

std::string canonical_method(const std::string& word) {
  if (word == "average" || word == "avg" || word == "ave") return "mean";
  if (word == "instantaneous" || word == "instant" || word == "snapshot") return "point";
  return word;
}

std::string meaning_of(std::string_view word) {
  for (const Word& statistic : statistics) {
    if (statistic.word == word) return std::string(statistic.meaning);
  }
  for (const char* start : {"percentile", "quantile"}) {  // "percentile_90"
    if (word.starts_with(start)) return start;
  }
  return "";
}

bool is_time(const std::string& axis, const std::vector<std::string>& dimensions) {
  if (axis.starts_with("time") || axis == "t") return true;
  return !dimensions.empty() && lower_case(dimensions.front()) == axis &&
         axis.find("time") != std::string::npos;
}

bool is_members(const std::string& axis) {
  for (const char* name : {"realization", "realisation", "ensemble", "number", "member"}) {
    if (axis.starts_with(name)) return true;
  }
  return axis == "ens";
}

std::string without_comments(std::string_view text) {
  std::string plain;
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (depth == 0) plain += c;
    if (c == ')' && depth > 0) --depth;
  }
  return lower_case(plain);
}

/// A maximum by its nature.
bool is_extreme(const Quantity& quantity) {
  return quantity.standard_name == "wind_speed_of_gust" ||
         quantity.standard_name.find("maximum_height") != std::string::npos;
}

std::optional<std::string> by_cell_methods(const netcdf::Variable& variable,
                                           const Quantity& quantity) {
  const std::string text = variable.text("cell_methods").value_or("");
  for (const CellMethod& entry : cell_methods_of(text)) {
    const bool over_time =
        std::any_of(entry.axes.begin(), entry.axes.end(),
                    [&](const std::string& axis) { return is_time(axis, variable.dimensions); });
    const bool over_members = std::any_of(entry.axes.begin(), entry.axes.end(), is_members);
    const std::string said = " (cell_methods '" + text + "')";
    if (over_time && entry.is_climatology) return "climatology" + said;
    const std::string meaning = meaning_of(entry.method);
    if (meaning.empty() || (over_time && meaning == "maximum" && is_extreme(quantity))) continue;
    return meaning +
           (over_time      ? " over time"
            : over_members ? " over the members of an ensemble"
                           : " over " + (entry.axes.empty() ? "cells" : entry.axes[0])) +
           said;
  }
  return std::nullopt;
}

std::optional<std::string> by_converter(const netcdf::Variable& variable,
                                        const Quantity& quantity) {
  const std::string step = lower_case(variable.text("GRIB_stepType").value_or(""));
  if (!step.empty() && step != "instant" && step != "avg" && step != "mean" &&
      !(step == "max" && is_extreme(quantity))) {
    return "statistic over time (GRIB_stepType '" + step + "')";
  }
  const std::string type = lower_case(variable.text("GRIB_dataType").value_or(""));
  constexpr std::array foreign{"es", "ep", "fp", "cm",  "cs",  "efi",  "sot",   "pb",    "pd",
                               "ed", "cd", "cl", "wes", "ses", "taes", "fcmax", "fcmin", "fcstdev"};
  if (std::find(foreign.begin(), foreign.end(), type) != foreign.end())
    return "statistic of the members (GRIB_dataType '" + type + "')";
  return std::nullopt;
}

std::optional<std::string> by_name(const netcdf::Variable& variable, const Quantity& quantity) {
  std::string standard_name = variable.text("standard_name").value_or("");
  for (const char* modifier : modifiers) {
    if (standard_name.ends_with(std::string(" ") + modifier))
      return std::string(modifier) + " (standard_name '" + standard_name + "')";
  }
  std::string spaced;
  for (const char c : variable.name)
    spaced += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : ' ';
  std::istringstream words(lower_case(spaced));
  for (std::string word; words >> word;) {
    const bool is_percentile = word.size() >= 2 && word.size() <= 4 && word[0] == 'p' &&
                               std::all_of(word.begin() + 1, word.end(),
                                           [](unsigned char c) { return std::isdigit(c) != 0; }) &&
                               word != lower_case(variable.name);
    if (is_percentile) return "percentile (its name is '" + variable.name + "')";
    for (const Word& known : name_words) {
      if (known.word != word || word == lower_case(variable.name)) continue;
      if (known.meaning == "maximum" && is_extreme(quantity)) continue;
      return std::string(known.meaning) + " (its name is '" + variable.name + "')";
    }
  }
  const std::string long_name = variable.text("long_name").value_or("");
  for (const Word& known : long_words) {
    if (contains_ignoring_case(long_name, known.word))
      return std::string(known.meaning) + " (long_name '" + long_name + "')";
  }
  return std::nullopt;
}

}  // namespace

std::vector<CellMethod> cell_methods_of(std::string_view text) {
  // "time:mean" and "time : mean" are met too.
  std::string spaced;
  for (const char c : without_comments(text)) {
    if (c == ':') {
      while (!spaced.empty() && spaced.back() == ' ') spaced.pop_back();
      spaced += ": ";
    } else {
      spaced += c == ',' || c == ';' ? ' ' : c;
    }
  }
  std::vector<CellMethod> entries;
  bool names_axes = false;
  std::istringstream words(spaced);
  std::string before;
  for (std::string word; words >> word; before = word) {
    if (word.size() > 1 && word.back() == ':') {
      if (!names_axes) entries.emplace_back();
      entries.back().axes.push_back(word.substr(0, word.size() - 1));
      names_axes = true;
      continue;
    }
    if (names_axes) entries.back().method = canonical_method(word);
    names_axes = false;
    const bool bounds = before == "within" || before == "over";
    if (bounds && !entries.empty() && (word == "days" || word == "years"))
      entries.back().is_climatology = true;
  }
  return entries;
}

bool has_method(const std::vector<CellMethod>& methods, const std::vector<std::string>& axes,
                std::string_view method) {
  return std::any_of(methods.begin(), methods.end(), [&](const CellMethod& entry) {
    return entry.method == method &&
           std::any_of(entry.axes.begin(), entry.axes.end(), [&](const std::string& axis) {
             return std::find(axes.begin(), axes.end(), axis) != axes.end();
           });
  });
}

bool is_mean_of_members(const netcdf::Variable& variable) {
  const auto methods = cell_methods_of(variable.text("cell_methods").value_or(""));
  for (const CellMethod& entry : methods) {
    if (entry.method == "mean" && std::any_of(entry.axes.begin(), entry.axes.end(), is_members))
      return true;
  }
  const std::string type = lower_case(variable.text("GRIB_dataType").value_or(""));
  return type == "em" || type == "wem" ||
         contains_ignoring_case(variable.text("long_name").value_or(""), "ensemble mean");
}

std::optional<std::string> statistic_in(const netcdf::Variable& variable,
                                        const Quantity& quantity) {
  if (auto found = by_cell_methods(variable, quantity)) return found;
  if (auto found = by_converter(variable, quantity)) return found;
  return by_name(variable, quantity);
}

}  // namespace slackwater::ingest
