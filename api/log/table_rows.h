#pragma once
#include <span>
#include <string>
#include <vector>

#include "fields/base/check.h"
#include "ingest/cf/trajectory_table.h"

namespace slackwater::api {

/// A table of a log that is filled row by row; its columns are known beforehand.
class TableRows {
 public:
  TableRows(std::string name, std::vector<ingest::TrajectoryTable::Column> columns,
            std::vector<ingest::TrajectoryTable::TextColumn> texts = {}) {
    table_.name = std::move(name);
    table_.columns = std::move(columns);
    table_.texts = std::move(texts);
  }
  void add(std::span<const double> numbers, std::initializer_list<std::string> texts = {}) {
    expects(numbers.size() == table_.columns.size() && texts.size() == table_.texts.size(),
            "a value for each column");
    for (std::size_t c = 0; c < numbers.size(); ++c) table_.columns[c].values.push_back(numbers[c]);
    auto column = table_.texts.begin();
    for (const std::string& text : texts) (column++)->values.push_back(text);
  }
  void add(std::initializer_list<double> numbers, std::initializer_list<std::string> texts = {}) {
    add(std::span<const double>(numbers.begin(), numbers.size()), texts);
  }
  [[nodiscard]] ingest::TrajectoryTable take() { return std::move(table_); }

 private:
  ingest::TrajectoryTable table_;
};

}  // namespace slackwater::api
