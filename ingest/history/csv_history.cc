#include "ingest/history/csv_history.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <string_view>

#include "fields/base/advice.h"
#include "fields/base/constants.h"
#include "fields/base/encode/csv.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/units.h"
#include "ingest/history/ndbc.h"
#include "ingest/history/observation_table.h"
#include "ingest/history/read_wanted.h"
#include "ingest/history/sentinels.h"
#include "ingest/history/written_time.h"

namespace slackwater::ingest {
namespace {

using constants::nan;

std::string shown(std::string_view text) {
  constexpr std::size_t enough = 60;
  return "'" + std::string(text.substr(0, enough)) + (text.size() > enough ? "…'" : "'");
}

/// The cells of the columns that are read, of one line after the other.
class Row {
 public:
  /// @param columns  how many the head has
  /// @param by_blanks  blanks lie between the cells, not commas
  explicit Row(std::size_t columns, bool by_blanks = false)
      : columns_(columns), by_blanks_(by_blanks) {}

  /// @throws Error(invalid_input) for a line with another number of cells than the head
  void read(std::string_view line) {
    cells_.clear();
    quoted_.clear();
    if (by_blanks_) {
      quoted_ = blank_separated(line);
      cells_.assign(quoted_.begin(), quoted_.end());
    } else if (line.find('"') == std::string_view::npos) {
      for (std::size_t from = 0;;) {
        const std::size_t comma = line.find(',', from);
        cells_.push_back(trimmed(line.substr(from, comma - from)));
        if (comma == std::string_view::npos) break;
        from = comma + 1;
      }
    } else {
      auto cells = csv_cells(line);
      if (!cells) refuse("found a quote that is not closed; expected \" in pairs");
      quoted_ = std::move(*cells);
      cells_.assign(quoted_.begin(), quoted_.end());
    }
    if (cells_.size() != columns_)
      refuse(formatted("found {} cells, expected {} as in the line of names", cells_.size(),
                       columns_));
  }
  [[nodiscard]] std::string_view operator[](std::size_t column) const { return cells_[column]; }

 private:
  std::size_t columns_;
  bool by_blanks_;
  std::vector<std::string_view> cells_;
  std::vector<std::string> quoted_;
};

bool is_missing(std::string_view cell) {
  constexpr std::array<std::string_view, 9> words{"",    "-",    "--",   "na", "n/a",
                                                  "nan", "null", "none", "mm"};
  const std::string lower = lower_case(cell);
  return std::find(words.begin(), words.end(), lower) != words.end();
}

/// NaN for a missing one.
double number_in(std::string_view cell, const std::string& column) {
  std::string_view digits = cell;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, problem] = std::from_chars(digits.data(), end, value);
  if (problem == std::errc{} && stop == end && !digits.empty())
    return std::isfinite(value) ? value : nan;
  if (is_missing(cell)) return nan;
  const auto meant = with_decimal_point(cell);
  refuse(
      "column '" + column + "': found " + shown(cell) + ", expected a number" +
      (meant ? " with a decimal point, as " + *meant : "; a cell without a value is empty or NA"));
}

bool is_number(std::string_view cell) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  double value = 0;
  const char* const end = cell.data() + cell.size();
  const auto [stop, problem] = std::from_chars(cell.data(), end, value);
  return problem == std::errc{} && stop == end && !cell.empty();
}

