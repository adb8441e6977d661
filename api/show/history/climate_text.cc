#include <algorithm>
#include <cmath>

#include "api/show/history/climate_answer.h"
#include "api/show/history/workability_answer.h"
#include "fields/base/month_names.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string months_text(const std::vector<int>& months) {
  std::vector<std::string> names;
  for (const int month : months)
    names.emplace_back(month_names[static_cast<std::size_t>(month - 1)]);
  return joined(names, ", ");
}

/// "<4", "4-8", ">=24".
std::string class_text(const std::vector<double>& edges, std::size_t index) {
  if (edges.empty()) return "all";
  if (index == 0) return formatted("<{:g}", edges.front());
  if (index == edges.size()) return formatted(">={:g}", edges.back());
  return formatted("{:g}-{:g}", edges[index - 1], edges[index]);
}

/// A share in the parts of a table; a point where nothing is.
std::string part_text(std::size_t steps, std::size_t of, double whole) {
  return steps == 0 ? "." : formatted("{:.1f}", whole * share_of(steps, of));
}

std::string head_text(const History& history) {
  const StepClock& clock = history.regular.clock;
  return formatted("{}: {} steps of {:g} h from {} to {}.\n", history.source, clock.steps,
                   clock.step_h(), format_utc(clock.first), format_utc(clock.end()));
}

/// How much of each month is known.
std::string coverage_text(const ClimateAnswer& answer) {
  std::string text = formatted("\n{:<9}", "known, %");
  for (const char* month : month_names) text += formatted("{:>6}", month);
  text += formatted("{:>6}\n", "all");
  const auto cell = [](const twin::KnownSteps& one) {
    return formatted(
        "{:>6}", one.steps == 0 ? "-" : formatted("{:.1f}", 100 * share_of(one.known, one.steps)));
  };
  for (const ClimatePart& part : answer.parts) {
    text += formatted("{:<9}", kind_of(part.of).word);
    for (const twin::KnownSteps& month : part.known.by_month) text += cell(month);
    text += cell(part.known.all) + "\n";
  }
  return text;
}

std::string spread_text(const ClimatePart& part, const History& history) {
  const ClimateKind& kind = kind_of(part.of);
  const ClimateSpread& spread = part.spread;
  const std::string& series = history.series[part.series].name;
  return formatted(
      "\n{}: {}, {}{}, a value every {:g} h\n  mean {:.2f}; half of the time at most {:.2f}, 9 in "
      "10 at most {:.2f}, 99 in 100 at most {:.2f}; greatest {:.2f}, {}\n",
      sentence(kind.word).substr(0, kind.word.size()), kind.size_name, kind.unit,
      series == kind.size_name ? "" : " (" + series + ")",
      hours_of(history.regular.own_step[part.series]), spread.mean, spread.p50, spread.p90,
      spread.p99, spread.greatest, format_utc(history.regular.clock.time_of(spread.greatest_step)));
}

std::string rose_text(const ClimateKind& kind, const ClimateRose& rose) {
  const twin::Rose& counts = rose.counts;
  const std::size_t known = counts.known();
  const std::size_t classes = rose.edges.values.size() + 1;
  std::string text = formatted(
      "\n  rose of {}, % of the time, by the direction that it {} and by {}, {}\n  {:<8}",
      kind.word, kind.way == "to" ? "goes to" : "comes from",
      kind.of == ClimateOf::waves ? "height" : "speed", rose.edges.unit, kind.way + ", deg");
  for (std::size_t c = 0; c < classes; ++c)
    text += formatted("{:>10}", class_text(rose.edges.values, c));
  text += formatted("{:>10}\n", "all");
  for (std::size_t s = 0; s < counts.sectors.size(); ++s) {
    text += formatted("  {:<8}", formatted("{:g}", middle_deg(s, counts.sectors.size())));
    for (const std::size_t steps : counts.sectors[s])
      text += formatted("{:>10}", part_text(steps, known, 100));
    text += formatted("{:>10}\n", part_text(counts.in_sector(s), known, 100));
  }
  text += formatted("  {:<8}", "all");
  for (std::size_t c = 0; c < classes; ++c)
    text += formatted("{:>10}", part_text(counts.in_class(c), known, 100));
  text += formatted("{:>10}\n", part_text(known - counts.calm - counts.no_direction, known, 100));
  text += formatted("  calm (below {:g} {}): {:.1f} %; without a direction: {:.1f} %; of {} steps",
                    rose.calm.values.front(), rose.calm.unit, 100 * share_of(counts.calm, known),
                    100 * share_of(counts.no_direction, known), known);
  return text + (counts.missing == 0
                     ? ".\n"
                     : formatted("; {} more are missing and in no share.\n", counts.missing));
}

