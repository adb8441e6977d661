#include "api/ask/vehicle/fit_trial.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "api/ask/vehicle/scalar_keys.h"
#include "fields/base/advice.h"
#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/run/printable.h"
#include "twin/vehicle/vehicle_of.h"

namespace slackwater::api {
namespace {

constexpr double widest = 10;                ///< times and part of the file's value
constexpr std::size_t most_fit_rows = 5000;  ///< of a column

/// A vehicle's file, and what it would be with other numbers.
class ChangeableVehicle {
 public:
  ChangeableVehicle(const std::filesystem::path& file, const std::filesystem::path& data_folder)
      : file_(file.string()), data_folder_(data_folder) {
    const Config config = Config::load(file);
    places_ = config.places();
    keys_ = config.value();
  }
  [[nodiscard]] twin::Vehicle as_it_is() const { return twin::read_vehicle(file_, data_folder_); }
  [[nodiscard]] twin::Vehicle with(const std::vector<calibration::FreeParameter>& parameters,
                                   std::span<const double> values) const {
    YamlValue changed = keys_;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      changed = with_number(changed, parameters[i].name, values[i]);
    return twin::vehicle_of(Config::of(changed, file_), data_folder_);
  }
  /// Checked.
  [[nodiscard]] calibration::FreeParameter parameter(const std::string& key) const {
    const auto value = number_at(keys_, key);
    if (!value) refuse_unknown(key);
    if (key == "largest_step_s")
      refuse_key(key, "it is of the calculation and not of the vehicle; leave it out");
    if (*value == 0)
      refuse_key(key,
                 "found 0, and a fit stays between a tenth and ten times the file's value; give "
                 "the file a first value that is not 0");
    const double one = *value / widest, other = *value * widest;
    calibration::FreeParameter free{key, *value, std::min(one, other), std::max(one, other)};
    expect_movable(free);
    return free;
  }

 private:
  [[noreturn]] void refuse_key(const std::string& key, const std::string& why) const {
    refuse(places_.of(key) + ": " + key + ": " + why);
  }
  /// What a hair of change makes no vehicle: a count, or a number that a rule ties to others.
  void expect_movable(const calibration::FreeParameter& free) const {
    try {
      constexpr double hair = 1e-3;
      const double near = free.start * (1 + hair);
      static_cast<void>(with({free}, std::span(&near, 1)));
    } catch (const Error& error) {
      refuse_key(free.name, formatted("cannot be fitted: with {:g} in its place the file is "
                                      "refused ({}); leave it out",
                                      free.start * 1.001, error.message()));
    }
  }
  [[noreturn]] void refuse_unknown(const std::string& key) const {
    std::vector<std::string> known, near;
    const std::string above = key.substr(0, key.find_first_of(".[") + 1);
    for (const ScalarKey& scalar : scalar_keys(keys_)) {
      known.push_back(scalar.key);
      if (above.size() > 1 && scalar.key.starts_with(above)) near.push_back(scalar.key);
    }
    constexpr std::size_t enough = 30;
    if (near.empty()) near = known;
    const std::size_t more = near.size() > enough ? near.size() - enough : 0;
    near.resize(near.size() - more);
    refuse(formatted("{}: found no number under the key '{}'{}; it has {}{}", file_,
                     twin::printable(key, 60), did_you_mean(key, known), joined(near, ", "),
                     more > 0 ? formatted(" and {} more", more) : std::string()));
  }

  std::string file_;
  std::filesystem::path data_folder_;
  KeyPlaces places_;
  YamlValue keys_;
};

/// The same angle, counted on from row to row.
std::vector<double> unwound(const std::vector<double>& values, twin::TrialQuantity quantity) {
  std::vector<double> out = values;
  if (!twin::is_angle(quantity)) return out;
  double before = constants::nan;
  for (double& value : out) {
    if (!std::isfinite(value)) continue;
    if (std::isfinite(before)) value = before + twin::off_by(quantity, value, before);
    before = value;
  }
  return out;
}

/// A trial as residuals: ours less theirs, each column divided by its range.
class TrialResiduals {
 public:
  explicit TrialResiduals(const twin::Trial& trial)
      : trial_(trial), every_((trial.rows() + most_fit_rows - 1) / most_fit_rows) {
    for (std::size_t column = 0; column < trial.measured.size(); ++column) {
      const twin::TrialColumn& measured = trial.measured[column];
      const double range = twin::range_of(measured);
      theirs_.push_back(unwound(measured.value, measured.quantity));
      range_.push_back(range);
      if (!(range > 0)) {
        left_out_.push_back(measured.quantity);
        continue;
      }
      bool has_any = false;
      for (std::size_t row = every_; row < trial.rows(); row += every_) {
        if (!std::isfinite(measured.value[row])) continue;
        place_.push_back({series_.size(), row / every_});
        column_.push_back(column);
        has_any = true;
      }
      if (has_any) series_.push_back(column);
    }
    if (place_.empty())
      refuse(trial.name +
             ": no measured column changes in the course of the trial, so that nothing can be "
             "fitted to it; expected a trial in which the vehicle moves");
  }

