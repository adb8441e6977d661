#include "calibration/day/column/column_calibration.h"

#include <algorithm>
#include <cmath>

#include "calibration/solve/ageing.h"
#include "fields/base/attempt.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;

VectorColumn without_tide(VectorColumn column, const FittedTide& tide) {
  for (std::size_t t = 0; t < column.times(); ++t) {
    for (std::size_t k = 0; k < column.levels(); ++k)
      column.value[column.offset(t, k)] -= tide.at(k, column.time[t]);
  }
  return column;
}

/// What the tide of a record has left to the memory. Constituents that lie that near to the
/// inertial frequency are of one species: one line of their power, with the speed of the strongest.
std::optional<NearInertialLine> near_inertial_line(const FittedTide& tide, Angle latitude) {
  NearInertialLine line;
  double strongest_m_s = 0;
  for (const TideFit& level : tide.levels) {
    double power = 0;
    for (const TideTerm& term : level.terms) {
      power += term.left_out_m_s * term.left_out_m_s;
      if (term.left_out_m_s <= strongest_m_s) continue;
      strongest_m_s = term.left_out_m_s;
      line.speed_rad_s = latitude.radians() > 0 ? -term.speed_rad_s : term.speed_rad_s;
    }
    line.modulus_m_s.push_back(std::sqrt(power));
  }
  if (strongest_m_s <= 0) return std::nullopt;
  return line;
}

std::optional<LayerFigure> figure_of(const LayerOfDays& layer, UtcDay day) {
  const auto found = layer.find(day);
  if (found == layer.end()) return std::nullopt;
  return found->second;
}

bool has_any(const VectorColumn& column) {
  return std::any_of(column.status.begin(), column.status.end(),
                     [](SampleStatus status) { return has_value(status); });
}

}  // namespace

std::size_t ColumnCalibration::best() const {
  const std::vector<double> weight = form_weights(forms);
  return static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
}

std::vector<SteadyForm> forms_in(double water_depth_m, Angle latitude) {
  if (is_equatorial(latitude)) return {SteadyForm::finite_depth};
  if (default_form(water_depth_m, latitude) == SteadyForm::finite_depth)
    return {SteadyForm::finite_depth, SteadyForm::mixed_layer};
  return {SteadyForm::mixed_layer};
}

ColumnCalibration calibrate_column(const VectorColumn& known, const FittedTide& tide, UtcDay day,
                                   Angle latitude, double water_depth_m,
                                   const std::optional<VectorColumn>& wind,
                                   const LayerOfDays& layer, const std::vector<double>& noise_m_s) {
  ColumnCalibration result;
  expects(noise_m_s.empty() || noise_m_s.size() == known.value.size(),
          "a stated noise for each value, or none");
  ScalarColumn noise{known.point, known.time,   known.vertical, known.levels_m,
                     noise_m_s,   known.status, known.source};
  CalibrationInput input;
  input.latitude = latitude;
  input.water_depth_m = water_depth_m;
  input.wind = wind;
  input.is_unsteady = true;
  const std::optional<NearInertialLine> line = near_inertial_line(tide, latitude);
  for (const SteadyForm form : forms_in(water_depth_m, latitude)) {
    input.form = form;
    std::vector<KnownParameter> learnt;
    UtcDay taught{};
    for (int before = chain_days; before >= 0; --before) {
      const UtcDay today = day - days(before);
      input.current = without_tide(slice(known, UtcTime(today), UtcTime(today) + days(1)), tide);
      if (!has_any(input.current)) {
        if (before == 0) result.problem = "no current of " + format_day(day) + " has a value";
        continue;
      }
      if (!noise_m_s.empty())
        input.noise_m_s = slice(noise, UtcTime(today), UtcTime(today) + days(1)).value;
      input.known = with_layer(learnt, figure_of(layer, taught), figure_of(layer, today));
      // One form that fails, on one day, does not stop the others.
      const auto failure = attempt([&] {
        Calibration fitted = calibrate_day(input);
        learnt = aged(fitted, 1.0);
        taught = today;
        fitted.near_inertial = line;
        if (before == 0) result.forms.push_back(std::move(fitted));
      });
      if (failure && before == 0) result.problem = failure->why;
    }
  }
  return result;
}

}  // namespace slackwater::calibration
