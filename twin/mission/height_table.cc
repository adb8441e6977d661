#include "twin/mission/height_table.h"

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/ascends.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

using constants::degree;

/// Where a value lies on an axis: between two nodes, at most at its ends.
struct AxisPlace {
  std::size_t low = 0;
  double upper = 0;  ///< weight of the next node
};

AxisPlace place_on(const std::vector<double>& axis, double value) noexcept {
  if (axis.empty() || value <= axis.front()) return {};
  if (value >= axis.back()) return {axis.size() - 1, 0};
  const auto above = std::upper_bound(axis.begin(), axis.end(), value);
  const auto low = static_cast<std::size_t>(above - axis.begin()) - 1;
  return {low, (value - axis[low]) / (axis[low + 1] - axis[low])};
}

/// The least over the nodes that a value may lie between, or at its place.
template <typename ValueAt>
double along(const std::vector<double>& axis, std::optional<AxisPlace> place,
             const ValueAt& value_at) noexcept {
  if (place) {
    const double low = value_at(place->low);
    return place->upper > 0 ? low + place->upper * (value_at(place->low + 1) - low) : low;
  }
  double least = value_at(0);
  for (std::size_t i = 1; i < axis.size(); ++i) least = std::min(least, value_at(i));
  return least;
}

/// One bound, or one for each period.
std::vector<double> read_row(const Config& row, std::size_t periods, Range range) {
  if (periods == 0) {
    if (row.is_list("at_most"))
      row.refuse("at_most",
                 "found a list without peak_period_s, the periods that it is for; add "
                 "them, or give one number");
    return {row.number("at_most", range)};
  }
  if (!row.is_list("at_most"))
    row.refuse("at_most",
               formatted("expected a list of {} numbers, one for each of peak_period_s", periods));
  std::vector<double> values = row.numbers("at_most", range);
  if (values.size() != periods)
    row.refuse("at_most", formatted("found {} numbers, expected {}, one for each of peak_period_s",
                                    values.size(), periods));
  return values;
}

std::string period_text(const HeightTable& table, double period_s) {
  if (std::isnan(period_s)) return "the worst period, since none is known";
  std::string text = formatted("a peak period of {:.3g} s", period_s);
  if (period_s < table.peak_period_s.front())
    text += formatted(" (the table begins at {:g} s)", table.peak_period_s.front());
  if (period_s > table.peak_period_s.back())
    text += formatted(" (the table ends at {:g} s)", table.peak_period_s.back());
  return text;
}

std::string angle_text(const HeightTable& table, double off_rad) {
  if (std::isnan(off_rad))
    return "the worst heading, since that of the bow or of the waves is not known";
  std::string text = formatted("waves {:.0f} degrees off the bow", off_rad / degree);
  if (off_rad < table.off_bow_rad.front())
    text += formatted(" (the table begins at {:.0f})", table.off_bow_rad.front() / degree);
  if (off_rad > table.off_bow_rad.back())
    text += formatted(" (the table ends at {:.0f})", table.off_bow_rad.back() / degree);
  return text;
}

}  // namespace

HeightBound HeightTable::limit_at(double period_s, double off_rad) const noexcept {
  HeightBound bound;
  std::optional<AxisPlace> at_period = AxisPlace{}, at_angle = AxisPlace{};
  if (!peak_period_s.empty()) {
    const bool is_known = period_s > 0;
    bound.peak_period_s = is_known ? period_s : constants::nan;
    at_period = is_known ? std::optional(place_on(peak_period_s, period_s)) : std::nullopt;
  }
  if (!off_bow_rad.empty()) {
    bound.off_bow_rad = std::abs(short_way_rad(off_rad));
    at_angle = std::isnan(*bound.off_bow_rad)
                   ? std::nullopt
                   : std::optional(place_on(off_bow_rad, *bound.off_bow_rad));
  }
  const std::size_t periods = std::max<std::size_t>(1, peak_period_s.size());
  // What is known is interpolated first: the least is then that of one sea.
  const auto at_row = [&](std::size_t row) {
    return along(peak_period_s, at_period,
                 [&](std::size_t column) { return at_most_m[row * periods + column]; });
  };
  const auto at_column = [&](std::size_t column) {
    return along(off_bow_rad, at_angle,
                 [&](std::size_t row) { return at_most_m[row * periods + column]; });
  };
  bound.at_most_m =
      at_period ? along(off_bow_rad, at_angle, at_row) : along(peak_period_s, at_period, at_column);
  return bound;
}

double HeightTable::least_m() const noexcept {
  return *std::min_element(at_most_m.begin(), at_most_m.end());
}
double HeightTable::greatest_m() const noexcept {
  return *std::max_element(at_most_m.begin(), at_most_m.end());
}

HeightTable read_height_table(const Config& config, Range range) {
  HeightTable table;
  table.peak_period_s = config.numbers("peak_period_s", {1, 30});
  if (!ascends(table.peak_period_s))
    config.refuse("peak_period_s",
                  "found periods that do not ascend; sort them, the least first, "
                  "each once");
  const std::size_t periods = table.peak_period_s.size();
  if (config.has("at_most") == config.has("rows"))
    config.refuse("at_most",
                  "expected either at_most, bounds by peak period, or rows, bounds by "
                  "the angle off the bow");
  if (config.has("at_most")) {
    table.at_most_m = read_row(config, periods, range);
  } else {
    for (const Config& row : config.children("rows")) {
      table.off_bow_rad.push_back(row.number("from_bow_deg", {0, 180}) * degree);
      if (!ascends(table.off_bow_rad))
        row.refuse("from_bow_deg",
                   "found rows that do not ascend with the angle; sort them, the "
                   "least first, each once");
      const std::vector<double> bounds = read_row(row, periods, range);
      table.at_most_m.insert(table.at_most_m.end(), bounds.begin(), bounds.end());
    }
  }
  if (table.at_most_m.size() < 2)
    config.refuse(config.has("rows") ? "rows" : "at_most",
                  "found a table of fewer than two bounds; write one bound as the number itself, "
                  "as in significant_wave_height_m: 1.5");
  return table;
}

std::string text_of(const HeightTable& table) {
  std::vector<std::string> by;
  if (!table.peak_period_s.empty())
    by.push_back(formatted("peak period ({:g} to {:g} s)", table.peak_period_s.front(),
                           table.peak_period_s.back()));
  if (!table.off_bow_rad.empty())
    by.push_back(
        formatted("angle off the bow ({:.0f} to {:.0f} degrees", table.off_bow_rad.front() / degree,
                  table.off_bow_rad.back() / degree) +
        (table.heading_rad ? formatted(", heading {:.0f})", *table.heading_rad / degree) : ")"));
  return "by " + joined(by, " and ");
}

std::string text_of(const HeightTable& table, const HeightBound& bound) {
  std::vector<std::string> with;
  if (bound.peak_period_s) with.push_back(period_text(table, *bound.peak_period_s));
  if (bound.off_bow_rad) with.push_back(angle_text(table, *bound.off_bow_rad));
  return formatted("{:.3g} m at ", bound.at_most_m) + joined(with, ", ");
}

}  // namespace slackwater::twin
