#include "api/ask/vehicle/read_trial.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "fields/base/advice.h"
#include "fields/base/constants.h"
#include "fields/base/encode/csv.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/text.h"
#include "twin/handling/command_name.h"
#include "twin/handling/replayed.h"
#include "twin/run/printable.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_trial_bytes = std::size_t{512} << 20U;
constexpr std::size_t most_trial_columns = 1000;
/// Of any number in a trial: eastings and northings of a grid are below it.
constexpr double most_trial_value = 1e8;

std::string shown(std::string_view text) {
  constexpr std::size_t enough = 60;
  return "'" + twin::printable(text, enough) + (text.size() > enough ? "...'" : "'");
}

/// What stands in a column.
struct Role {
  enum class Kind { none, time, measured, command };
  Kind kind = Kind::none;
  std::string name;       ///< as the file has it, for messages
  std::size_t index = 0;  ///< among the measured columns, or the commands
  double si = 1;
};

class TrialReader {
 public:
  TrialReader(std::string_view text, const std::string& name, const twin::Vehicle& vehicle,
              const TrialOptions& options)
      : rest_(text), file_(name), vehicle_(vehicle), options_(options) {
    trial_.name = name;
    trial_.current_m_s = options.current_m_s;
    trial_.first_depth_m = options.first_depth_m;
  }

  twin::Trial read() {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // what spreadsheets put there
    if (!next_line()) refuse_here("found no line of column names; the file is empty");
    read_names();
    while (next_line()) read_row();
    expect_enough();
    return std::move(trial_);
  }

 private:
  [[noreturn]] void refuse_here(const std::string& why) const {
    refuse(formatted("{}:{}: {}", file_, std::max<std::size_t>(line_number_, 1), why));
  }