std::string return_text(const twin::ReturnValue& one) {
  switch (one.support) {
    case twin::ReturnSupport::supported:
      return formatted("{:.2f} ({:.2f}-{:.2f})", one.value, one.interval.low, one.interval.high);
    case twin::ReturnSupport::beyond_history:
      return "not supported";
    case twin::ReturnSupport::below_year:
      return "below a year";
    case twin::ReturnSupport::no_good_fit:
      return "no good fit";
    case twin::ReturnSupport::below_threshold:
      break;
  }
  return "below threshold";
}

/// A line of return values, each below its years.
std::string returns_row(const std::string& name, const std::vector<twin::ReturnValue>& returns) {
  std::string text = formatted("  {:<28}", name);
  for (const twin::ReturnValue& one : returns) text += formatted("{:>22}", return_text(one));
  return text + "\n";
}

std::string thresholds_text(const twin::Extremes& extremes, const std::string& unit) {
  std::string text = formatted("  other thresholds\n  {:>9} {:>7} {:>7}  {:<22}", unit, "storms",
                               "a year", "shape");
  std::vector<std::size_t> told;
  const std::vector<twin::ReturnValue>& returns = extremes.peaks->returns;
  for (std::size_t r = 0; r < returns.size(); ++r) {
    if (returns[r].support == twin::ReturnSupport::beyond_history) continue;
    told.push_back(r);
    text += formatted("{:>22}", formatted("{:g} y", returns[r].years));
  }
  text += "\n";
  for (const twin::PeaksFit& one : extremes.other_thresholds) {
    text += formatted(
        "  {:>9} {:>7} {:>7}  {:<22}", formatted("{:.3f}", one.threshold), one.storms,
        formatted("{:.1f}", one.storms_per_year),
        formatted("{:.2f} ({:.2f} to {:.2f})", one.fit.shape, one.shape.low, one.shape.high));
    for (const std::size_t r : told) text += formatted("{:>22}", return_text(one.returns[r]));
    text += one.threshold == extremes.peaks->threshold ? " *\n" : "\n";
  }
  return text;
}

/// By what the threshold is the one that it is.
std::string chosen_text(const twin::Extremes& extremes) {
  if (extremes.rate == 0) return ", as asked";
  if (extremes.has_rate())
    return formatted(", the greatest with {:.3g} storms a year", extremes.rate);
  return formatted(", with most storms: none has {:.3g} a year", extremes.rate);
}

/// What is wrong with a fit that is not good.
std::string bad_fit_text(double shape, double upper_end, double greatest_seen) {
  if (shape >= twin::most_shape)
    return formatted("no good fit, its shape is {:.2f}: from {:g} on it tells nothing", shape,
                     twin::most_shape);
  return formatted("no good fit, it has nothing above {:.2f}, and {:.2f} was seen", upper_end,
                   greatest_seen);
}

std::string coarse_text(const twin::Extremes& extremes) {
  return formatted(
      "a value holds {:g} h, expected at most {:g} h and the separation of {:g} h: peaks are lost "
      "in what is coarser.",
      extremes.value_step_h, hours_of(twin::longest_step), extremes.separation_h);
}

/// What standards mean by their values of fifty years.
std::string average_text(ClimateOf of, double step_h) {
  const std::string own =
      formatted("  values are as the series averages them, at steps of {:g} h", step_h);
  if (of == ClimateOf::wind)
    return own + "; V50 of IEC 61400-1 is a 10-minute mean at hub height\n";
  if (of == ClimateOf::waves) return own + "; Hs50 of IEC 61400-3-1 is of 3-hour seas\n";
  return own + "; tide and storm together\n";
}

