#include "fields/base/encode/csv.h"

#include <gtest/gtest.h>

#include <limits>

namespace slackwater::csv_test {
namespace {

using Cells = std::vector<std::string>;

TEST(Csv, CellsComeBackAsTheyWereWritten) {
  const Cells cells{"A1", "", "north, of \"B\"", " x", "é"};
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
  // An unquoted cell loses the blanks around it, which spreadsheets add.
  EXPECT_EQ(csv_cells(line), (Cells{"A1", "", "north, of \"B\"", "x", "é"}));
  EXPECT_EQ(csv_cells(line + "\r"), (Cells{"A1", "", "north, of \"B\"", "x", "é"}));
}

TEST(Csv, AnEmptyLineIsOneEmptyCellAndACommaAtTheEndBeginsAnother) {
  EXPECT_EQ(csv_cells(""), Cells{""});
  EXPECT_EQ(csv_cells("a,"), (Cells{"a", ""}));
  EXPECT_EQ(csv_cells("\"a\" ,b"), (Cells{"a", "b"}));
}

TEST(Csv, AQuoteThatStaysOpenIsNoLine) {
  EXPECT_EQ(csv_cells("a,\"b"), std::nullopt);
  EXPECT_EQ(csv_cells("\"\"\""), std::nullopt);
}

TEST(Csv, NumbersReadBackAsTheSameAndWhatIsNoneIsEmpty) {
  EXPECT_EQ(std::stod(csv_cell(0.1 + 0.2)), 0.1 + 0.2);
  EXPECT_EQ(csv_cell(3.0), "3");
  EXPECT_EQ(csv_cell(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(csv_cell(std::numeric_limits<double>::infinity()), "");
}

}  // namespace
}  // namespace slackwater::csv_test
