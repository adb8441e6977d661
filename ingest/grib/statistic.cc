#include "ingest/grib/statistic.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace slackwater::ingest::grib {
namespace {

struct Named {
  long code;
  std::string_view words;
};

std::string words_of(std::span<const Named> table, long code, std::string_view otherwise) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Named& row) { return row.code == code; });
  return found == table.end() ? std::string(otherwise) : std::string(found->words);
}

/// Code table 4.7 and NCEP's local codes (GRIB 2 table 4.7 of NCEP).
constexpr std::array derived_forecasts{
    Named{0, "unweighted mean of all members"},
    Named{1, "weighted mean of all members"},
    Named{2, "standard deviation of the members"},
    Named{3, "normalised standard deviation of the members"},
    Named{4, "spread of all members"},
    Named{5, "large anomaly index of all members"},
    Named{6, "mean of a cluster of members"},
    Named{7, "interquartile range of the members"},
    Named{8, "minimum of all members"},
    Named{9, "maximum of all members"},
    Named{192, "mode of all members"},
    Named{193, "10 % percentile of the members"},
    Named{194, "50 % percentile of the members"},
    Named{195, "90 % percentile of the members"},
};

/// Code table 4.10.
constexpr std::array processings{
    Named{0, "average"},
    Named{1, "accumulation"},
    Named{2, "maximum"},
    Named{3, "minimum"},
    Named{4, "difference"},
    Named{5, "root mean square"},
    Named{6, "standard deviation"},
    Named{7, "covariance"},
    Named{8, "difference"},
    Named{9, "ratio"},
    Named{10, "standardised anomaly"},
    Named{11, "sum"},
    Named{100, "severity"},
    Named{101, "mode"},
};
constexpr long average = 0;
constexpr long maximum = 2;
constexpr long not_said = 255;

/// Code table 4.3: ways of making a field that give no field of the quantity.
constexpr std::array foreign_processes{
    Named{5, "probability forecast"},
    Named{6, "forecast error"},
    Named{7, "analysis error"},
    Named{9, "climatology"},
    Named{10, "probability-weighted forecast"},
    Named{18, "difference between two forecasts"},
    Named{20, "analysis increment"},
    Named{21, "initialisation increment"},
};

/// ECMWF's types that are no field of the quantity itself, nor a mean over all members.
struct Type {
  std::string_view type;
  std::string_view words;
};
constexpr std::array foreign_types{
    Type{"ef", "errors in the first guess"},
    Type{"ea", "errors in the analysis"},
    Type{"cm", "mean of a cluster of members"},
    Type{"cs", "standard deviation of a cluster"},
    Type{"fp", "forecast probability"},
    Type{"es", "standard deviation of the members"},
    Type{"fa", "accumulation"},
    Type{"cl", "climatology"},
    Type{"ed", "empirical distribution"},
    Type{"tu", "tubes"},
    Type{"efi", "extreme forecast index"},
    Type{"efic", "extreme forecast index of the control"},
    Type{"pb", "probability boundaries"},
    Type{"ep", "event probability"},
    Type{"cd", "distribution of the climate"},
    Type{"4i", "analysis increments"},
    Type{"me", "model errors"},
    Type{"eme", "model errors"},
    Type{"pd", "probability distribution"},
    Type{"ci", "cluster information"},
    Type{"sot", "shift of tails"},
    Type{"wes", "weighted standard deviation of the members"},
    Type{"ses", "scaled standard deviation of the members"},
    Type{"taes", "standard deviation of the members over time"},
    Type{"sg", "sensitivity gradient"},
    Type{"sf", "sensitivity forecast"},
    Type{"icp", "perturbation of the initial state"},
    Type{"sv", "singular vector"},
    Type{"as", "adjoint singular vector"},
    Type{"svar", "signal variance"},
    Type{"fcmax", "maximum of the forecast"},
    Type{"fcmin", "minimum of the forecast"},
    Type{"fcstdev", "standard deviation of the forecast"},
    Type{"hcmean", "mean of past forecasts"},
};

/// Code table 4.0: what a template is, as far as it may carry wind or waves.
enum class Kind { value, over_time, derived, derived_over_time, cluster, foreign };
struct Template {
  long number;
  Kind kind;
  std::string_view words;
};
constexpr std::array templates{
    Template{0, Kind::value, ""},
    Template{1, Kind::value, ""},
    Template{2, Kind::derived, ""},
    Template{3, Kind::cluster, "of a cluster of members"},
    Template{4, Kind::cluster, "of a cluster of members"},
    Template{5, Kind::foreign, "probability"},
    Template{6, Kind::foreign, "percentile"},
    Template{7, Kind::foreign, "analysis or forecast error"},
    Template{8, Kind::over_time, ""},
    Template{9, Kind::foreign, "probability"},
    Template{10, Kind::foreign, "percentile"},
    Template{11, Kind::over_time, ""},
    Template{12, Kind::derived_over_time, ""},
    Template{13, Kind::cluster, "of a cluster of members"},
    Template{14, Kind::cluster, "of a cluster of members"},
    Template{15, Kind::value, ""},
    Template{51, Kind::foreign, "categories"},
    Template{60, Kind::value, ""},
    Template{61, Kind::over_time, ""},
    Template{70, Kind::value, ""},
    Template{71, Kind::value, ""},
    Template{72, Kind::over_time, ""},
    Template{73, Kind::over_time, ""},
    Template{86, Kind::foreign, "quantile"},
    Template{87, Kind::foreign, "quantile"},
    Template{91, Kind::foreign, "categories"},
};

std::string percentile_of(const Message& message) {
  if (const auto value = message.integer_if_any("percentileValue"))
    return std::to_string(*value) + " % percentile";
  return "percentile";
}

