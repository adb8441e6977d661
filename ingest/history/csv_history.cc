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
#include "fields/base/csv.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/history/beyond_belief.h"
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
  explicit Row(std::size_t columns) : columns_(columns) {}

  /// @throws Error(invalid_input) for a line with another number of cells than the head
  void read(std::string_view line) {
    cells_.clear();
    quoted_.clear();
    if (line.find('"') == std::string_view::npos) {
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
  std::vector<std::string_view> cells_;
  std::vector<std::string> quoted_;
};

bool is_missing(std::string_view cell) {
  constexpr std::array<std::string_view, 8> words{"",    "-",   "--",   "na",
                                                  "n/a", "nan", "null", "none"};
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

/// "wind_speed [m/s]" as name and unit.
Offer offer_of(const std::string& head) {
  const std::size_t open = head.find_first_of("[(");
  if (open == std::string::npos || head.find_first_of("])", open) != head.size() - 1)
    return {head, head, ""};
  return {head, std::string(trimmed(std::string_view(head).substr(0, open))),
          std::string(trimmed(std::string_view(head).substr(open + 1, head.size() - open - 2)))};
}

class CsvHistory {
 public:
  CsvHistory(const std::filesystem::path& file, const HistoryOptions& options,
             const Vocabulary& vocabulary)
      : file_(file), in_(file, std::ios::binary), options_(options), vocabulary_(vocabulary) {
    read_head();
    find_offers();
  }

  HistoryOfFile read(const std::vector<std::string>& wanted) {
    HistoryOfFile answer;
    answer.columns = head_;
    for (const Offer& offer : offers_) answer.offered.push_back(offer.standard_name);
    for (const NamedColumn& named : options_.columns) answer.offered.push_back(named.column);
    std::vector<std::optional<Making>> makings;
    for (const std::string& name : wanted) makings.push_back(making_of(name, offers_, vocabulary_));
    for (const auto& making : makings) answer.series.push_back(begun(making));
    if (std::any_of(makings.begin(), makings.end(), [](const auto& m) { return m.has_value(); }))
      read_rows(makings, answer.series);
    for (auto& series : answer.series) {
      if (!series) continue;
      const std::string told = reject_beyond_belief(*series, vocabulary_);
      if (!told.empty()) answer.warnings.push_back(told);
    }
    return answer;
  }

 private:
  bool next_line() {
    if (!std::getline(in_, line_)) return false;
    ++number_;
    if (line_.find('\0') != std::string::npos)
      refuse(formatted("line {}: found bytes that are no text; expected a CSV table or NetCDF",
                       number_));
    return true;
  }

  void read_head() {
    while (next_line()) {
      std::string_view line = line_;
      if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
      line = trimmed(line);
      if (line.empty() || line.starts_with('#')) continue;
      const auto cells = csv_cells(line);
      if (!cells)
        refuse(
            formatted("line {}: found a quote that is not closed; expected \" in pairs", number_));
      head_ = *cells;
      if (head_.size() == 1 && line.find_first_of(";\t") != std::string_view::npos)
        refuse(
            formatted("line {}: found {}, expected names of columns with commas between them; "
                      "semicolons and tabs are not read",
                      number_, shown(line)));
      return;
    }
    refuse("found no line of column names; the file is empty");
  }

  void find_offers() {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < head_.size(); ++c) {
      const auto named =
          std::find_if(options_.columns.begin(), options_.columns.end(),
                       [&](const NamedColumn& column) { return column.column == head_[c]; });
      Offer offer = offer_of(head_[c]);
      if (named != options_.columns.end())
        offer = {head_[c], named->standard_name, named->unit};
      else if (vocabulary_.by_standard_name(offer.standard_name) == nullptr)
        continue;
      offer.standard_name = current_name(offer.standard_name, vocabulary_);
      const Quantity* known = vocabulary_.by_standard_name(offer.standard_name);
      if (offer.unit.empty() && known != nullptr) offer.unit = known->unit;
      offers_.push_back(std::move(offer));
      column_of_offer_.push_back(c);
    }
  }

  [[nodiscard]] std::size_t time_column() const {
    constexpr std::array<std::string_view, 6> usual{"time",      "datetime",   "date_time",
                                                    "timestamp", "valid_time", "date"};
    const auto find = [&](std::string_view name) {
      return std::find_if(head_.begin(), head_.end(), [&](const std::string& column) {
        return options_.time_column.empty() ? lower_case(column) == name : column == name;
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
      series.standard_name =
          first.standard_name == "eastward_wind" ? "wind_speed" : "sea_water_speed";
      if (first.unit != second.unit)
        refuse("columns '" + first.name + "' and '" + second.name + "': found units '" +
               first.unit + "' and '" + second.unit + "', expected the same for both components");
    }
    if (series.unit.empty())
      refuse("column '" + first.name + "' (" + first.standard_name +
             "): found no unit; name it, as --column '" + first.name + "=" + first.standard_name +
             ":UNIT'");
    return series;
  }

  UtcTime time_in(std::string_view cell) const {
    const auto time = read_written_time(cell);
    if (!time)
      refuse("found " + shown(cell) +
             " where a time was expected; write it as "
             "2002-01-01T00:00Z or 2002-01-01T01:00+01:00");
    if (!time->offset && !options_.assume_utc)
      refuse("found " + shown(cell) +
             ", a time without a zone: it may be local time; expected a Z or an offset behind it. "
             "If the times are UTC say --assume-utc");
    return time->utc();
  }

  void read_rows(const std::vector<std::optional<Making>>& makings,
                 std::vector<std::optional<HistorySeries>>& series) {
    const std::size_t time_at = time_column();
    Row row(head_.size());
    std::vector<UtcTime> times;
    while (next_line()) {
      const std::string_view line = trimmed(line_);
      if (line.empty() || line.front() == '#') continue;
      with_context("line " + std::to_string(number_), [&] {
        row.read(line_);
        const UtcTime time = time_in(row[time_at]);
        if (!times.empty() && time <= times.back())
          refuse((time == times.back() ? "duplicate time " : "time runs backward: ") +
                 format_utc(time) + " after " + format_utc(times.back()) +
                 "; expected times that ascend: sort the table and drop duplicates");
        times.push_back(time);
        for (std::size_t i = 0; i < makings.size(); ++i) {
          if (!makings[i]) continue;
          const auto value = [&](std::size_t offer) {
            return number_in(row[column_of_offer_[offer]], offers_[offer].name);
          };
          const double first = value(makings[i]->first);
          series[i]->value.push_back(
              makings[i]->second ? std::hypot(first, value(*makings[i]->second)) : first);
        }
      });
    }
    for (auto& one : series)
      if (one) one->time = times;
  }

  std::filesystem::path file_;
  std::ifstream in_;
  const HistoryOptions& options_;
  const Vocabulary& vocabulary_;
  std::string line_;
  std::size_t number_ = 0;
  std::vector<std::string> head_;
  std::vector<Offer> offers_;
  std::vector<std::size_t> column_of_offer_;
};

}  // namespace

HistoryOfFile read_csv_history(const std::filesystem::path& file,
                               const std::vector<std::string>& wanted,
                               const HistoryOptions& options, const Vocabulary& vocabulary) {
  return CsvHistory(file, options, vocabulary).read(wanted);
}

}  // namespace slackwater::ingest
