// A log read part by part, as somebody writes it, is the log read as a whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "ingest/ais/read_ais.h"
#include "tests/support/ais_table_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::ais_part_test {
namespace {

using namespace ingest;

std::vector<std::string> said(const std::filesystem::path& file, const AisPart& part) {
  std::vector<std::string> all;
  (void)read_ais_part(file, part, [&](const AisReport& report) {
    all.push_back(std::to_string(report.mmsi) + " " + std::to_string(report.type) + " " +
                  (report.time ? format_utc(*report.time) : "-"));
  });
  return all;
}

TEST(AisPart, IsTheLinesThatBeginInIt) {
  TemporaryFolder folder;
  const auto file = folder / "table.csv";
  std::string text = ais_table_head;
  std::vector<std::size_t> begins;
  for (unsigned i = 1; i <= 5; ++i) {
    begins.push_back(text.size());
    AisRow row;
    row.mmsi = i;
    text += ais_line(row);
  }
  std::ofstream(file) << text;
  EXPECT_EQ(said(file, {}).size(), 5U);
  EXPECT_EQ(said(file, {1, text.size()}).size(), 5U) << "the head is no row";
  EXPECT_EQ(said(file, {begins[2], text.size()}).size(), 3U);
  EXPECT_EQ(said(file, {begins[2] + 1, text.size()}).size(), 2U);
  EXPECT_EQ(said(file, {begins[2], begins[4]}).size(), 2U);
  EXPECT_EQ(said(file, {begins[2], begins[4] + 7}).size(), 2U) << "a row that is not whole";
  EXPECT_EQ(said(file, {text.size(), text.size()}).size(), 0U);
  EXPECT_EQ(said(file, {text.size() + 999, text.size() + 2000}).size(), 0U);
}

TEST(AisPart, WithoutMessagesIsNoError) {
  TemporaryFolder folder;
  std::ofstream(folder / "empty.nmea");
  EXPECT_EQ(read_ais_part(folder / "empty.nmea", {}, [](const AisReport&) {}).messages, 0U);
  std::ofstream(folder / "words.nmea") << "# the receiver starts\n";
  EXPECT_EQ(read_ais_part(folder / "words.nmea", {}, [](const AisReport&) {}).messages, 0U);
}

TEST(AisPart, OfRealLogsGiveTheWholeWhereTheyLapOver) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto file = shared / "data/ais/danish_shore_station_2010-06-11.nmea";
  std::vector<std::string> whole = said(file, {});
  const auto size = std::filesystem::file_size(file);
  std::vector<std::string> parts;
  for (std::uint64_t from = 0; from < size; from += 100'000) {
    const std::uint64_t lap = 16'384;
    for (const std::string& one : said(file, {from > lap ? from - lap : 0, from + 100'000}))
      parts.push_back(one);
  }
  for (auto* all : {&whole, &parts}) {
    std::sort(all->begin(), all->end());
    all->erase(std::unique(all->begin(), all->end()), all->end());
  }
  EXPECT_GT(whole.size(), 2000U);
  // Of a message cut in two at a lap's end the first part may come without its stamp.
  std::erase_if(parts, [](const std::string& one) { return one.ends_with(" -"); });
  EXPECT_EQ(parts, whole);
}

}  // namespace
}  // namespace slackwater::tests::ais_part_test
