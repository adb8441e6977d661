#include "ingest/cf/time_cells.h"

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/axes.h"
#include "ingest/cf/settle.h"
#include "ingest/cf/time_code.h"

namespace slackwater::ingest {
namespace {

[[noreturn]] void refuse(const netcdf::Variable& time, const std::string& why) {
  throw Error(ErrorKind::invalid_input, "time axis '" + time.name + "': " + why);
}

/// Whether cell_methods says "time: METHOD", whatever the blanks, under the name of the axis or
/// "time".
bool says_method(const netcdf::Variable& data, const netcdf::Variable& time,
                 const std::string& method) {
  std::string text = lower_case(data.text("cell_methods").value_or(""));
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text.find("time:" + method) != std::string::npos ||
         text.find(lower_case(time.name) + ":" + method) != std::string::npos;
}

TimeCell mean_of(UtcTime stamp, const MeanRule& rule) {
  switch (rule.label) {
    case MeanLabel::centre:
      return {stamp - rule.step / 2, stamp - rule.step / 2 + rule.step};
    case MeanLabel::start:
      return {stamp, stamp + rule.step};
    case MeanLabel::end:
      return {stamp - rule.step, stamp};
    case MeanLabel::utc_day:
      break;
  }
  const UtcTime midnight = day_of(stamp);
  return {midnight, midnight + rule.step};
}

const MeanRule* rule_for(const netcdf::File& file, const Product& product) {
  for (const MeanRule& rule : product.means) {
    const auto text = file.text(rule.attribute);
    if (text && contains_ignoring_case(*text, rule.contains)) return &rule;
  }
  return nullptr;
}

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
    refuse(time, "its bounds '" + bounds.name + "' hold " + std::to_string(bounds.size()) +
                     " values; expected 2 for each of " + std::to_string(stamps.size()) + " times");
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
      refuse(bounds, "interval " + std::to_string(t) + " ends (" + format_utc(cell.end) +
                         ") before it starts (" + format_utc(cell.start) + ")");
    }
    if (t > 0 && cell.centre() <= cells.back().centre())
      refuse(bounds, "intervals repeat at index " + std::to_string(t));
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
    refuse(time, std::string("has no units; expected e.g. 'hours since 1950-01-01'") + say_so);
  const TimeCode code = with_context("time axis '" + time.name + "'", [&] {
    return TimeCode::parse(*units, time.text("calendar").value_or(""), warnings);
  });
  const std::vector<UtcTime> stamps =
      decode_all(code, coordinate_values(file, time, product, ""), time);
  if (stamps.empty()) refuse(time, "is empty; expected at least one time");
  check_stamps(stamps, warnings);

  std::vector<TimeCell> cells;
  const auto instants = [&] {
    std::transform(stamps.begin(), stamps.end(), std::back_inserter(cells), TimeCell::instant);
    return cells;
  };
  const auto means = [&](const MeanRule& rule) {
    for (const UtcTime stamp : stamps) {
      const TimeCell cell = mean_of(stamp, rule);
      if (!cells.empty() && cell.centre() <= cells.back().centre()) {
        refuse(time,
               "two daily means fall on " + format_day(day_of(stamp)) + "; expected one a day");
      }
      cells.push_back(cell);
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
  if (const MeanRule* rule = rule_for(file, product)) return means(*rule);
  if (says_method(data, time, "mean")) {
    if (stamps.size() < 2) {
      refuse(time,
             "one mean without bounds: its interval is unknown; expected time bounds, or a product "
             "descriptor with a mean rule");
    }
    Duration step = stamps[1] - stamps[0];
    for (std::size_t t = 2; t < stamps.size(); ++t)
      step = std::min(step, stamps[t] - stamps[t - 1]);
    warnings.push_back("'" + data.name +
                       "' holds means without bounds; taken as centred on the stamps, " +
                       std::to_string(step.count() / 60000) + " min long");
    return means({"", "", step, MeanLabel::centre});
  }
  return instants();
}

}  // namespace slackwater::ingest
