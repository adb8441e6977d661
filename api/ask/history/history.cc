#include "api/ask/history/history.h"

#include <algorithm>
#include <cmath>

#include "api/ask/history/sea_limit.h"
#include "api/pipeline/store_history.h"
#include "api/program/paths.h"
#include "fields/base/advice.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/apart/read_history_apart.h"
#include "ingest/cf/units.h"

namespace slackwater::api {
namespace {

std::vector<std::string> wanted_by(const std::vector<SeriesLimit>& limits) {
  std::vector<std::string> wanted;
  for (const SeriesLimit& limit : limits) {
    if (std::find(wanted.begin(), wanted.end(), limit.variable) == wanted.end())
      wanted.push_back(limit.variable);
  }
  return wanted;
}

/// And what tables go by, if it is there.
std::vector<std::string> wanted_if_there(const std::vector<SeriesLimit>& limits,
                                         const std::vector<std::string>& wanted) {
  std::vector<std::string> more;
  for (const SeriesLimit& limit : limits)
    for (const std::string& name : sea_variables_of(limit))
      if (std::find(wanted.begin(), wanted.end(), name) == wanted.end() &&
          std::find(more.begin(), more.end(), name) == more.end())
        more.push_back(name);
  return more;
}

/// Values of a series in the unit of another.
void bring_to_unit(HistorySeries& series, const std::string& unit) {
  const ingest::UnitConversion conversion =
      ingest::unit_conversion(series.unit, unit, "'" + series.name + "' in " + series.source);
  series.unit = unit;
  if (conversion.is_identity()) return;
  for (double& value : series.value) {
    value = conversion.scale * value + conversion.offset;
    if (series.is_single_precision) value = static_cast<float>(value);
  }
}

/// One series of several files: one after the other, however they were given.
HistorySeries joined_in_time(std::vector<HistorySeries> parts) {
  std::sort(parts.begin(), parts.end(), [](const HistorySeries& a, const HistorySeries& b) {
    return a.time.front() < b.time.front();
  });
  HistorySeries whole = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    HistorySeries& part = parts[i];
    if (part.time.front() <= whole.time.back())
      refuse("found " + part.standard_name + " at " + format_utc(part.time.front()) + " in " +
             part.source + ", and up to " + format_utc(whole.time.back()) + " in " + whole.source +
             "; expected files whose times do not overlap");
    bring_to_unit(part, whole.unit);
    whole.is_single_precision = whole.is_single_precision || part.is_single_precision;
    whole.time.insert(whole.time.end(), part.time.begin(), part.time.end());
    whole.value.insert(whole.value.end(), part.value.begin(), part.value.end());
  }
  return whole;
}

void cut(HistorySeries& series, const std::optional<UtcDay>& from,
         const std::optional<UtcDay>& to) {
  const auto index = [&](UtcTime time) {
    return std::lower_bound(series.time.begin(), series.time.end(), time) - series.time.begin();
  };
  if (to) {
    const auto end = index(UtcTime(*to) + std::chrono::days(1));
    series.time.resize(static_cast<std::size_t>(end));
    series.value.resize(static_cast<std::size_t>(end));
  }
  if (from) {
    const auto begin = index(UtcTime(*from));
    series.time.erase(series.time.begin(), series.time.begin() + begin);
    series.value.erase(series.value.begin(), series.value.begin() + begin);
  }
  if (series.time.empty())
    throw Error(ErrorKind::not_found, series.source + ": found no " + series.standard_name +
                                          " from --from to --to; widen them");
}

/// What the sources say together, one list for each wanted variable.
class Gathered {
 public:
  explicit Gathered(std::vector<std::string> wanted)
      : wanted_(std::move(wanted)), parts_(wanted_.size()) {}

  void add(const std::string& source, ingest::HistoryOfFile found) {
    sources_ += (sources_.empty() ? "" : ", ") + source;
    columns_.insert(columns_.end(), found.columns.begin(), found.columns.end());
    offered_.insert(offered_.end(), found.offered.begin(), found.offered.end());
    for (const std::string& warning : found.warnings) {
      // A component is read for the speed and for the direction.
      const std::string note = source + ": " + warning;
      if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
    }
    for (std::size_t i = 0; i < found.series.size(); ++i) {
      if (found.series[i] && !found.series[i]->time.empty())
        parts_[i].push_back(std::move(*found.series[i]));
    }
  }

  void expect_columns(const std::vector<ingest::NamedColumn>& named) const {
    for (const ingest::NamedColumn& one : named) {
      if (std::find(columns_.begin(), columns_.end(), one.column) == columns_.end())
        throw Error(ErrorKind::not_found, sources_ + ": found no column '" + one.column + "'" +
                                              did_you_mean(one.column, columns_) +
                                              "; the columns are " + joined(columns_, ", "));
    }
  }

  /// @param needed  so many of the wanted variables from the first on; of the others those that
  ///                there are
  /// @param history  gets them and their names
  /// @throws Error(not_found) for a needed variable that nobody has, and where there is none at all
  void series_into(std::size_t needed, History& history) {
    history.wanted.clear();
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (parts_[i].empty() && i >= needed) continue;
      if (parts_[i].empty()) throw not_there({wanted_[i]});
      history.wanted.push_back(wanted_[i]);
      history.series.push_back(joined_in_time(std::move(parts_[i])));
    }
    if (history.series.empty()) throw not_there(wanted_);
  }

