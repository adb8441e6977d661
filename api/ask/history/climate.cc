#include "api/ask/history/climate.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

#include "fields/base/advice.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/text.h"
#include "ingest/cf/units.h"
#include "twin/risk/workability/workable_starts.h"

namespace slackwater::api {
namespace {

/// Edges step, 2 step, ... up to the last.
std::vector<double> even_edges(double step, int count) {
  std::vector<double> edges;
  for (int i = 1; i <= count; ++i) edges.push_back(step * i);
  return edges;
}

const std::array<ClimateKind, 4>& climate_kinds() {
  static const std::array<ClimateKind, 4> kinds{
      ClimateKind{ClimateOf::wind, "wind", "wind_speed", "wind_from_direction", "from", "m s-1",
                  0.5, even_edges(4, 6)},
      ClimateKind{ClimateOf::waves,
                  "waves",
                  "sea_surface_wave_significant_height",
                  "sea_surface_wave_from_direction",
                  "from",
                  "m",
                  0.1,
                  {0.5, 1, 1.5, 2, 3, 4, 6}},
      ClimateKind{ClimateOf::current,
                  "current",
                  "sea_water_speed",
                  "sea_water_velocity_to_direction",
                  "to",
                  "m s-1",
                  0.05,
                  {0.1, 0.2, 0.3, 0.5, 0.75, 1, 1.5}},
      ClimateKind{ClimateOf::period, "period",
                  "sea_surface_wave_period_at_variance_spectral_density_maximum", "", "", "s", 0,
                  even_edges(1, 25)}};
  return kinds;
}

const ClimateNumbers* stated_of(ClimateOf of, const std::vector<ClimateNumbers>& all) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ClimateNumbers& one) { return one.of == of; });
  return found == all.end() ? nullptr : &*found;
}

ClimateEdges edges_of(ClimateOf of, const std::vector<ClimateNumbers>& stated,
                      std::vector<double> otherwise) {
  if (const ClimateNumbers* found = stated_of(of, stated)) return {found->values, found->unit};
  return {std::move(otherwise), kind_of(of).unit};
}

/// Edges in the unit of a series and as precise as its values, so that 1.2 m is in the class from
/// 1.2 m on.
std::vector<double> edges_on(const HistorySeries& series, const ClimateEdges& edges,
                             const ingest::Vocabulary& vocabulary) {
  std::vector<double> found;
  for (const double edge : edges.values) {
    SeriesLimit limit;
    limit.text = formatted("{:g} {}", edge, edges.unit);
    limit.variable = series.standard_name;
    limit.bound = {twin::BoundSide::at_least, edge};
    limit.unit = edges.unit;
    found.push_back(bound_on(limit, series, vocabulary).value);
  }
  return found;
}

ClimateSpread spread_of(const std::vector<double>& values) {
  std::vector<double> known;
  ClimateSpread spread;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    if (known.empty() || values[i] > spread.greatest) {
      spread.greatest = values[i];
      spread.greatest_step = i;
    }
    known.push_back(values[i]);
  }
  spread.mean =
      std::accumulate(known.begin(), known.end(), 0.0) / static_cast<double>(known.size());
  std::sort(known.begin(), known.end());
  spread.p50 = percentile(known, 50);
  spread.p90 = percentile(known, 90);
  spread.p99 = percentile(known, 99);
  return spread;
}

class Climate {
 public:
  Climate(const History& history, const ClimateQuestion& question,
          const ingest::Vocabulary& vocabulary)
      : history_(history), question_(question), vocabulary_(vocabulary) {}

  ClimateAnswer answer() {
    for (const ClimateOf of : question_.of) {
      const auto size = place_of(kind_of(of).size_name, history_);
      if (size && is_known(*size)) add_part(of, *size);
    }
    if (answer_.parts.empty())
      throw Error(ErrorKind::not_found,
                  history_.source + ": found no value of wind, waves or current that is asked for");
    if (question_.scatter) add_scatters();
    return std::move(answer_);
  }

 private:
  [[nodiscard]] bool is_known(std::size_t series) const {
    const std::vector<double>& values = history_.regular.values[series];
    return std::any_of(values.begin(), values.end(),
                       [](double value) { return !std::isnan(value); });
  }

