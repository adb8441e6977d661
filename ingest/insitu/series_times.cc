#include "ingest/insitu/series_times.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "ingest/cf/packing.h"
#include "ingest/cf/time_code.h"
#include "ingest/insitu/series_values.h"

namespace slackwater::ingest {
namespace {

void warn_of_stamps_before_deployment(const netcdf::File& file, const SeriesTimes& times,
                                      std::vector<std::string>& warnings) {
  for (const char* attribute : {"anchor_drop_time", "time_deployment_start"}) {
    const auto deployed = find_date(file.text(attribute).value_or(""));
    if (!deployed || times.cells.front().start > *deployed - std::chrono::hours(24)) continue;
    warnings.push_back("stamps begin " + format_utc(times.cells.front().start) +
                       ", before the deployment of " + format_utc(*deployed) + " (" + attribute +
                       "): kept as they are; only differences between times are certain");
    return;
  }
}

}  // namespace

SeriesTimes series_times_of(const netcdf::File& file, const StationAxes& axes,
                            std::vector<std::string>& warnings) {
  return with_context("time axis '" + axes.time->name + "'", [&] {
    const TimeCode code = TimeCode::parse(axes.time->text("units").value_or(""),
                                          axes.time->text("calendar").value_or(""), warnings);
    std::vector<std::string> ignored;
    const Packing packing = Packing::of(*axes.time, ignored);
    std::vector<double> values = file.read_all(*axes.time);
    if (values.empty())
      throw Error(ErrorKind::invalid_input, "is empty; expected at least one time");

    std::vector<SampleStatus> flags;
    const netcdf::Variable* flag_variable = flag_variable_of(file, *axes.time);
    if (flag_variable != nullptr && flag_variable->size() == values.size())
      flags = flags_of(file, *flag_variable);

    const double seconds_to_middle =
        axes.time->number("seconds_to_middle_of_measurement").value_or(std::nan(""));
    const double average_s = global_number(file, "instrument_average_interval").value_or(0.0);
    const bool averages =
        std::abs(seconds_to_middle) <= 86400.0 && average_s > 0.0 && average_s <= 86400.0;

    SeriesTimes times;
    std::vector<UtcTime> stamps;
    for (std::size_t t = 0; t < values.size(); ++t) {
      const double value = packing.coordinate(values[t]);
      const bool usable = std::isfinite(value) && (flags.empty() || has_value(flags[t]));
      times.usable.push_back(usable);
      const UtcTime stamp = usable ? code.decode(value) : UtcTime{};
      if (usable) stamps.push_back(stamp);
      const auto ms = [](double seconds) { return Duration(std::llround(seconds * 1000.0)); };
      times.cells.push_back(averages ? TimeCell{stamp + ms(seconds_to_middle - 0.5 * average_s),
                                                stamp + ms(seconds_to_middle + 0.5 * average_s)}
                                     : TimeCell::instant(stamp));
    }
    if (stamps.empty())
      throw Error(ErrorKind::invalid_input, "has no usable time: all are missing or flagged bad");
    check_stamps(stamps, ignored);
    if (stamps.size() < values.size()) {
      warnings.push_back("left out " + std::to_string(values.size() - stamps.size()) +
                         " times that are missing or flagged bad");
    }
    if (averages) {  // overlapping averages would count water twice: then the middles stand for
                     // them
      UtcTime last_end = UtcTime::min();
      bool overlap = false;
      for (std::size_t t = 0; t < times.cells.size(); ++t) {
        if (!times.usable[t]) continue;
        overlap |= times.cells[t].start < last_end;
        last_end = times.cells[t].end;
      }
      if (overlap) {
        for (TimeCell& cell : times.cells) cell = TimeCell::instant(cell.centre());
      }
    }
    const auto first =
        std::find(times.usable.begin(), times.usable.end(), true) - times.usable.begin();
    if (first == 0) warn_of_stamps_before_deployment(file, times, warnings);
    return times;
  });
}

}  // namespace slackwater::ingest
