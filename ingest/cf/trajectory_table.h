#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace slackwater::ingest {

/// A list that belongs to a file of tracks and is not of each track and time, such as what happened
/// on the way: columns over a dimension of its own. In the file column `begin` of table `alarm` is
/// the variable `alarm_begin(alarm)`.
struct TrajectoryTable {
  struct Column {
    std::string name;
    std::string units;
    std::string long_name;
    std::vector<double> values;  ///< a row each; NaN: none
  };
  struct TextColumn {
    std::string name;
    std::string long_name;
    std::vector<std::string> values;
  };
  std::string name;
  std::vector<Column> columns;
  std::vector<TextColumn> texts;

  [[nodiscard]] std::size_t rows() const noexcept;
  /// Nothing where there is no such column.
  [[nodiscard]] const std::vector<double>* column(std::string_view name) const noexcept;
  [[nodiscard]] const std::vector<std::string>* text(std::string_view name) const noexcept;
};

}  // namespace slackwater::ingest