  /// Where a variable is, with a note where it is not.
  std::optional<std::size_t> expected(const std::string& name, const std::string& what) {
    const auto place = place_of(name, history_);
    if (place && is_known(*place)) return place;
    answer_.notes.push_back("found no " + name + ": no " + what);
    return std::nullopt;
  }

  void add_part(ClimateOf of, std::size_t size) {
    const ClimateKind& kind = kind_of(of);
    ClimatePart part;
    part.of = of;
    part.series = size;
    const std::vector<double> values = values_in(kind.unit, kind.size_name, history_);
    part.known = twin::known_months(values, twin::months_of(history_.regular.clock, std::nullopt));
    part.spread = spread_of(values);
    if (question_.roses) {
      if (const auto direction = expected(kind.direction_name, "rose of " + kind.word))
        part.rose = rose(kind, size, *direction);
    }
    if (question_.extremes) part.extremes = extremes(kind, size, values);
    answer_.parts.push_back(std::move(part));
  }

  [[nodiscard]] ClimateRose rose(const ClimateKind& kind, std::size_t size,
                                 std::size_t direction) const {
    ClimateRose found;
    found.direction = direction;
    found.edges = edges_of(kind.of, question_.classes, kind.edges);
    found.calm = edges_of(kind.of, question_.calms, {kind.calm});
    const HistorySeries& series = history_.series[size];
    twin::RoseClasses classes;
    classes.sectors = question_.sectors;
    classes.edges = edges_on(series, found.edges, vocabulary_);
    classes.calm = edges_on(series, found.calm, vocabulary_).front();
    if (!classes.edges.empty() && classes.edges.front() <= classes.calm)
      refuse(
          formatted("found classes of {} from {:g} {} on, expected all above {:g} {}, below "
                    "which is calm; say another --calm",
                    kind.word, found.edges.values.front(), found.edges.unit,
                    found.calm.values.front(), found.calm.unit));
    found.counts = twin::rose_of(history_.regular.values[size],
                                 values_in("degree", kind.direction_name, history_), classes);
    return found;
  }

  [[nodiscard]] twin::Extremes extremes(const ClimateKind& kind, std::size_t size,
                                        const std::vector<double>& values) const {
    const StepClock& clock = history_.regular.clock;
    twin::ExtremesQuestion asked = question_.storms;
    asked.separation_steps = twin::steps_needed(question_.separation, clock.step);
    asked.value_step = history_.regular.own_step[size];
    if (const ClimateNumbers* stated = stated_of(kind.of, question_.thresholds)) {
      // In the unit of the series first, then brought on as its values are, for equal to stay so.
      const HistorySeries& series = history_.series[size];
      const double bound = edges_on(series, {stated->values, stated->unit}, vocabulary_).front();
      const auto unit = ingest::unit_conversion(series.unit, kind.unit, "'" + series.name + "'");
      asked.threshold = unit.is_identity() ? bound : unit.scale * bound + unit.offset;
    }
    return twin::extremes_of(values, clock, asked);
  }

  void add_scatters() {
    if (std::find(question_.of.begin(), question_.of.end(), ClimateOf::waves) == question_.of.end())
      return;
    const ClimateKind& waves = kind_of(ClimateOf::waves);
    const auto height = place_of(waves.size_name, history_);
    if (!height || !is_known(*height)) return;
    const std::vector<double>& heights = history_.regular.values[*height];
    const ClimateEdges height_edges =
        edges_of(ClimateOf::waves, question_.classes, even_edges(0.5, 30));
    const std::vector<double> rows = edges_on(history_.series[*height], height_edges, vocabulary_);
    const ClimateKind& period = kind_of(ClimateOf::period);
    if (const auto place = expected(period.size_name, "scatter of heights and periods")) {
      ClimateScatter found;
      found.heights = height_edges;
      found.periods = edges_of(ClimateOf::period, question_.classes, period.edges);
      found.counts =
          twin::scatter_of(heights, rows, history_.regular.values[*place],
                           edges_on(history_.series[*place], found.periods, vocabulary_));
      answer_.by_period = with_steps(std::move(found), period.size_name);
    }
    if (!expected(waves.direction_name, "scatter of heights and directions")) return;
    ClimateScatter found;
    found.heights = height_edges;
    found.sectors = question_.sectors;
    std::vector<double> sector = values_in("degree", waves.direction_name, history_);
    for (double& direction : sector) {
      if (!std::isnan(direction))
        direction = static_cast<double>(twin::sector_of(direction, question_.sectors));
    }
    std::vector<double> columns;
    for (std::size_t s = 1; s < question_.sectors; ++s) columns.push_back(static_cast<double>(s));
    found.counts = twin::scatter_of(heights, rows, sector, columns);
    answer_.by_sector = with_steps(std::move(found), waves.direction_name);
  }

