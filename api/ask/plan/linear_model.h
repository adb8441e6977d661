#pragma once
#include <cstddef>
#include <limits>
#include <vector>

namespace slackwater::api {

/// A column with its coefficient in a row.
struct LinearTerm {
  std::size_t column = 0;
  double factor = 1;
};
using LinearTerms = std::vector<LinearTerm>;

/// Maximise a linear function of columns within bounds, rows and whole numbers.
struct LinearModel {
  struct Column {
    double worth = 0;
    double least = 0;
    double most = 1;
    bool is_whole = true;
  };
  struct Row {
    LinearTerms terms;  ///< each column once
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
  };
  std::vector<Column> columns;
  std::vector<Row> rows;

  std::size_t add(const Column& column) {
    columns.push_back(column);
    return columns.size() - 1;
  }
  void at_most(LinearTerms terms, double most) {
    rows.push_back({std::move(terms), -std::numeric_limits<double>::infinity(), most});
  }
  void equal(LinearTerms terms, double value) { rows.push_back({std::move(terms), value, value}); }
};

}  // namespace slackwater::api