  /// False where our run did not come to the end.
  [[nodiscard]] bool fill(const twin::Vehicle& vehicle, std::span<double> out) const {
    const twin::TrialRun run = twin::replayed(vehicle, trial_);
    if (run.diverged(trial_)) return false;
    std::vector<std::vector<double>> ours;
    std::vector<double> turns;
    for (std::size_t column = 0; column < trial_.measured.size(); ++column) {
      const twin::TrialQuantity quantity = trial_.measured[column].quantity;
      ours.push_back(unwound(run.ours[column], quantity));
      turns.push_back(turns_between(ours.back(), theirs_[column], quantity));
    }
    for (std::size_t i = 0; i < place_.size(); ++i) {
      const std::size_t column = column_[i], row = place_[i].row * every_;
      out[i] = (ours[column][row] - theirs_[column][row] - turns[column]) / range_[column];
    }
    return true;
  }
  [[nodiscard]] const std::vector<calibration::ResidualPlace>& place() const { return place_; }
  [[nodiscard]] const std::vector<twin::TrialQuantity>& left_out() const { return left_out_; }
  [[nodiscard]] std::size_t every_row() const { return every_; }

 private:
  /// The whole turns between two that begin beside each other.
  static double turns_between(const std::vector<double>& ours, const std::vector<double>& theirs,
                              twin::TrialQuantity quantity) {
    if (!twin::is_angle(quantity)) return 0;
    for (std::size_t row = 0; row < theirs.size(); ++row)
      if (std::isfinite(theirs[row]))
        return ours[row] - theirs[row] - twin::off_by(quantity, ours[row], theirs[row]);
    return 0;
  }

  const twin::Trial& trial_;
  std::size_t every_;
  std::vector<std::vector<double>> theirs_;  ///< by column
  std::vector<double> range_;
  std::vector<std::size_t> series_;  ///< the columns that are fitted to
  std::vector<std::size_t> column_;  ///< of each residual
  std::vector<calibration::ResidualPlace> place_;
  std::vector<twin::TrialQuantity> left_out_;
};

twin::TrialErrors errors_with(const twin::Vehicle& vehicle, const twin::Trial& trial) {
  const twin::TrialRun run = twin::replayed(vehicle, trial);
  if (run.diverged(trial))
    refuse(
        formatted("{}: the {} as its file has it diverges {:.4g} s into the trial, so that "
                  "nothing can be fitted; cut the trial before that, or look at the file",
                  trial.name, vehicle.name, run.ended_at_s - trial.time_s.front()));
  return twin::errors_of(trial, run);
}

}  // namespace

TrialFit fit_trial(const std::filesystem::path& vehicle_file,
                   const std::filesystem::path& data_folder, const twin::Trial& trial,
                   const std::vector<std::string>& keys, const calibration::FitOptions& options) {
  const ChangeableVehicle vehicle(vehicle_file, data_folder);
  if (keys.empty() || keys.size() > most_fitted_keys)
    refuse(formatted("found {} to be fitted, expected 1 to {}: damping.X_u,lift.N_ur",
                     counted(keys.size(), "key"), most_fitted_keys));
  std::vector<calibration::FreeParameter> parameters;
  for (const std::string& key : keys) {
    for (const calibration::FreeParameter& other : parameters)
      if (other.name == key)
        refuse(key + ": found it twice among what is to be fitted; once is enough");
    parameters.push_back(vehicle.parameter(key));
  }
  TrialFit out;
  out.before = errors_with(vehicle.as_it_is(), trial);
  const TrialResiduals residuals(trial);
  out.left_out = residuals.left_out();
  out.every_row = residuals.every_row();
  out.fit = calibration::fit_parameters(
      parameters, residuals.place(),
      [&](std::span<const double> values, std::span<double> into) {
        try {
          return residuals.fill(vehicle.with(parameters, values), into);
        } catch (const Error&) {
          return false;  // no vehicle: it sinks, or a rule between its numbers is broken
        }
      },
      options);
  std::vector<double> best;
  for (const calibration::FittedParameter& parameter : out.fit.parameters)
    best.push_back(parameter.value);
  out.after = errors_with(vehicle.with(parameters, best), trial);
  return out;
}

}  // namespace slackwater::api
