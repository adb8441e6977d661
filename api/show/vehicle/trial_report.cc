#include "api/show/vehicle/trial_report.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "fields/base/yaml_value.h"
#include "twin/run/printable.h"

namespace slackwater::api {
namespace {

using calibration::EndedOn;
using calibration::FittedParameter;
using nlohmann::json;

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }

/// As people read it: "yaw_deg", and what one of SI is in it.
struct ShownQuantity {
  std::string name;
  double per_si = 1;
};
ShownQuantity shown(twin::TrialQuantity quantity) {
  std::string name(twin::name_of(quantity));
  const std::size_t at = name.find("_rad");
  if (at == std::string::npos) return {name, 1};
  return {name.replace(at, 4, "_deg"), 1 / constants::degree};
}

std::string percent(const std::optional<double>& share) {
  if (!share) return "-";
  // What hardly changes has no range that tells anything.
  return *share > 10 ? "> 1000 %" : formatted("{:.2f} %", 100 * *share);
}

double six_digits(double value) {
  const std::string text = formatted("{:.6g}", value);
  double rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

/// A mapping with a number under a dotted key.
YamlValue put_number(const YamlValue& mapping, std::string_view key, double value) {
  YamlValue out = mapping;
  const std::size_t dot = key.find('.');
  if (dot == std::string_view::npos) return out.put(key, value);
  const std::string_view first = key.substr(0, dot);
  YamlValue below;
  for (std::size_t i = 0; i < mapping.keys().size(); ++i)
    if (mapping.keys()[i] == first) below = mapping.items()[i];
  return out.put(first, put_number(below, key.substr(dot + 1), value));
}

/// Known to a third of itself, and not held by a bound.
bool is_for_the_file(const FittedParameter& p) {
  return p.is_determined && p.ended_on == EndedOn::neither && p.standard_deviation &&
         *p.standard_deviation < std::abs(p.value) / 3;
}

std::string verdict_on(const FittedParameter& p) {
  if (p.ended_on == EndedOn::low) return formatted("ended on its lower bound, {:g}", p.low);
  if (p.ended_on == EndedOn::high) return formatted("ended on its upper bound, {:g}", p.high);
  return p.is_determined ? "determined" : "not determined by this trial";
}

std::string table_of_keys(const TrialFit& fit) {
  std::string text =
      formatted("  {:<28} {:>12} {:>12} {:>12}\n", "key", "file", "fitted", "std. dev.");
  for (const FittedParameter& p : fit.fit.parameters)
    text += formatted("  {:<28} {:>12.6g} {:>12.6g} {:>12}  {}\n", p.name, p.start, p.value,
                      p.standard_deviation ? formatted("{:.3g}", *p.standard_deviation) : "-",
                      verdict_on(p));
  return text;
}

std::string words_of_pairs(const TrialFit& fit) {
  constexpr double close = 0.9;
  std::string text;
  const auto& p = fit.fit.parameters;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double together =
          fit.fit.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (std::abs(together) > close)
        text += formatted(
            "{} and {} make up for each other (correlation {:.2f}): fit one of them, or bring a "
            "trial that tells them apart.\n",
            p[j].name, p[i].name, together);
    }
  return text;
}

}  // namespace

std::string trial_text(const twin::Trial& trial, const twin::TrialRun& run,
                       const twin::TrialErrors& errors) {
  std::string text = formatted(
      "Trial {}: {:.4g} s, {}. The vehicle of the file, told the same, "
      "less the trial:\n\n",
      twin::printable(trial.name), trial.lasts_s(), counted(trial.rows(), "row"));
  text += formatted("  {:<10} {:>10} {:>10} {:>10} {:>10} {:>10} {:>8}\n", "", "rms", "mean",
                    "largest", "range", "rms/range", "values");
  for (const twin::TrialError& error : errors.error) {
    const auto [name, per_si] = shown(error.quantity);
    text += formatted("  {:<10} {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g} {:>10} {:>8}\n", name,
                      per_si * error.rms, per_si * error.bias, per_si * error.largest,
                      per_si * error.range, percent(error.share), error.n);
  }
  if (errors.place)
    text += formatted("\nAt the last place, {:.4g} s into it: {:.3g} m off after {:.4g} m ({}).\n",
                      errors.place->at_s - trial.time_s.front(), errors.place->off_m,
                      errors.place->way_m, percent(errors.place->share));
  if (run.diverged(trial))
    text += formatted(
        "\nThe calculation diverged {:.4g} s into the trial: the figures are of the {} before, "
        "and say nothing of the rest.\n",
        run.ended_at_s - trial.time_s.front(), counted(run.rows, "row"));
  return text;
}