  /// A table, or a note where no step knows both.
  std::optional<ClimateScatter> with_steps(ClimateScatter found, const std::string& name) {
    if (found.counts.known > 0) return found;
    answer_.notes.push_back("found no step with a height of waves and " + name + ": no scatter");
    return std::nullopt;
  }

  const History& history_;
  const ClimateQuestion& question_;
  const ingest::Vocabulary& vocabulary_;
  ClimateAnswer answer_;
};

}  // namespace

const ClimateKind& kind_of(ClimateOf of) { return climate_kinds()[static_cast<std::size_t>(of)]; }

ClimateOf parse_climate_of(const std::string& text) {
  std::vector<std::string> known;
  for (const ClimateKind& kind : climate_kinds()) {
    if (kind.of == ClimateOf::period) continue;  // has no climate of its own
    if (kind.word == text) return kind.of;
    known.push_back(kind.word);
  }
  refuse("found '" + text + "', expected one of " + joined(known, ", ") +
         did_you_mean(text, known));
}

ClimateNumbers parse_climate_numbers(const std::string& text) {
  const auto bad = [&](const std::string& why) {
    refuse("found '" + text + "'" + why +
           "; expected NAME=NUMBERS UNIT, e.g. 'wind=4,8,12 m/s', of wind, waves, current or "
           "period");
  };
  ClimateNumbers numbers;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) bad(" without =");
  const std::string word(trimmed(std::string_view(text).substr(0, equals)));
  const auto kind = std::find_if(climate_kinds().begin(), climate_kinds().end(),
                                 [&](const ClimateKind& one) { return one.word == word; });
  if (kind == climate_kinds().end()) bad(", whose '" + word + "' is not known here");
  numbers.of = kind->of;
  std::string_view rest = trimmed(std::string_view(text).substr(equals + 1));
  for (;;) {
    double value = 0;
    const auto [stop, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (problem != std::errc{} || !std::isfinite(value)) bad(" without a finite number");
    if (value < 0) bad(formatted(", whose {:g} is less than 0", value));
    if (!numbers.values.empty() && value <= numbers.values.back())
      bad(formatted(", whose {:g} follows {:g}: they have to ascend", value,
                    numbers.values.back()));
    numbers.values.push_back(value);
    rest = trimmed(rest.substr(static_cast<std::size_t>(stop - rest.data())));
    if (!rest.starts_with(',')) break;
    rest = trimmed(rest.substr(1));
  }
  numbers.unit = rest.empty() ? kind->unit : std::string(rest);
  static_cast<void>(ingest::unit_conversion(numbers.unit, kind->unit, "'" + text + "'"));
  return numbers;
}

ClimateNumbers parse_climate_number(const std::string& text) {
  ClimateNumbers numbers = parse_climate_numbers(text);
  if (numbers.values.size() != 1)
    refuse("found '" + text + "' with " + counted(numbers.values.size(), "number") +
           ", expected one");
  return numbers;
}

std::vector<double> return_periods(std::vector<double> years) {
  std::sort(years.begin(), years.end());
  years.erase(std::unique(years.begin(), years.end()), years.end());
  return years;
}

WantedSeries wanted_by(const ClimateQuestion& question) {
  WantedSeries wanted;
  for (const ClimateOf of : question.of) wanted.if_there.push_back(kind_of(of).size_name);
  for (const ClimateOf of : question.of) {
    const bool by_direction = question.roses || (question.scatter && of == ClimateOf::waves);
    if (by_direction) wanted.if_there.push_back(kind_of(of).direction_name);
    if (question.scatter && of == ClimateOf::waves)
      wanted.if_there.push_back(kind_of(ClimateOf::period).size_name);
  }
  return wanted;
}

ClimateAnswer answer_of(const History& history, const ClimateQuestion& question,
                        const ingest::Vocabulary& vocabulary) {
  expects(question.sectors > 0, "a rose has sectors");
  return Climate(history, question, vocabulary).answer();
}

}  // namespace slackwater::api