/// Whether UDUNITS knows it: "m", "m s-1", "degree".
bool is_unit(const std::string& cell) {
  try {
    // Not to itself: what is the same is not looked up.
    static_cast<void>(unit_conversion(cell, "(" + cell + ")", "unit"));
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// "wind_speed [m/s]", or `wind_speed[unit="m/s"]` as THREDDS writes it, as name and unit.
Offer offer_of(const std::string& head) {
  const std::size_t open = head.find_first_of("[(");
  if (open == std::string::npos || head.find_first_of("])", open) != head.size() - 1)
    return {head, head, ""};
  std::string_view unit = trimmed(std::string_view(head).substr(open + 1, head.size() - open - 2));
  if (unit.starts_with("unit=\"") && unit.ends_with('"') && unit.size() > 6)
    unit = unit.substr(6, unit.size() - 7);
  return {head, std::string(trimmed(std::string_view(head).substr(0, open))), std::string(unit)};
}

class CsvHistory {
 public:
  CsvHistory(const std::filesystem::path& file, const HistoryOptions& options,
             const Vocabulary& vocabulary)
      : file_(file), in_(file, std::ios::binary), options_(options), vocabulary_(vocabulary) {
    read_head();
    read_units();
    find_offers();
  }
  [[nodiscard]] const std::vector<std::string>& head() const noexcept { return head_; }

  HistoryOfFile read(const std::vector<std::string>& wanted) {
    HistoryOfFile answer;
    answer.columns = head_;
    answer.offered = names_offered(offers_, options_);
    answer.warnings = made_apart(wanted, offers_, vocabulary_);
    std::vector<std::optional<Making>> makings;
    for (const std::string& name : wanted) makings.push_back(making_of(name, offers_, vocabulary_));
    for (const auto& making : makings) answer.series.push_back(begun(making));
    read_columns(makings);
    for (HistorySeries& column : columns_) find_missing(column, answer.warnings);
    for (std::size_t i = 0; i < makings.size(); ++i) {
      auto& series = answer.series[i];
      if (!series) continue;
      fill(*series, *makings[i]);
      const std::string told = reject_beyond_belief(*series, vocabulary_);
      if (!told.empty()) answer.warnings.push_back(told);
    }
    return answer;
  }

 private:
  bool next_line() {
    if (is_held_) {
      is_held_ = false;
      return true;
    }
    if (!std::getline(in_, line_)) return false;
    ++number_;
    if (line_.find('\0') != std::string::npos)
      refuse(formatted("line {}: found bytes that are no text; expected a CSV table or NetCDF",
                       number_));
    return true;
  }

  /// The next line gives this one again.
  void hold_line() { is_held_ = true; }

  /// Whether cells are those of a row: a time or numbers stand among them.
  static bool are_values(const std::vector<std::string>& cells) {
    return std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
      return is_number(cell) || read_written_time(cell).has_value();
    });
  }

  void read_head() {
    std::string comment;
    while (next_line()) {
      std::string_view line = line_;
      if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
      line = trimmed(line);
      if (is_ndbc_head(line)) {
        is_ndbc_ = true;
        head_ = blank_separated(line);
        return;
      }
      if (line.starts_with('#')) comment = line.substr(1);
      if (line.empty() || line.starts_with('#')) continue;
      const auto cells = csv_cells(line);
      if (!cells)
        refuse(
            formatted("line {}: found a quote that is not closed; expected \" in pairs", number_));
      head_ = *cells;
      if (const auto names = csv_cells(trimmed(comment)); names && names->size() == cells->size() &&
                                                          cells->size() > 1 && are_values(*cells) &&
                                                          !are_values(*names)) {
        head_ = *names;
        hold_line();
        return;
      }
      if (head_.size() == 1 && line.find_first_of(";\t") != std::string_view::npos)
        refuse(
            formatted("line {}: found {}, expected names of columns with commas between them; "
                      "semicolons and tabs are not read",
                      number_, shown(line)));
      return;
    }
    refuse("found no line of column names; the file is empty");
  }

  /// Whether a line behind the names holds units: no time, no number but 1, and either what ERDDAP
  /// puts over times or, over all columns but one, nothing but units.
  [[nodiscard]] bool are_units(const std::vector<std::string>& cells) const {
    if (cells.size() != head_.size()) return false;
    std::size_t units = 0;
    std::size_t others = 0;
    for (const std::string& cell : cells) {
      if (read_written_time(cell) || (is_number(cell) && cell != "1")) return false;
      if (cell == "UTC") return true;
      if (is_missing(cell) || cell == "1") continue;
      ++(is_unit(cell) ? units : others);
    }
    return units > 0 && others <= 1;
  }

  /// A line of units behind the names, as ERDDAP and NDBC write it.
  void read_units() {
    if (is_ndbc_) return;  // the units of NDBC are known, its line begins with #
    while (next_line()) {
      const std::string_view line = trimmed(line_);
      if (line.empty() || line.starts_with('#')) continue;
      const auto cells = csv_cells(line);
      if (cells && are_units(*cells)) {
        units_ = *cells;
        for (std::string& unit : units_)
          if (is_missing(unit)) unit.clear();
      } else {
        hold_line();
      }
      return;
    }
  }

  void find_offers() {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < head_.size(); ++c) {
      const auto named =
          std::find_if(options_.columns.begin(), options_.columns.end(),
                       [&](const NamedColumn& column) { return column.column == head_[c]; });
      const NdbcColumn* ndbc = ndbc_column(head_[c]);
      Offer offer = offer_of(head_[c]);
      if (offer.unit.empty() && !units_.empty()) offer.unit = units_[c];
      if (is_ndbc_ && ndbc != nullptr)
        offer = {head_[c], std::string(ndbc->standard_name), std::string(ndbc->unit)};
      if (named != options_.columns.end())
        offer = {head_[c], named->standard_name, named->unit.empty() ? offer.unit : named->unit,
                 true};
      else if (vocabulary_.by_standard_name(offer.standard_name) == nullptr)
        continue;
      offer.standard_name = current_name(offer.standard_name, vocabulary_);
      const Quantity* known = vocabulary_.by_standard_name(offer.standard_name);
      if (offer.unit.empty() && known != nullptr) offer.unit = known->unit;
      offers_.push_back(std::move(offer));
      column_of_offer_.push_back(c);
      missing_of_offer_.push_back(ndbc == nullptr ? std::nullopt : std::optional(ndbc->missing));
    }
  }

  [[nodiscard]] std::size_t time_column() const {
    constexpr std::array<std::string_view, 6> usual{"time",      "datetime",   "date_time",
                                                    "timestamp", "valid_time", "date"};
    const auto find = [&](std::string_view name) {
      return std::find_if(head_.begin(), head_.end(), [&](const std::string& column) {
        return options_.time_column.empty() ? lower_case(offer_of(column).standard_name) == name
                                            : column == name;
      });
    };
    auto found = head_.end();
    if (!options_.time_column.empty()) {
      found = find(options_.time_column);
    } else {
      for (const std::string_view name : usual)
        if (found == head_.end()) found = find(name);
    }
    if (found != head_.end()) return static_cast<std::size_t>(found - head_.begin());
    refuse("found the columns " + joined(head_, ", ") + ", expected one of times" +
           (options_.time_column.empty() ? "; name it with --time-column"
                                         : " called '" + options_.time_column + "'" +
                                               did_you_mean(options_.time_column, head_)));
  }

  std::optional<HistorySeries> begun(const std::optional<Making>& making) const {
    if (!making) return std::nullopt;
    HistorySeries series;
    const Offer& first = offers_[making->first];
    series.name = first.name;
    series.standard_name = first.standard_name;
    series.unit = first.unit;
    series.source = file_.string();
    if (making->second) {
      const Offer& second = offers_[*making->second];
      series.name += " and " + second.name;
      series.standard_name = making->standard_name;
      if (first.unit != second.unit)
        refuse("columns '" + first.name + "' and '" + second.name + "': found units '" +
               first.unit + "' and '" + second.unit + "', expected the same for both components");
    }
    if (series.unit.empty())
      refuse("column '" + first.name + "' (" + first.standard_name +
             "): found no unit; name it, as --column '" + first.name + "=" + first.standard_name +
             ":UNIT'");
    if (making->second && making->part != VectorPart::speed) series.unit = "degree";
    return series;
  }

  UtcTime time_in(std::string_view cell) const {
    const auto time = read_written_time(cell);
    if (!time)
      refuse("found " + shown(cell) +
             " where a time was expected; write it as "
             "2002-01-01T00:00Z or 2002-01-01T01:00+01:00");
    if (!time->offset && !options_.assume_utc && !times_are_utc_)
      refuse("found " + shown(cell) +
             ", a time without a zone: it may be local time; expected a Z or an offset behind it. "
             "If the times are UTC say --assume-utc");
    return time->utc();
  }

  /// Reads the columns of which something is made, as they stand.
  void read_columns(const std::vector<std::optional<Making>>& makings) {
    std::vector<bool> is_read(offers_.size(), false);
    for (const auto& making : makings) {
      if (!making) continue;
      is_read[making->first] = true;
      if (making->second) is_read[*making->second] = true;
    }
    columns_.resize(offers_.size());
    std::vector<std::size_t> offers;
    for (std::size_t i = 0; i < offers_.size(); ++i) {
      if (!is_read[i]) continue;
      offers.push_back(i);
      columns_[i].name = offers_[i].name;
      columns_[i].standard_name = offers_[i].standard_name;
      columns_[i].unit = offers_[i].unit;
    }
    if (!offers.empty()) read_rows(offers);
  }

  /// Takes out of a column what stands for "not measured"; before a speed is made of two, which
  /// would hide it.
  void find_missing(HistorySeries& column, std::vector<std::string>& warnings) const {
    if (column.value.empty()) return;
    const auto index = static_cast<std::size_t>(&column - columns_.data());
    const auto tell = [&](const std::vector<std::string>& all) {
      warnings.insert(warnings.end(), all.begin(), all.end());
    };
    if (const std::optional<double>& code = missing_of_offer_[index])
      tell(take_as_missing(column, {&*code, 1}, "NDBC's table of codes"));
    tell(take_as_missing(column, options_.missing, "--missing"));
    tell(reject_sentinels(column));
    if (is_ndbc_ && column.standard_name.starts_with("wind_speed"))
      warnings.push_back("'" + column.name +
                         "': NDBC measures wind at the buoy's anemometer, 3 to 5 m up on most, and "
                         "not at 10 m; a wind at 10 m is stronger");
  }

  void fill(HistorySeries& series, const Making& making) const {
    const HistorySeries& first = columns_[making.first];
    series.time = first.time;
    series.value = first.value;
    if (!making.second) return;
    for (std::size_t t = 0; t < series.value.size(); ++t)
      series.value[t] = part_of(making.part, first.value[t], columns_[*making.second].value[t]);
  }

  void read_rows(const std::vector<std::size_t>& offers) {
    const std::size_t time_at = is_ndbc_ ? 0 : time_column();
    times_are_utc_ =
        offer_of(head_[time_at]).unit == "UTC" || (!units_.empty() && units_[time_at] == "UTC");
    Row row(head_.size(), is_ndbc_);
    std::vector<UtcTime> times;
    bool newest_first = false;
    while (next_line()) {
      const std::string_view line = trimmed(line_);
      if (line.empty() || line.front() == '#') continue;
      with_context("line " + std::to_string(number_), [&] {
        row.read(line_);
        const UtcTime time = is_ndbc_ ? ndbc_time_in(row) : time_in(row[time_at]);
        if (is_ndbc_ && times.size() == 1) newest_first = time < times.back();
        if (newest_first ? time >= times.back() : !times.empty() && time <= times.back())
          refuse((time == times.back() ? "duplicate time " : "time runs backward: ") +
                 format_utc(time) + " after " + format_utc(times.back()) +
                 "; expected times that ascend: sort the table and drop duplicates");
        times.push_back(time);
        for (const std::size_t i : offers)
          columns_[i].value.push_back(number_in(row[column_of_offer_[i]], offers_[i].name));
      });
    }
    if (newest_first) std::reverse(times.begin(), times.end());
    for (const std::size_t i : offers) {
      if (newest_first) std::reverse(columns_[i].value.begin(), columns_[i].value.end());
      columns_[i].time = times;
    }
  }

  /// The first columns: year (of two digits before 1999), month, day, hour and, from 2005 on,
  /// minute; UTC.
  [[nodiscard]] UtcTime ndbc_time_in(const Row& row) const {
    std::string text;
    constexpr std::array<std::string_view, 5> before{"", "-", "-", "T", ":"};
    for (std::size_t i = 0; i < before.size(); ++i) {
      std::string part = i == 4 && head_[4] != "mm" ? "00" : std::string(row[i]);
      if (i == 0 && part.size() == 2) part = "19" + part;
      if (i > 0 && part.size() == 1) part = "0" + part;
      text.append(before[i]).append(part);
    }
    const auto time = read_written_time(text);
    if (!time)
      refuse("found " + shown(text) + " where year, month, day, hour and minute were expected");
    return time->clock;
  }

  std::filesystem::path file_;
  std::ifstream in_;
  const HistoryOptions& options_;
  const Vocabulary& vocabulary_;
  std::string line_;
  std::size_t number_ = 0;
  bool is_held_ = false;
  bool is_ndbc_ = false;
  bool times_are_utc_ = false;
  std::vector<std::string> units_;  ///< of the line behind the names; empty: there is none
  std::vector<std::string> head_;
  std::vector<Offer> offers_;
  std::vector<std::size_t> column_of_offer_;
  std::vector<std::optional<double>> missing_of_offer_;  ///< NDBC's number for "not measured"
  std::vector<HistorySeries> columns_;                   ///< one an offer; empty: nobody wants it
};

}  // namespace

HistoryOfFile read_csv_history(const std::filesystem::path& file,
                               const std::vector<std::string>& wanted,
                               const HistoryOptions& options, const Vocabulary& vocabulary) {
  CsvHistory table(file, options, vocabulary);
  if (is_observation_table(table.head()))
    return read_observation_table(file, wanted, options, vocabulary);
  return table.read(wanted);
}

}  // namespace slackwater::ingest