  /// The next line with something on it.
  bool next_line() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      line_ = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++line_number_;
      if (line_.find('\0') != std::string_view::npos)
        refuse_here("found bytes that are no text, expected comma-separated values");
      if (!line_.empty() && line_.front() != '#') return true;
    }
    return false;
  }

  void split() {
    cells_.clear();
    if (line_.find('"') == std::string_view::npos) {
      for (std::size_t from = 0;;) {
        const std::size_t comma = line_.find(',', from);
        cells_.push_back(trimmed(line_.substr(from, comma - from)));
        if (comma == std::string_view::npos) return;
        from = comma + 1;
      }
    }
    auto unquoted = csv_cells(line_);
    if (!unquoted) refuse_here("found a quote that is not closed; expected \" in pairs");
    unquoted_ = std::move(*unquoted);
    cells_.assign(unquoted_.begin(), unquoted_.end());
  }

  void read_names() {
    split();
    if (cells_.size() == 1 && line_.find_first_of(";\t") != std::string_view::npos)
      refuse_here("found " + shown(line_) +
                  ", expected names of columns with commas between them; semicolons and tabs are "
                  "not read");
    if (cells_.size() > most_trial_columns)
      refuse_here(
          formatted("found {} columns, expected at most {}", cells_.size(), most_trial_columns));
    const std::vector<std::string_view> names(cells_);
    for (const TrialColumnName& given : options_.columns)
      if (std::find(names.begin(), names.end(), given.column) == names.end())
        refuse_here("found no column " + shown(given.column) + ", which is to be " +
                    shown(given.name) + "; it has " + listed(names));
    for (const std::string_view name : names) roles_.push_back(role_of(name));
    const auto is_there = [&](Role::Kind kind) {
      return std::any_of(roles_.begin(), roles_.end(),
                         [&](const Role& role) { return role.kind == kind; });
    };
    if (!is_there(Role::Kind::time))
      refuse_here(
          "found no column of times; expected t_s or time_s, seconds that rise: name the "
          "column of times so, or say --column NAME=t_s");
    if (!is_there(Role::Kind::command))
      refuse_here("found no column of commands of the " + vehicle_.name +
                  ", which would stand still; expected one of " +
                  joined(twin::command_names(vehicle_), ", "));
    if (!is_there(Role::Kind::measured))
      refuse_here("found nothing that was measured; expected one of " +
                  joined(twin::measured_names(), ", "));
  }

  static std::string listed(const std::vector<std::string_view>& names) {
    std::vector<std::string> all;
    all.reserve(names.size());
    for (const std::string_view name : names) all.push_back(shown(name));
    return joined(all, ", ");
  }

  Role role_of(std::string_view column) {
    const auto given =
        std::find_if(options_.columns.begin(), options_.columns.end(),
                     [&](const TrialColumnName& one) { return one.column == column; });
    const std::string_view name = given == options_.columns.end() ? column : given->name;
    Role role{Role::Kind::none, twin::printable(column, 60), 0, 1};
    if (name == "none" && given != options_.columns.end()) return role;
    if (name == "t_s" || name == "time_s") {
      role.kind = Role::Kind::time;
      if (has_time_) refuse_twice(column, "times");
      has_time_ = true;
    } else if (const auto measured_as = twin::measured_name(name)) {
      role = {Role::Kind::measured, role.name, trial_.measured.size(), measured_as->si};
      if (twin::measured(trial_, measured_as->quantity) != nullptr)
        refuse_twice(column, twin::name_of(measured_as->quantity));
      trial_.measured.push_back({measured_as->quantity, {}});
    } else if (const auto told = twin::command_name(vehicle_, name)) {
      role = {Role::Kind::command, role.name, trial_.commands.size(), told->si};
      for (const twin::TrialCommand& other : trial_.commands)
        if (other.channel == told->channel)
          refuse_twice(column, twin::channel_of(vehicle_, told->channel)->name);
      trial_.commands.push_back({told->channel, told->is_share, {}});
    } else {
      refuse_unknown(column, name);
    }
    return role;
  }

  [[noreturn]] void refuse_twice(std::string_view column, std::string_view of) const {
    refuse_here("column " + shown(column) + ": found a second column of " + std::string(of) +
                "; leave one of them out: --column NAME=none");
  }
  [[noreturn]] void refuse_unknown(std::string_view column, std::string_view name) const {
    const std::vector<std::string> quantities = twin::measured_names();
    const std::vector<std::string> commands = twin::command_names(vehicle_);
    std::vector<std::string> known{"t_s"};
    known.insert(known.end(), quantities.begin(), quantities.end());
    known.insert(known.end(), commands.begin(), commands.end());
    const std::string as = name == column ? "" : " as " + shown(name);
    refuse_here("column " + shown(column) + as + ": we do not know it" +
                did_you_mean(twin::printable(name, 60), known) + "; measured are " +
                joined(quantities, ", ") + "; commands of the " + vehicle_.name + " are " +
                joined(commands, ", ") + ". Say --column " + twin::printable(column, 60) +
                "=NAME, or =none to leave it out");
  }

  /// NaN for a cell without a value.
  double number_in(std::string_view cell, const Role& role) const {
    std::string_view digits = cell;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, problem] = std::from_chars(digits.data(), end, value);
    if (problem == std::errc{} && stop == end && !digits.empty() && !std::isnan(value)) {
      if (std::abs(value) <= most_trial_value) return value;
      refuse_here(formatted("{}: found {}, expected a number of at most {:g}", role.name,
                            shown(cell), most_trial_value));
    }
    const std::string lower = lower_case(cell);
    for (const char* const nothing : {"", "nan", "na", "-"})
      if (lower == nothing) return constants::nan;
    const auto meant = with_decimal_point(cell);
    refuse_here(role.name + ": found " + shown(cell) + ", expected a number" +
                (meant ? " with a decimal point, as " + *meant
                       : "; a cell without a value is empty or NaN"));
  }

  void put_time(double t_s, const Role& role) {
    std::vector<double>& times = trial_.time_s;
    if (std::isnan(t_s)) refuse_here(role.name + ": found a row without its time; give it one");
    if (!times.empty() && !(t_s > times.back()))
      refuse_here(
          formatted("{}: found {:.15g} after {:.15g}, expected times that rise: sort the "
                    "rows, and keep one of those of the same time",
                    role.name, t_s, times.back()));
    times.push_back(t_s);
  }

  void put_command(double value, const Role& role) {
    twin::TrialCommand& command = trial_.commands[role.index];
    if (std::isnan(value)) {
      if (command.value.empty())
        refuse_here(role.name +
                    ": found no value in the first row, expected what it was told then");
      command.value.push_back(command.value.back());
      return;
    }
    const twin::ActuatorChannel channel = twin::channel_of(vehicle_, command.channel).value();
    const double physical = role.si * value;
    const double least = command.is_share ? -1 : channel.least;
    const double most = command.is_share ? 1 : channel.most;
    if (command.is_share ? std::abs(value) > 1 : !channel.reaches(physical))
      refuse_here(formatted(
          "{}: found {:g}, expected {:g} to {:g}, the limits of {} of the {}; "
          "check the unit",
          role.name, value, least / role.si, most / role.si, channel.name, vehicle_.name));
    command.value.push_back(std::clamp(physical, least, most));
  }

  void read_row() {
    split();
    if (cells_.size() != roles_.size())
      refuse_here(formatted("found {} cells, expected {} as in the line of names", cells_.size(),
                            roles_.size()));
    if (trial_.rows() == most_trial_rows)
      refuse_here(formatted("found more than {} rows; cut the trial, or keep fewer rows a second",
                            most_trial_rows));
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      const Role& role = roles_[i];
      if (role.kind == Role::Kind::none) continue;
      const double value = number_in(cells_[i], role);
      if (role.kind == Role::Kind::time) put_time(value, role);
      if (role.kind == Role::Kind::command) put_command(value, role);
      if (role.kind == Role::Kind::measured)
        trial_.measured[role.index].value.push_back(role.si * value);
    }
  }

  void expect_enough() const {
    if (trial_.rows() < 2)
      refuse_here(formatted("found {}, expected two at least: where it begins and what it did",
                            counted(trial_.rows(), "row")));
    const bool is_measured = std::any_of(
        trial_.measured.begin(), trial_.measured.end(), [](const twin::TrialColumn& column) {
          return std::any_of(column.value.begin() + 1, column.value.end(),
                             [](double value) { return std::isfinite(value); });
        });
    if (!is_measured)
      refuse_here("found no measured value below the first row, expected some to compare with");
    const double longest_s = twin::most_trial_steps * vehicle_.largest_step_s;
    if (!(trial_.lasts_s() <= longest_s))
      refuse_here(formatted(
          "found a trial of {:.3g} h, expected at most {:.3g} h of the {}, which "
          "is stepped every {:g} s; check that times are seconds, or cut it",
          trial_.lasts_s() / 3600, longest_s / 3600, vehicle_.name, vehicle_.largest_step_s));
  }

  std::string_view rest_;
  const std::string& file_;
  const twin::Vehicle& vehicle_;
  const TrialOptions& options_;
  std::string_view line_;
  std::size_t line_number_ = 0;
  std::vector<std::string_view> cells_;
  std::vector<std::string> unquoted_;
  std::vector<Role> roles_;
  bool has_time_ = false;
  twin::Trial trial_;
};

}  // namespace

TrialColumnName parse_trial_column(const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0 || at + 1 == text.size() ||
      text.find('=', at + 1) != std::string::npos)
    throw Error(
        ErrorKind::usage,
        "--column: found " + shown(text) +
            ", expected the file's name of a column and ours: stern_plane_rad=elevator_rad, "
            "or battery_v=none to leave it out");
  return {text.substr(0, at), text.substr(at + 1)};
}

twin::Trial trial_of(std::string_view text, const std::string& name, const twin::Vehicle& vehicle,
                     const TrialOptions& options) {
  return TrialReader(text, name, vehicle, options).read();
}

twin::Trial read_trial(const std::filesystem::path& file, const twin::Vehicle& vehicle,
                       const TrialOptions& options) {
  const std::string text = text_of_given_file(file, "a CSV file of a trial", most_trial_bytes);
  return trial_of(text, file.string(), vehicle, options);
}

}  // namespace slackwater::api