std::string extremes_text(const ClimateKind& kind, const twin::Extremes& extremes,
                          const ClimateQuestion& question) {
  std::string text = formatted(
      "\n  extremes of {}, {}: what is exceeded once in so many years on average, with 90 % "
      "intervals\n",
      kind.word, kind.unit);
  if (extremes.peaks || extremes.gumbel) {
    text += formatted("  {:<28}", "years");
    for (const double years : question.storms.return_years)
      text += formatted("{:>22}", formatted("{:g}", years));
    text += "\n";
  }
  if (extremes.peaks) text += returns_row("storms over a threshold", extremes.peaks->returns);
  if (extremes.gumbel) text += returns_row("maxima of years, Gumbel", extremes.gumbel->returns);
  if (extremes.extreme_value)
    text += returns_row("maxima of years, GEV", extremes.extreme_value->returns);
  text += formatted("  {:.2f} years known", extremes.years_known);
  const auto is_beyond = [](const twin::ReturnValue& one) {
    return one.support == twin::ReturnSupport::beyond_history;
  };
  const auto any_beyond = [&](const auto& fit) {
    return fit && std::any_of(fit->returns.begin(), fit->returns.end(), is_beyond);
  };
  if (any_beyond(extremes.peaks) || any_beyond(extremes.gumbel))
    text += formatted(
        "; not supported: periods beyond {:g} times the history, for which no sample of this "
        "length speaks",
        twin::most_histories);
  text += ".\n";
  if (const std::string why = no_peaks_text(extremes); !why.empty()) text += "  " + why + "\n";
  if (extremes.peaks) {
    const twin::PeaksFit& peaks = *extremes.peaks;
    text += formatted(
        "  threshold {:.3f} {}{}: {} storms at least {:g} h apart, {:.1f} a year; scale {:.3f}, "
        "shape {:.2f} ({:.2f} to {:.2f}){}\n",
        peaks.threshold, kind.unit, chosen_text(extremes), peaks.storms, extremes.separation_h,
        peaks.storms_per_year, peaks.fit.scale, peaks.fit.shape, peaks.shape.low, peaks.shape.high,
        peaks.fit.shape < 0 ? formatted(", so nothing above {:.2f}", peaks.upper_end()) : "");
    text += "  method: " + peaks_method() + "\n" + thresholds_text(extremes, kind.unit);
  }
  for (const std::string& why : {no_gumbel_text(extremes), no_shape_text(extremes)})
    if (!why.empty()) text += "  " + why + "\n";
  if (extremes.gumbel) {
    std::vector<std::string> years;
    for (const twin::YearMaximum& one : extremes.maxima)
      years.push_back(formatted("{} {:.2f}", one.year, one.value));
    text += "  maxima of years: " + joined(years, ", ") + "\n  method: " + gumbel_method() + "\n";
  }
  if (extremes.extreme_value) text += "  method: " + extreme_value_method() + "\n";
  if (extremes.peaks || extremes.gumbel)
    text += "  intervals: " + interval_method(question) + "\n" +
            average_text(kind.of, extremes.value_step_h);
  return text;
}

std::string scatter_text(const ClimateScatter& scatter) {
  const twin::Scatter& counts = scatter.counts;
  const std::size_t columns = counts.counts.front().size();
  const auto column_has = [&](std::size_t c) {
    return std::any_of(counts.counts.begin(), counts.counts.end(),
                       [&](const std::vector<std::size_t>& row) { return row[c] > 0; });
  };
  std::size_t first = 0;
  std::size_t last = columns;
  if (scatter.sectors == 0) {
    while (first < columns && !column_has(first)) ++first;
    while (last > first && !column_has(last - 1)) --last;
  }
  std::size_t rows = counts.counts.size();
  const auto row_steps = [&](std::size_t r) {
    std::size_t sum = 0;
    for (const std::size_t steps : counts.counts[r]) sum += steps;
    return sum;
  };
  while (rows > 0 && row_steps(rows - 1) == 0) --rows;
  std::string text =
      scatter.sectors == 0
          ? formatted(
                "\nwaves, per mille of the time: significant height, {}, by peak period, {}\n",
                scatter.heights.unit, scatter.periods.unit)
          : formatted(
                "\nwaves, per mille of the time: significant height, {}, by the direction that "
                "they "
                "come from, degrees\n",
                scatter.heights.unit);
  text += formatted("{:<10}", "");
  for (std::size_t c = first; c < last; ++c)
    text += formatted("{:>7}", scatter.sectors == 0
                                   ? class_text(scatter.periods.values, c)
                                   : formatted("{:g}", middle_deg(c, scatter.sectors)));
  text += formatted("{:>8}\n", "all");
  std::vector<std::size_t> sums(columns, 0);
  for (std::size_t r = 0; r < rows; ++r) {
    text += formatted("{:<10}", class_text(scatter.heights.values, r));
    for (std::size_t c = 0; c < columns; ++c) sums[c] += counts.counts[r][c];
    for (std::size_t c = first; c < last; ++c)
      text += formatted("{:>7}", part_text(counts.counts[r][c], counts.known, 1000));
    text += formatted("{:>8}\n", part_text(row_steps(r), counts.known, 1000));
  }
  text += formatted("{:<10}", "all");
  for (std::size_t c = first; c < last; ++c)
    text += formatted("{:>7}", part_text(sums[c], counts.known, 1000));
  text += formatted("{:>8}\n", part_text(counts.known, counts.known, 1000));
  return text +
         formatted("of {} steps that know both; each class holds its lower edge\n", counts.known);
}

}  // namespace

double middle_deg(std::size_t sector, std::size_t sectors) noexcept {
  return 360.0 * static_cast<double>(sector) / static_cast<double>(sectors);
}

std::string peaks_method() {
  return "generalised Pareto of the storms' peaks by probability-weighted moments (Hosking and "
         "Wallis 1987); runs declustering and Poisson storms (Coles 2001, 5.3.2 and 4.3.3)";
}

std::string gumbel_method() {
  return "Gumbel of the greatest value of each calendar year by probability-weighted moments; the "
         "T-year value is not exceeded in a year with exp(-1/T) (Coles 2001, ch. 3)";
}