  [[nodiscard]] const std::string& sources() const { return sources_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  [[nodiscard]] Error not_there(const std::vector<std::string>& names) const {
    const std::string& name = names.front();
    std::string found = sources_ + ": found no " + joined(names, ", no ");
    if (names.size() == 1) found += did_you_mean(name, offered_);
    if (!offered_.empty()) found += "; there is " + joined(offered_, ", ");
    if (!columns_.empty()) {
      found += "; the columns are " + joined(columns_, ", ") +
               ". Say what one is with --column 'NAME=" + name + ":UNIT'";
    }
    return {ErrorKind::not_found, found};
  }

  std::vector<std::string> wanted_;
  std::vector<std::vector<HistorySeries>> parts_;
  std::string sources_;
  std::vector<std::string> columns_;
  std::vector<std::string> offered_;
  std::vector<std::string> notes_;
};

Gathered gather(const HistorySource& source, History& history,
                const ingest::Vocabulary& vocabulary) {
  const std::vector<std::string>& wanted = history.wanted;
  Gathered gathered(wanted);
  for (const std::filesystem::path& file : source.files)
    gathered.add(file.string(),
                 ingest::read_history_apart(file, wanted, source.options, vocabulary));
  if (source.site.empty()) {
    gathered.expect_columns(source.options.columns);
    return gathered;
  }
  store::Store store = store::Store::open(source.store_folder, store::OpenMode::read_only);
  const Site site = find_site(source.site, site_folders(source.store_folder));
  if (!history.place) history.place = site.point;
  gathered.add("site " + site.id,
               read_store_history(store, site, wanted, source.options.depth_m, vocabulary));
  return gathered;
}

}  // namespace

std::optional<std::size_t> place_of(const std::string& name, const History& history) {
  const auto found = std::find(history.wanted.begin(), history.wanted.end(), name);
  if (found == history.wanted.end()) return std::nullopt;
  return static_cast<std::size_t>(found - history.wanted.begin());
}

std::vector<double> values_in(const std::string& unit, const std::string& name,
                              const History& history) {
  const auto place = place_of(name, history);
  if (!place) return {};
  const HistorySeries& series = history.series[*place];
  const auto conversion =
      ingest::unit_conversion(series.unit, unit, "'" + series.name + "' in " + series.source);
  std::vector<double> values = history.regular.values[*place];
  if (!conversion.is_identity())
    for (double& value : values) value = conversion.scale * value + conversion.offset;
  return values;
}

History load_history(const HistorySource& source, const WantedSeries& wanted,
                     const ingest::Vocabulary& vocabulary) {
  History history;
  history.wanted = wanted.needed;
  history.wanted.insert(history.wanted.end(), wanted.if_there.begin(), wanted.if_there.end());
  history.place = source.place;
  Gathered gathered = gather(source, history, vocabulary);
  gathered.series_into(wanted.needed.size(), history);
  history.source = gathered.sources();
  history.notes = gathered.notes();
  for (HistorySeries& series : history.series) cut(series, source.from, source.to);
  history.regular = on_regular_steps(history.series);
  history.notes.insert(history.notes.end(), history.regular.notes.begin(),
                       history.regular.notes.end());
  for (HistorySeries& series : history.series) {
    series.time = {};
    series.value = {};
  }
  return history;
}

History load_history(const HistorySource& source, const std::vector<SeriesLimit>& limits,
                     const ingest::Vocabulary& vocabulary) {
  WantedSeries wanted;
  wanted.needed = wanted_by(limits);
  wanted.if_there = wanted_if_there(limits, wanted.needed);
  History history = load_history(source, wanted, vocabulary);
  for (const SeriesLimit& limit : limits)
    if (const std::string unknown = unknown_sea_of(limit, history); !unknown.empty())
      history.notes.push_back(unknown);
  return history;
}

LimitedHistory limited(const History& history, const std::vector<SeriesLimit>& limits,
                       const ingest::Vocabulary& vocabulary, const std::optional<TimeZone>& zone) {
  const std::size_t steps = history.regular.clock.steps;
  LimitedHistory result;
  twin::StepMarks accessible(steps, 1);
  twin::StepMarks known(steps, 1);
  std::vector<twin::StepMarks> holds;
  for (const SeriesLimit& limit : limits) {
    const auto found = std::find(history.wanted.begin(), history.wanted.end(), limit.variable);
    expects(found != history.wanted.end(), "the history was loaded for this limit");
    const auto s = static_cast<std::size_t>(found - history.wanted.begin());
    const std::vector<double> shares =
        limit.table ? shares_of(limit, history) : std::vector<double>();
    const std::vector<double>& values = limit.table ? shares : history.regular.values[s];
    const twin::Bound bound = limit.table ? twin::Bound{twin::BoundSide::at_most, 1}
                                          : bound_on(limit, history.series[s], vocabulary);
    twin::StepMarks& marks = holds.emplace_back(steps, 1);
    twin::keep_within(bound, values, marks);
    twin::keep_within(bound, values, accessible);
    twin::keep_known(values, known);
  }
  for (const twin::StepMarks& marks : holds) {
    LimitShare share;
    for (std::size_t i = 0; i < steps; ++i) share.holds += marks[i];
    result.shares.push_back(share);
  }
  for (std::size_t i = 0; i < steps; ++i) {
    if (accessible[i] != 0 || known[i] == 0) continue;
    const auto broken = std::count_if(holds.begin(), holds.end(),
                                      [&](const twin::StepMarks& marks) { return marks[i] == 0; });
    if (broken != 1) continue;
    for (std::size_t l = 0; l < holds.size(); ++l)
      result.shares[l].stops_alone += holds[l][i] == 0 ? 1 : 0;
  }
  result.access.steps = steps;
  result.access.step_h = history.regular.clock.step_h();
  result.access.windows = twin::runs_of(accessible);
  result.access.missing = twin::outside(twin::runs_of(known), steps);
  result.access.months = twin::months_of(history.regular.clock, zone);
  return result;
}

}  // namespace slackwater::api
