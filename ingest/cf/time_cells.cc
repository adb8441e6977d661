#include "ingest/cf/time_cells.h"

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/axes.h"
#include "ingest/cf/cell_methods.h"
#include "ingest/cf/dataset_period.h"
#include "ingest/cf/settle.h"
#include "ingest/cf/time_code.h"

namespace slackwater::ingest {
namespace {

[[noreturn]] void refuse_time(const netcdf::Variable& time, const std::string& why) {
  throw Error(ErrorKind::invalid_input, "time axis '" + time.name + "': " + why);
}

/// Whether cell_methods says this of time, under the name of the axis or "time".
bool says_method(const netcdf::Variable& data, const netcdf::Variable& time,
                 const std::string& method) {
  return has_method(cell_methods_of(data.text("cell_methods").value_or("")),
                    {"time", lower_case(time.name)}, method);
}

constexpr Duration one_day = std::chrono::hours(24);

TimeCell month_of(UtcTime stamp) {
  const std::chrono::year_month_day date(day_of(stamp));
  const auto first = date.year() / date.month() / std::chrono::day(1);
  return {UtcTime(std::chrono::sys_days(first)),
          UtcTime(std::chrono::sys_days(first + std::chrono::months(1)))};
}

/// Stamps of single precision are some seconds off.
Duration stamp_slack(Duration step) { return step / 8; }

/// The step of the clock, counted from 00:00 UTC, that a stamp at its start or in it speaks of.
TimeCell step_around(UtcTime stamp, Duration step) {
  const auto since = stamp.time_since_epoch() + stamp_slack(step);
  auto steps = since / step;
  if (since < Duration::zero() && since % step != Duration::zero()) --steps;
  return {UtcTime(steps * step), UtcTime((steps + 1) * step)};
}

TimeCell mean_of(UtcTime stamp, const MeanRule& rule) {
  switch (rule.label) {
    case MeanLabel::centre:
      return {stamp - rule.step / 2, stamp - rule.step / 2 + rule.step};
    case MeanLabel::start:
      return {stamp, stamp + rule.step};
    case MeanLabel::end:
      return {stamp - rule.step, stamp};
    case MeanLabel::utc_step:
      return step_around(stamp, rule.step);
    case MeanLabel::utc_month:
      return month_of(stamp);
    case MeanLabel::utc_day:
      break;
  }
  const UtcTime midnight = day_of(stamp);
  return {midnight, midnight + rule.step};
}

bool is_near(UtcTime a, UtcTime b, Duration step) {
  return a - b <= stamp_slack(step) && b - a <= stamp_slack(step);
}

/// Whether each stamp is the start of its step of the clock.
bool begin_their_steps(const std::vector<UtcTime>& stamps, Duration step) {
  return std::all_of(stamps.begin(), stamps.end(), [&](UtcTime stamp) {
    return is_near(stamp, step_around(stamp, step).start, step);
  });
}

/// The smallest distance of two stamps; nothing of one stamp.
std::optional<Duration> spacing_of(const std::vector<UtcTime>& stamps) {
  std::optional<Duration> spacing;
  for (std::size_t t = 1; t < stamps.size(); ++t) {
    const Duration step = stamps[t] - stamps[t - 1];
    spacing = std::min(spacing.value_or(step), step);
  }
  return spacing;
}

bool is_a_month(Duration spacing) { return spacing >= shortest_month && spacing <= longest_month; }

/// Whether stamps so far apart are what a rule speaks of; a few seconds are rounding.
bool have_spacing(Duration found, Duration stated) {
  if (is_a_month(stated)) return is_a_month(found);
  return found - stated <= stamp_slack(stated) && stated - found <= stamp_slack(stated);
}

bool is_for(const MeanRule& rule, const netcdf::Variable& data) {
  return rule.variables.empty() ||
         std::find(rule.variables.begin(), rule.variables.end(), data.name) != rule.variables.end();
}

const MeanRule* rule_for(const netcdf::File& file, const netcdf::Variable& data,
                         const Product& product) {
  for (const MeanRule& rule : product.means) {
    if (rule.attribute.empty() || !is_for(rule, data)) continue;
    const auto text = file.text(rule.attribute);
    if (text && contains_ignoring_case(*text, rule.contains)) return &rule;
  }
  return nullptr;
}

const MeanRule* rule_by_spacing(Duration spacing, const netcdf::Variable& data,
                                const Product& product) {
  for (const MeanRule& rule : product.means) {
    if (rule.attribute.empty() && is_for(rule, data) && have_spacing(spacing, rule.spacing))
      return &rule;
  }
  return nullptr;
}

/// Whether a product has means so near together that they may be taken for instants.
bool has_means_within_a_day(const netcdf::Variable& data, const Product& product) {
  return std::any_of(product.means.begin(), product.means.end(), [&](const MeanRule& rule) {
    return rule.attribute.empty() && rule.spacing < one_day && is_for(rule, data);
  });
}

/// What the name of the dataset says, in the file or else in the file's name, where the stamps do
/// not belie it: a file made from another one keeps the name of its source.
std::optional<DatasetPeriod> period_of(const netcdf::File& file,
                                       const std::optional<Duration>& spacing) {
  for (const auto& period : {stated_period(file), period_in(file.path().filename().string())}) {
    if (!period) continue;
    const Duration step = period->is_month ? shortest_month : period->step;
    if (!spacing || have_spacing(*spacing, step)) return period;
  }
  return std::nullopt;
}

MeanRule rule_of(const DatasetPeriod& period) {
  MeanRule rule;
  rule.step = period.step;
  rule.label = period.is_month          ? MeanLabel::utc_month
               : period.step == one_day ? MeanLabel::utc_day
                                        : MeanLabel::utc_step;
  return rule;
}

/// Copernicus' own program for cuts names itself, and stamps means at their start.
bool is_of_toolbox(const netcdf::File& file) {
  return file.text("copernicusmarine_version").has_value();
}

std::string length_of(const TimeCell& cell) {
  return std::to_string((cell.end - cell.start).count() / 60000) + " min";
}

/// What is meant where a file says "mean" and gives no interval.
MeanRule rule_without_bounds(const netcdf::File& file, const std::vector<UtcTime>& stamps,
                             Duration spacing) {
  MeanRule rule;
  rule.step = spacing;
  const bool on_a_clock = one_day % spacing == Duration::zero();
  if (is_a_month(spacing)) {
    rule.label = MeanLabel::utc_month;
  } else if (spacing == one_day && begin_their_steps(stamps, spacing)) {
    rule.label = MeanLabel::utc_day;  // nobody averages from noon to noon
  } else if (on_a_clock && is_of_toolbox(file) && begin_their_steps(stamps, spacing)) {
    rule.label = MeanLabel::start;
  }
  return rule;
}

constexpr const char* say_the_label =
    "; if not so, say it: `means` with a `label` in a descriptor, ingest --product FILE.yaml "
    "(api/docs/adding_a_product.md)";

std::vector<UtcTime> decode_all(const TimeCode& code, const std::vector<double>& values,
                                const netcdf::Variable& time) {
  std::vector<UtcTime> stamps;
  stamps.reserve(values.size());
  for (std::size_t t = 0; t < values.size(); ++t) {
    stamps.push_back(with_context("time axis '" + time.name + "', index " + std::to_string(t),
                                  [&] { return code.decode(values[t]); }));
  }
  return stamps;
}

std::vector<TimeCell> cells_from_bounds(const netcdf::File& file, const netcdf::Variable& time,
                                        const netcdf::Variable& bounds,
                                        const std::vector<UtcTime>& stamps,
                                        const TimeCode& time_code, const Product& product,
                                        std::vector<std::string>& warnings) {
  if (bounds.size() != 2 * stamps.size()) {
    refuse_time(time, "its bounds '" + bounds.name + "' hold " + std::to_string(bounds.size()) +
                          " values; expected 2 for each of " + std::to_string(stamps.size()) +
                          " times");
  }
  TimeCode code = time_code;
  if (const auto own = bounds.text("units")) {
    code = TimeCode::parse(
        *own, bounds.text("calendar").value_or(time.text("calendar").value_or("")), warnings);
  }
  const std::vector<UtcTime> edges =
      decode_all(code, coordinate_values(file, bounds, product, ""), bounds);
  std::vector<TimeCell> cells;
  for (std::size_t t = 0; t < stamps.size(); ++t) {
    const TimeCell cell{edges[2 * t], edges[2 * t + 1]};
    if (cell.end < cell.start) {
      refuse_time(bounds, "interval " + std::to_string(t) + " ends (" + format_utc(cell.end) +
                              ") before it starts (" + format_utc(cell.start) + ")");
    }
    if (t > 0 && cell.centre() <= cells.back().centre())
      refuse_time(bounds, "intervals repeat at index " + std::to_string(t));
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace

std::vector<TimeCell> time_cells(const netcdf::File& file, const netcdf::Variable& time,
                                 const netcdf::Variable& data, const Product& product,
                                 std::vector<std::string>& warnings) {
  const auto units = product.attribute(time, "units");
  if (!units)
    refuse_time(time, std::string("has no units; expected e.g. 'hours since 1950-01-01'") + say_so);
  const TimeCode code = with_context("time axis '" + time.name + "'", [&] {
    return TimeCode::parse(*units, time.text("calendar").value_or(""), warnings);
  });
  const std::vector<UtcTime> stamps =
      decode_all(code, coordinate_values(file, time, product, ""), time);
  if (stamps.empty()) refuse_time(time, "is empty; expected at least one time");
  check_stamps(stamps, warnings);

  const std::optional<Duration> spacing = spacing_of(stamps);

  std::vector<TimeCell> cells;
  const auto instants = [&] {
    std::transform(stamps.begin(), stamps.end(), std::back_inserter(cells), TimeCell::instant);
    return cells;
  };
  const auto means = [&](const MeanRule& rule, const std::string& because) {
    for (const UtcTime stamp : stamps) {
      const TimeCell cell = mean_of(stamp, rule);
      if (!cells.empty() && cell.centre() <= cells.back().centre()) {
        const bool is_daily = rule.label == MeanLabel::utc_day;
        refuse_time(time, (is_daily ? "two daily means fall on " : "two means fall on ") +
                              (is_daily ? format_day(day_of(stamp)) : format_utc(cell.start)) +
                              (is_daily ? "; expected one a day" : "; expected one an interval"));
      }
      const UtcTime middle = cell.start + (cell.end - cell.start) / 2;
      if (rule.label == MeanLabel::utc_step && !is_near(stamp, cell.start, rule.step) &&
          !is_near(stamp, middle, rule.step)) {
        refuse_time(time, "a mean over " + length_of(cell) + " is stamped " + format_utc(stamp) +
                              "; expected the start or the middle of its interval" + say_so);
      }
      cells.push_back(cell);
    }
    const bool at_start = rule.label == MeanLabel::utc_step && begin_their_steps(stamps, rule.step);
    if (at_start || !because.empty()) {
      warnings.push_back(
          "time axis '" + time.name + "' holds means" + because +
          (at_start ? ", stamped at the start of their interval as the Copernicus Marine toolbox "
                      "does"
                    : "") +
          ": the first is taken as " + format_utc(cells.front().start) + " to " +
          format_utc(cells.front().end) + say_the_label);
    }
    return cells;
  };
  if (says_method(data, time, "point")) return instants();
  if (const auto name = time.text("bounds")) {
    if (const netcdf::Variable* bounds = file.find(*name)) {
      return cells_from_bounds(file, time, *bounds, stamps, code, product, warnings);
    }
    warnings.push_back("time axis '" + time.name + "' names bounds '" + *name +
                       "' that the file does not hold");
  }
  if (const MeanRule* rule = rule_for(file, data, product)) return means(*rule, "");
  if (const auto period = period_of(file, spacing))
    return period->is_mean ? means(rule_of(*period), "") : instants();

  const bool says_mean = says_method(data, time, "mean");
  if (spacing) {
    if (const MeanRule* rule = rule_by_spacing(*spacing, data, product)) {
      return means(*rule, says_mean ? ""
                                    : " (of product '" + product.id +
                                          "' by the distance of its stamps; the file does not "
                                          "say)");
    }
  }
  if (says_mean) {
    if (!spacing) {
      refuse_time(
          time,
          "one mean without bounds: its interval is unknown; expected time bounds, or a product "
          "descriptor with a mean rule");
    }
    return means(rule_without_bounds(file, stamps, *spacing), " without bounds");
  }
  if (has_means_within_a_day(data, product)) {
    if (!spacing) {
      refuse_time(time,
                  "one stamp, " + format_utc(stamps.front()) + ", and product '" + product.id +
                      "' has instants and means; expected two times or more, or the name of the "
                      "dataset in the file or its name (cmems_mod_…_PT1H-m.nc)" +
                      say_so);
    }
    if (*spacing > std::chrono::hours(1)) {
      warnings.push_back("time axis '" + time.name + "' is taken as instants: product '" +
                         product.id + "' has no means so far apart" + say_the_label);
    }
  } else if (is_of_toolbox(file) && product.id == "cf") {
    warnings.push_back("time axis '" + time.name +
                       "' comes from the Copernicus Marine toolbox, and nothing says whether it "
                       "holds instants or means; taken as instants: keep the name of the dataset "
                       "in the file's name (cmems_mod_…_PT1H-m.nc)" +
                       say_the_label);
  }
  return instants();
}

}  // namespace slackwater::ingest