std::string extreme_value_method() {
  return "generalised extreme value of the same by probability-weighted moments (Hosking, Wallis "
         "and Wood 1985)";
}

std::string interval_method(const ClimateQuestion& question) {
  return formatted(
      "5th to 95th percentile of {} samples drawn from the fit and fitted again (parametric "
      "bootstrap, seed {}); they know no error of the series, and no change of climate",
      question.storms.resamples, question.storms.seed);
}

std::vector<std::string> part_notes(const ClimatePart& part) {
  const std::string& word = kind_of(part.of).word;
  std::vector<std::string> notes;
  if (const std::vector<int> unknown = part.known.unknown(); !unknown.empty())
    notes.push_back(word + ": nothing is known of " + months_text(unknown) +
                    "; this is not the climate of a year");
  if (const std::vector<int> thin = part.known.thin(); !thin.empty())
    notes.push_back(word + ": less is known of " + months_text(thin) +
                    " than half of what is of other months; shares lean to those");
  if (!part.extremes) return notes;
  const std::vector<twin::YearMaximum>& maxima = part.extremes->maxima;
  for (std::size_t i = 1; i < maxima.size(); ++i) {
    const double apart_h =
        static_cast<double>(maxima[i].step - maxima[i - 1].step) * part.extremes->step_h;
    if (apart_h < part.extremes->separation_h)
      notes.push_back(
          formatted("{}: the maxima of {} and {} are {:g} h apart, of one storm; as maxima of "
                    "years they count "
                    "as two",
                    word, maxima[i - 1].year, maxima[i].year, apart_h));
  }
  return notes;
}

std::string no_peaks_text(const twin::Extremes& extremes) {
  switch (extremes.no_peaks) {
    case twin::NoPeaks::coarse_steps:
      return "no extremes from storms: " + coarse_text(extremes);
    case twin::NoPeaks::short_history:
      return formatted(
          "no extremes from storms: {:.2f} years are known, and fewer than {:g} say nothing of "
          "them.",
          extremes.years_known, twin::least_years);
    case twin::NoPeaks::seasons_missing:
      return "no extremes from storms: of " + months_text(extremes.months_missing) +
             " nothing is known, or less than half of what is known of other months; storms of a "
             "part of the year are not those of a year.";
    case twin::NoPeaks::few_storms:
      return formatted(
          "no extremes from storms: {} over the threshold, {:g} h apart, expected {} at least; "
          "say another --threshold (a low one joins storms, a high one has few), more "
          "--storms-per-year or a shorter --separation.",
          counted(extremes.storms_found, "storm"), extremes.separation_h, twin::least_storms);
    case twin::NoPeaks::all_alike:
      return "no extremes from storms: no two peaks differ.";
    case twin::NoPeaks::no_good_fit:
      return "no extremes from storms: " +
             bad_fit_text(extremes.peaks->fit.shape, extremes.peaks->upper_end(),
                          extremes.peaks->greatest_seen) +
             "; see other thresholds.";
    case twin::NoPeaks::none:
      break;
  }
  return "";
}

std::string no_gumbel_text(const twin::Extremes& extremes) {
  if (extremes.gumbel) return "";
  if (extremes.no_peaks == twin::NoPeaks::coarse_steps)
    return "no extremes from maxima of years: " + coarse_text(extremes);
  if (extremes.maxima.size() >= twin::least_gumbel_years)
    return "no extremes from maxima of years: all are alike.";
  return formatted("no extremes from maxima of years: {} complete, expected {} at least.",
                   counted(extremes.maxima.size(), "year"), twin::least_gumbel_years);
}

std::string no_shape_text(const twin::Extremes& extremes) {
  if (const auto& fit = extremes.extreme_value; fit && !fit->is_good())
    return "no generalised extreme value: " +
           bad_fit_text(fit->fit.shape, fit->fit.greatest(), fit->greatest_seen) + ".";
  if (extremes.extreme_value || !extremes.gumbel) return "";
  return formatted("no generalised extreme value: {} complete, expected {} at least for a shape.",
                   counted(extremes.maxima.size(), "year"), twin::least_shape_years);
}

std::string climate_text(const History& history, const ClimateQuestion& question,
                         const ClimateAnswer& answer) {
  std::string text = head_text(history) + coverage_text(answer);
  for (const ClimatePart& part : answer.parts) {
    const ClimateKind& kind = kind_of(part.of);
    text += spread_text(part, history);
    if (part.rose) text += rose_text(kind, *part.rose);
    if (part.extremes) text += extremes_text(kind, *part.extremes, question);
  }
  for (const auto* scatter : {&answer.by_period, &answer.by_sector})
    if (*scatter) text += scatter_text(**scatter);
  return text;
}

}  // namespace slackwater::api
