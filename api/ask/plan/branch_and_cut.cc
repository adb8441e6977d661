#include "api/ask/plan/branch_and_cut.h"

#include <coin/Cbc_C_Interface.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

struct DeleteModel {
  void operator()(Cbc_Model* model) const noexcept { Cbc_deleteModel(model); }
};
using Solver = std::unique_ptr<Cbc_Model, DeleteModel>;

/// The terms column by column, as CBC takes them.
struct ColumnMatrix {
  std::vector<CoinBigIndex> begin;
  std::vector<int> row;
  std::vector<double> factor;
};

ColumnMatrix columns_of(const LinearModel& model) {
  ColumnMatrix matrix;
  matrix.begin.assign(model.columns.size() + 1, 0);
  for (const LinearModel::Row& row : model.rows)
    for (const LinearTerm& term : row.terms) ++matrix.begin[term.column + 1];
  std::partial_sum(matrix.begin.begin(), matrix.begin.end(), matrix.begin.begin());
  matrix.row.resize(static_cast<std::size_t>(matrix.begin.back()));
  matrix.factor.resize(matrix.row.size());
  std::vector<CoinBigIndex> next = matrix.begin;
  for (std::size_t r = 0; r < model.rows.size(); ++r) {
    for (const LinearTerm& term : model.rows[r].terms) {
      const auto at = static_cast<std::size_t>(next[term.column]++);
      matrix.row[at] = static_cast<int>(r);
      matrix.factor[at] = term.factor;
    }
  }
  return matrix;
}

template <typename Items, typename Pick>
std::vector<double> picked(const Items& items, Pick pick) {
  std::vector<double> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(pick(item));
  return values;
}

Solver loaded(const LinearModel& model) {
  Solver solver(Cbc_newModel());
  const ColumnMatrix matrix = columns_of(model);
  const auto least = picked(model.columns, [](const auto& column) { return column.least; });
  const auto most = picked(model.columns, [](const auto& column) { return column.most; });
  const auto worth = picked(model.columns, [](const auto& column) { return column.worth; });
  const auto row_least = picked(model.rows, [](const auto& row) { return row.least; });
  const auto row_most = picked(model.rows, [](const auto& row) { return row.most; });
  Cbc_loadProblem(solver.get(), static_cast<int>(model.columns.size()),
                  static_cast<int>(model.rows.size()), matrix.begin.data(), matrix.row.data(),
                  matrix.factor.data(), least.data(), most.data(), worth.data(), row_least.data(),
                  row_most.data());
  Cbc_setObjSense(solver.get(), -1);
  for (std::size_t c = 0; c < model.columns.size(); ++c)
    if (model.columns[c].is_whole) Cbc_setInteger(solver.get(), static_cast<int>(c));
  return solver;
}

}  // namespace

LinearAnswer maximise(const LinearModel& model, double time_limit_s) {
  expects(time_limit_s > 0, "a search takes time");
  LinearAnswer answer;
  // CBC takes a model without rows for one without an answer.
  if (model.rows.empty()) {
    for (const LinearModel::Column& column : model.columns) {
      answer.values.push_back(column.worth > 0 ? column.most : column.least);
      answer.bound += column.worth * answer.values.back();
    }
    answer.is_proven = true;
    return answer;
  }
  const Solver solver = loaded(model);
  const auto set = [&](const char* name, const std::string& value) {
    Cbc_setParameter(solver.get(), name, value.c_str());
  };
  Cbc_setLogLevel(solver.get(), 0);
  set("slogLevel", "0");
  set("timeMode", "elapsed");
  set("seconds", formatted("{:.3f}", time_limit_s));
  set("threads", "0");
  set("randomSeed", "2025");
  set("randomCbcSeed", "2025");
  // Its rows are tight as they come: to work them over takes longer than to solve them.
  set("preprocess", "off");
  set("ratioGap", "0");
  set("allowableGap", "0");
  Cbc_solve(solver.get());
  if (Cbc_isProvenInfeasible(solver.get()) || Cbc_isContinuousUnbounded(solver.get()) ||
      Cbc_isAbandoned(solver.get()))
    throw Error(ErrorKind::internal, "the search for a plan found no answer at all");
  const double* values = Cbc_bestSolution(solver.get());
  answer.is_proven = Cbc_isProvenOptimal(solver.get()) != 0 && values != nullptr;
  double worth = 0;
  if (values != nullptr) {
    answer.values.assign(values, values + model.columns.size());
    for (std::size_t c = 0; c < model.columns.size(); ++c)
      worth += model.columns[c].worth * values[c];
  }
  // What was found cannot be worth more than the bound but for rounding.
  answer.bound =
      answer.is_proven ? worth : std::max(worth, Cbc_getBestPossibleObjValue(solver.get()));
  return answer;
}

std::string solver_name() { return std::string("CBC ") + Cbc_getVersion(); }

}  // namespace slackwater::api