json trial_json(const twin::Trial& trial, const twin::TrialRun& run,
                const twin::TrialErrors& errors) {
  json all = json::array();
  for (const twin::TrialError& error : errors.error)
    all.push_back({{"quantity", std::string(twin::name_of(error.quantity))},
                   {"unit", std::string(twin::unit_of(error.quantity))},
                   {"values", error.n},
                   {"rms", error.rms},
                   {"bias", error.bias},
                   {"largest", error.largest},
                   {"range", error.range},
                   {"rms_of_range", or_null(error.share)}});
  const double first_s = trial.time_s.front();
  json end = nullptr;
  if (errors.place)
    end = {{"after_s", errors.place->at_s - first_s},
           {"off_m", errors.place->off_m},
           {"way_m", errors.place->way_m},
           {"off_of_way", or_null(errors.place->share)}};
  const twin::Triple<double>& current = trial.current_m_s;
  return {
      {"name", twin::printable(trial.name)},
      {"rows", trial.rows()},
      {"compared_rows", run.rows},
      {"lasts_s", trial.lasts_s()},
      {"diverged_after_s", run.diverged(trial) ? json(run.ended_at_s - first_s) : json(nullptr)},
      {"current_m_s", json::array({current.x, current.y, current.z})},
      {"errors", std::move(all)},
      {"end", std::move(end)}};
}

std::string fitted_yaml(const TrialFit& fit) {
  YamlValue mapping;
  std::string comments;
  for (const FittedParameter& p : fit.fit.parameters) {
    if (!p.is_determined) continue;
    const double value = six_digits(p.value);
    if (p.ended_on == EndedOn::neither && !is_for_the_file(p))
      comments += formatted("# {}: {:g}, known to {:.2g} only\n", p.name, value,
                            p.standard_deviation.value_or(0));
    else if (!is_for_the_file(p))
      comments += formatted(
          "# {}: {:g} ended on a bound of the fit: look for what is wrong first\n", p.name, value);
    else if (p.name.find('[') != std::string::npos)
      comments += formatted("# {}: {:g}\n", p.name, value);
    else
      mapping = put_number(mapping, p.name, value);
  }
  return (mapping.is_empty() ? std::string() : yaml_of(mapping)) + comments;
}

std::string fit_text(const TrialFit& fit) {
  const calibration::ParameterFit& of = fit.fit;
  std::string text =
      formatted("Fitted to the trial; it {}. {} are worth {:.0f} independent ones.\n\n", of.ended,
                counted(of.residuals, "residual"), of.effective_residuals);
  text += table_of_keys(fit);
  text += formatted("\n  {:<10} {:>12} {:>12}\n", "rms", "file", "fitted");
  for (std::size_t i = 0; i < fit.before.error.size(); ++i) {
    const auto [name, per_si] = shown(fit.before.error[i].quantity);
    text += formatted("  {:<10} {:>12.4g} {:>12.4g}\n", name, per_si * fit.before.error[i].rms,
                      per_si * fit.after.error[i].rms);
  }
  text += "\nEach column weighs as much as any other: residuals are shares of its range.\n";
  for (const twin::TrialQuantity quantity : fit.left_out)
    text += shown(quantity).name + " never changes in the trial, and was left out of the fit.\n";
  if (fit.every_row > 1)
    text +=
        formatted("Fitted to one row of {}: the trial has more than are needed.\n", fit.every_row);
  text += words_of_pairs(fit);
  if (!of.has_converged) return text + "It did not converge: keep the numbers of the file.\n";
  const std::string yaml = fitted_yaml(fit);
  text += yaml.empty() ? "The trial determines none of them: keep the numbers of the file.\n"
                       : "The file stays as it is. To take over what the trial determines, write "
                         "these numbers over "
                         "those of the same keys:\n\n" +
                             yaml;
  return text;
}

json fit_json(const TrialFit& fit) {
  json keys = json::array(), errors = json::array(), left_out = json::array(),
       correlation = json::array();
  for (const FittedParameter& p : fit.fit.parameters)
    keys.push_back({{"key", p.name},
                    {"before", p.start},
                    {"value", p.value},
                    {"standard_deviation", or_null(p.standard_deviation)},
                    {"is_determined", p.is_determined},
                    {"low", p.low},
                    {"high", p.high},
                    {"ended_on", p.ended_on == EndedOn::low    ? json("low")
                                 : p.ended_on == EndedOn::high ? json("high")
                                                               : json(nullptr)}});
  for (std::size_t i = 0; i < fit.before.error.size(); ++i) {
    const twin::TrialError& error = fit.before.error[i];
    errors.push_back({{"quantity", std::string(twin::name_of(error.quantity))},
                      {"unit", std::string(twin::unit_of(error.quantity))},
                      {"rms_before", error.rms},
                      {"rms_after", fit.after.error[i].rms}});
  }
  for (const twin::TrialQuantity quantity : fit.left_out)
    left_out.push_back(std::string(twin::name_of(quantity)));
  const Eigen::MatrixXd& matrix = fit.fit.correlation;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    json row = json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    correlation.push_back(std::move(row));
  }
  return {{"ended", fit.fit.ended},
          {"has_converged", fit.fit.has_converged},
          {"residuals", fit.fit.residuals},
          {"effective_residuals", fit.fit.effective_residuals},
          {"every_row", fit.every_row},
          {"rms_before", fit.fit.rms_before},
          {"rms_after", fit.fit.rms_after},
          {"keys", std::move(keys)},
          {"correlation", std::move(correlation)},
          {"errors", std::move(errors)},
          {"left_out", std::move(left_out)},
          {"yaml", fitted_yaml(fit)}};
}

}  // namespace slackwater::api
