#include "ingest/grib/inventory.h"

#include <algorithm>
#include <limits>

#include "fields/base/error.h"
#include "ingest/decoded/ingested.h"
#include "ingest/grib/statistic.h"

namespace slackwater::ingest::grib {
namespace {

UtcTime reference_time_of(const Message& message) {
  const long date = message.integer("dataDate");
  const long time = message.integer("dataTime");
  const std::chrono::year_month_day day{std::chrono::year(static_cast<int>(date / 10000)),
                                        std::chrono::month(static_cast<unsigned>(date / 100 % 100)),
                                        std::chrono::day(static_cast<unsigned>(date % 100))};
  const bool believable = date / 10000 >= 1600 && date / 10000 <= 2500;
  if (!believable || !day.ok() || time < 0 || time / 100 > 23 || time % 100 > 59) {
    throw Error(ErrorKind::invalid_input, message.name() + ": reference time " +
                                              std::to_string(date) + " " + std::to_string(time) +
                                              "; expected a date and a time of day");
  }
  return UtcTime(std::chrono::sys_days(day)) + std::chrono::hours(time / 100) +
         std::chrono::minutes(time % 100);
}

/// From the run to an end of the interval that the message speaks of; `stepUnits` is seconds.
std::chrono::seconds step_of(const Message& message, const char* key) {
  constexpr long longest_s = 10L * 366 * 86400;
  const long step_s = message.integer(key);
  if (step_s < -longest_s || step_s > longest_s) {
    throw Error(ErrorKind::invalid_input,
                message.name() + ": " + key + " is " + std::to_string(step_s) +
                    " s; expected at most ten years; the file is damaged");
  }
  return std::chrono::seconds(step_s);
}

/// The perturbation number of an ensemble member. GRIB 1 carries the key in deterministic runs too
/// (then 0 of 0).
std::optional<int> member_of(const Message& message) {
  const auto number = message.integer_if_any("perturbationNumber");
  if (!number) return std::nullopt;
  const bool counted = message.integer_if_any("numberOfForecastsInEnsemble").value_or(0) > 0;
  const std::string type = message.text_if_any("dataType").value_or("");
  if (*number <= 0 && !counted && type != "cf" && type != "pf") return std::nullopt;
  if (*number < 0 || *number > std::numeric_limits<int>::max()) return std::nullopt;
  return static_cast<int>(*number);
}

std::string list_of(const std::map<std::string, std::size_t>& counts) {
  std::string text;
  std::size_t named = 0;
  for (const auto& [name, count] : counts) {
    if (++named > 8) return text + ", ...";
    text += (text.empty() ? "" : ", ") + name + " (" + std::to_string(count) + ")";
  }
  return text;
}

/// The quantity of a field as an operator says it: "10v", or "v" where the library has no name.
std::string quantity_name(const Message& message, const Parameter& parameter) {
  const std::string name = message.text_if_any("shortName").value_or("unknown");
  return name == "unknown" ? std::string(parameter.short_name) : name;
}

}  // namespace

std::optional<TimeCell> valid_time_of(Message& message, const Parameter& parameter) {
  const std::string statistic = message.text_if_any("stepType").value_or("instant");
  message.set("stepUnits",
              13L);  // seconds (code table 4.4): every whole unit of GRIB becomes whole seconds
  const UtcTime run = reference_time_of(message);
  const UtcTime end = run + step_of(message, "endStep");
  const UtcTime start = run + step_of(message, "startStep");
  if (end < start) {
    throw Error(ErrorKind::invalid_input,
                message.name() + ": its interval ends before it begins; the file is damaged");
  }
  if (parameter.standard_name == "wind_speed_of_gust") {
    return statistic == "instant" || statistic == "max" ? std::optional(TimeCell::instant(end))
                                                        : std::nullopt;
  }
  if (statistic == "instant") return TimeCell::instant(end);
  if (statistic == "avg" || statistic == "mean") return TimeCell{start, end};
  return std::nullopt;
}

Inventory take_inventory(MessageFile& file, const std::optional<BoundingBox>& cut,
                         const std::function<void(std::uint64_t)>& on_bytes) {
  Inventory inventory;
  std::map<std::string, std::size_t> passed_over;
  std::map<std::string, std::size_t> statistics;
  std::size_t statistic_fields = 0;
  std::size_t means_of_members = 0;
  std::size_t gusts_over_intervals = 0;
  std::vector<std::byte> bytes;
  while (const auto found = file.next(bytes)) {
    FieldPosition position = *found;
    for (std::vector<std::byte>& field_bytes : split_fields(std::move(bytes), name_of(position))) {
      Message message(std::move(field_bytes), name_of(position));
      const auto identified = identify(message);
      std::optional<TimeCell> cell;
      Statistic statistic;
      if (identified) {
        statistic =
            statistic_of(message, identified->parameter->standard_name == "wind_speed_of_gust");
        if (statistic.refused.empty()) cell = valid_time_of(message, *identified->parameter);
      }
      if (!statistic.refused.empty()) {
        ++statistics[quantity_name(message, *identified->parameter) + ": " + statistic.refused];
        ++statistic_fields;
      } else if (!cell) {
        const std::string name = message.text_if_any("shortName").value_or("unknown");
        const std::string level = message.text_if_any("typeOfLevel").value_or("unknown");
        ++passed_over[identified ? name + " " + message.text_if_any("stepType").value_or("")
                                 : name + (level == "surface" ? "" : " on " + level)];
      } else {
        FieldEntry entry;
        entry.position = position;
        entry.parameter = identified->parameter;
        entry.height_m = identified->height_m;
        entry.run = reference_time_of(message);
        entry.cell = *cell;
        entry.is_ensemble_mean = statistic.is_ensemble_mean;
        if (!entry.is_ensemble_mean)
          entry.member = statistic.member ? statistic.member : member_of(message);
        means_of_members += entry.is_ensemble_mean ? 1 : 0;
        entry.centre = message.text_if_any("centre").value_or("unknown centre");
        const RegularGrid grid = regular_grid_of(message, cut);
        const auto known = std::find(inventory.grids.begin(), inventory.grids.end(), grid);
        entry.grid = static_cast<std::size_t>(known - inventory.grids.begin());
        if (known == inventory.grids.end()) inventory.grids.push_back(grid);
        if (entry.parameter->standard_name == "wind_speed_of_gust" &&
            message.integer("startStep") != message.integer("endStep")) {
          ++gusts_over_intervals;
        }
        inventory.fields.push_back(std::move(entry));
      }
      ++position.field;
    }
    if (on_bytes) on_bytes(file.offset());
  }
  if (inventory.fields.empty() && !statistics.empty()) {
    throw Error(
        ErrorKind::invalid_input,
        "found statistics of the quantity, not the quantity itself: " + list_of(statistics) +
            "; expected the control, members or the mean of an ensemble, as instants or "
            "averages over time: download those instead");
  }
  if (inventory.fields.empty()) {
    throw Error(ErrorKind::invalid_input,
                "found " + (passed_over.empty() ? "no field" : list_of(passed_over)) +
                    "; expected wind or waves near the surface (" + known_parameters() +
                    "): download those parameters");
  }
  if (file.frame_bytes() > 0) {
    inventory.warnings.push_back("passed over " + std::to_string(file.frame_bytes()) +
                                 " bytes of bulletin headings around the messages");
  }
  if (!passed_over.empty()) inventory.warnings.push_back("passed over " + list_of(passed_over));
  if (!statistics.empty()) {
    inventory.warnings.push_back(
        "left out " + std::to_string(statistic_fields) +
        (statistic_fields == 1 ? " field that is a statistic" : " fields that are statistics") +
        ", not the quantity itself: " + list_of(statistics));
  }
  if (means_of_members > 0) {
    inventory.warnings.push_back(
        std::to_string(means_of_members) +
        (means_of_members == 1 ? " field is the mean" : " fields are means") +
        " over the members of an ensemble, smoother than any of them; kept apart as dataset " +
        std::string(ensemble_mean_dataset));
  }
  if (gusts_over_intervals > 0) {
    inventory.warnings.push_back(
        std::to_string(gusts_over_intervals) +
        " gust fields are maxima over an interval; each is stamped with its end");
  }
  return inventory;
}

}  // namespace slackwater::ingest::grib