/// The processing over time of a GRIB 2 message, each of its ranges; empty where all is well.
std::string refused_over_time(const Message& message, bool is_gust) {
  const std::vector<long> all = message.integers_if_any("typeOfStatisticalProcessing");
  for (const long processing : all) {
    if (processing == average || (is_gust && processing == maximum && all.size() == 1)) continue;
    return words_of(processings, processing, "statistic") + " over time";
  }
  return "";
}

Statistic of_edition_2(const Message& message, bool is_gust) {
  Statistic found;
  const long number = message.integer_if_any("productDefinitionTemplateNumber").value_or(-1);
  const auto known = std::find_if(templates.begin(), templates.end(),
                                  [&](const Template& t) { return t.number == number; });
  const std::string in_template = " (template 4." + std::to_string(number);
  if (known == templates.end()) {
    found.refused = "a kind of field that is not known here" + in_template + ")";
    return found;
  }
  if (known->kind == Kind::foreign) {
    found.refused =
        (known->words == "percentile" ? percentile_of(message) : std::string(known->words)) +
        in_template + ")";
    return found;
  }
  const bool derived = known->kind == Kind::derived || known->kind == Kind::derived_over_time;
  if (derived || known->kind == Kind::cluster) {
    const long code = message.integer_if_any("derivedForecast").value_or(not_said);
    found.is_ensemble_mean = derived && (code == 0 || code == 1);
    if (!found.is_ensemble_mean) {
      const std::string words = words_of(derived_forecasts, code, "statistic of the members");
      found.refused =
          (derived || words.find("cluster") != std::string::npos ? words
                                                                 : words + ", of a cluster") +
          in_template + ", derived forecast " + std::to_string(code) + ")";
      return found;
    }
  }
  // Its processing is over an area: the mean around a point is read as its value.
  if (number == 15) {
    const long process = message.integer_if_any("statisticalProcess").value_or(not_said);
    if (process != average && process != not_said) {
      found.refused =
          words_of(processings, process, "statistic") + " over an area" + in_template + ")";
      return found;
    }
  }
  if (const std::string over_time = refused_over_time(message, is_gust); !over_time.empty()) {
    found.refused = over_time + in_template + ")";
    return found;
  }
  const long process = message.integer_if_any("typeOfGeneratingProcess").value_or(not_said);
  const std::string foreign = words_of(foreign_processes, process, "");
  if (!foreign.empty())
    found.refused = foreign + " (type of generating process " + std::to_string(process) + ")";
  return found;
}

/// NCEP's ensembles in GRIB 1: octets 42 (type), 43 (number), 44 (product), 46 (probability).
Statistic of_ncep_1(const Message& message, long product) {
  Statistic found;
  const long type = message.integer_if_any("type").value_or(0);
  const long number = message.integer_if_any("identificationNumber").value_or(0);
  const std::string said =
      " (NCEP type " + std::to_string(type) + ", product " + std::to_string(product) + ")";
  if (message.integer_if_any("probabilityType").value_or(0) > 0) {
    found.refused = "probability" + said;
  } else if (type == 4) {
    found.refused = "statistic of a cluster of members" + said;
  } else if (product == 11 || product == 12) {
    found.refused = "standard deviation of the members" + said;
  } else if (product > 2 || (product == 2 && type != 5) || type > 5) {
    found.refused = "statistic of the members" + said;
  } else if (type == 5) {
    found.is_ensemble_mean = true;
  } else if (type == 1) {
    found.member = 0;
  } else if (type == 2 || type == 3) {
    found.member = static_cast<int>(2 * number - (type == 3 ? 1 : 0));  // pairs of + and -
  }
  return found;
}

/// GRIB 1 code table 5: what is no instant and no average that begins and ends with the steps.
std::string refused_over_time_1(const Message& message, bool is_gust) {
  constexpr long ecmwf = 98;
  constexpr std::array ranges{
      Named{4, "accumulation"},         Named{5, "difference"},
      Named{51, "climatological mean"}, Named{114, "accumulation of forecasts"},
      Named{116, "accumulation"},       Named{118, "variance"},
      Named{119, "standard deviation"}, Named{124, "accumulation of analyses"},
      Named{125, "standard deviation"},
  };
  const long range = message.integer_if_any("timeRangeIndicator").value_or(0);
  std::string words = words_of(ranges, range, "");
  const std::string step_type = message.text_if_any("stepType").value_or("");
  // ECMWF's own convention for extremes, which GRIB 1 cannot say.
  if (range == 2 && message.integer_if_any("centre") == ecmwf) {
    if (step_type == "max" && !is_gust) words = "maximum";
    if (step_type == "min") words = "minimum";
  }
  return words.empty() ? words
                       : words + " over time (time range indicator " + std::to_string(range) + ")";
}

}  // namespace

Statistic statistic_of(const Message& message, bool is_gust) {
  Statistic found;
  if (message.integer_if_any("edition") == 2) {
    found = of_edition_2(message, is_gust);
  } else {
    constexpr long ncep = 7;
    const auto product = message.integer_if_any("productIdentifier");
    if (message.integer_if_any("centre") == ncep && product) found = of_ncep_1(message, *product);
    if (found.refused.empty()) found.refused = refused_over_time_1(message, is_gust);
  }
  if (!found.refused.empty()) return found;

  const std::string type = message.text_if_any("dataType").value_or("");
  const auto foreign = std::find_if(foreign_types.begin(), foreign_types.end(),
                                    [&](const Type& row) { return row.type == type; });
  if (foreign != foreign_types.end()) {
    found.refused = std::string(foreign->words) + " (type " + type + ")";
  } else if (type == "em" || type == "wem" || type == "taem") {
    found.is_ensemble_mean = true;
  }
  return found;
}

}  // namespace slackwater::ingest::grib
