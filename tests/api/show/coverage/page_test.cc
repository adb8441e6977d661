#include "api/show/coverage/page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "api/show/rehearse/run_page.h"
#include "tests/api/show/coverage/made_up_inspection.h"

namespace slackwater::tests::page_test {
namespace {

using namespace api;
using ingest::TrajectoryFile;
using nlohmann::json;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++times;
  return times;
}

/// The same to whoever flies, another truth: defects that were missed are gone, false alarms are
/// true, what was found is elsewhere and larger.
TrajectoryFile with_another_truth(TrajectoryFile log) {
  ingest::TrajectoryTable& findings = log.tables[1];
  const auto of = [&](const char* name) -> std::vector<double>& {
    for (auto& column : findings.columns)
      if (column.name == name) return column.values;
    throw std::out_of_range(name);
  };
  for (std::size_t i = 0; i < of("outcome").size();) {
    if (of("outcome")[i] >= 2) {
      for (auto& column : findings.columns)
        column.values.erase(column.values.begin() + static_cast<long>(i));
      continue;
    }
    of("outcome")[i] = 0;
    of("defect")[i] = 7;
    for (const char* name : {"along", "down", "true_x", "true_y", "true_z"}) of(name)[i] = 1;
    for (const char* name : {"true_size", "true_severity"}) of(name)[i] = 77.7;
    ++i;
  }
  return log;
}

TEST(CoveragePage, WithoutTheTruthNothingOfItIsInThePage) {
  const TrajectoryFile log = made_up_inspection();
  EXPECT_EQ(run_page_html(log, "/* library */"),
            run_page_html(with_another_truth(log), "/* library */"));
  EXPECT_NE(run_page_html(log, "", {.shows_truth = true}),
            run_page_html(with_another_truth(log), "", {.shows_truth = true}))
      << "the other truth is another";
}

TEST(CoveragePage, TheTruthTellsWhatWasMissedAndWhy) {
  const std::string hidden = run_page_html(made_up_inspection(), "");
  const std::string shown = run_page_html(made_up_inspection(), "", {.shows_truth = true});
  for (const char* words : {"missed: never seen", "missed: seen too poorly", "missed: overlooked",
                            "false alarm", "Planted and missed"}) {
    EXPECT_EQ(count(hidden, words), 0U) << words;
    EXPECT_GE(count(shown, words), 2U) << words;
  }
}

TEST(CoveragePage, SaysTheSharesInWordsAndTables) {
  const std::string html = run_page_html(made_up_inspection(), "");
  EXPECT_NE(html.find("60 % of 659.7 m2 covered, asked for 90 %"), std::string::npos);
  EXPECT_NE(html.find("covered 60 %"), std::string::npos) << "legend";
  EXPECT_NE(html.find("seen, not well enough 20 %"), std::string::npos);
  EXPECT_NE(html.find("bearing 212°, depth 12.3 m"), std::string::npos)
      << "a finding at 214 degrees, reported 6 cm east and 8 cm south of there";
  EXPECT_NE(html.find("2025-03-10T06:17:24Z"), std::string::npos) << "its time: 60 + 80 x 12.3 s";
  EXPECT_EQ(count(html, "<svg role=\"img\""), 4U) << "a sheet and a still of each surface";
}

TEST(CoveragePage, ARunThatInspectedNothingHasNoSuchSection) {
  TrajectoryFile log = made_up_inspection();
  std::erase_if(log.attributes, [](const auto& a) { return a.first == "inspection"; });
  const std::string html = run_page_html(log, "/* library */");
  EXPECT_EQ(html.find("What was seen"), std::string::npos);
  EXPECT_EQ(html.find("id=\"covered-time\""), std::string::npos);
}

TEST(CoveragePage, TextsFromOutsideCannotBreakThePage) {
  TrajectoryFile log = made_up_inspection();
  std::string& text = log.attributes.back().second;
  text.replace(text.find("ROV camera"), 10, "<script>x()</script>");
  const std::string html = run_page_html(log, "", {.shows_truth = true});
  EXPECT_EQ(html.find("<script>x()"), std::string::npos);
}

TEST(CoveragePage, CoveredAgainstTimeEndsAtTheShareAndNeverFalls) {
  const json all = coverage_json(coverage_in(made_up_inspection()));
  for (const json& pair : all) {
    double last = 0;
    for (const json& point : pair["time"]) {
      EXPECT_GE(point[1].get<double>(), last);
      last = point[1].get<double>();
    }
    EXPECT_LE(pair["time"].size(), 420U);
  }
  EXPECT_NEAR(all[0]["time"].back()[1].get<double>(), 60, 0.01);
  EXPECT_NEAR(all[1]["time"].back()[1].get<double>(), 50, 0.01);
}

TEST(CoveragePage, DetailAgainstRangeHoldsItsQuantilesInOrder) {
  const json all = coverage_json(coverage_in(made_up_inspection()));
  ASSERT_GT(all[0]["range"].size(), 10U);
  for (const json& bin : all[0]["range"]) {
    EXPECT_LE(bin[1].get<double>(), bin[2].get<double>());
    EXPECT_LE(bin[2].get<double>(), bin[3].get<double>());
  }
}

}  // namespace
}  // namespace slackwater::tests::page_test
