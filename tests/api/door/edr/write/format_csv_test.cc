#include "api/door/edr/write/format_csv.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "api/door/edr/write/body.h"
#include "api/door/edr/write/describe.h"
#include "tests/api/door/edr/made_up_answer.h"

namespace slackwater::api::edr::format_csv_test {
namespace {

using tests::made_up_answer;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find("\r\n", start);
    all.push_back(text.substr(start, end - start));
    start = end + 2;
  }
  return all;
}

TEST(Csv, TheHeaderNamesColumnsAndUnits) {
  const auto rows = lines(csv(made_up_answer(DomainType::point)));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0],
            "longitude,latitude,depth_m,time,eastward_sea_water_velocity [m/s],"
            "northward_sea_water_velocity [m/s],eastward_sea_water_velocity_p10 [m/s]");
  EXPECT_EQ(rows[1], "2.45,57.25,10,2025-03-10T00:00:00Z,0,,0.25");
}

TEST(Csv, RowsRunOverTimeLevelRowAndColumn) {
  const auto rows = lines(csv(made_up_answer(DomainType::grid)));
  ASSERT_EQ(rows.size(), 1U + 48U);
  EXPECT_EQ(rows[2], "2.55,57.25,0.5,2025-03-10T00:00:00Z,-0.001,0.124,0.249");
  EXPECT_EQ(rows[4], "2.45,57.3125,0.5,2025-03-10T00:00:00Z,-0.003,0.122,0.247");
  EXPECT_EQ(rows[48], "2.65,57.3125,30.5,2025-03-10T01:00:00Z,-0.047,0.078,0.203");
}

TEST(Csv, ATrajectoryIsARowPerVertexAndCoveragesFollowEachOther) {
  const auto rows = lines(csv(made_up_answer(DomainType::trajectory, 2)));
  ASSERT_EQ(rows.size(), 11U);
  EXPECT_EQ(rows[5], "2.4993827,57.29,20,2025-03-10T04:00:00Z,-0.004,0.121,0.246");
  EXPECT_TRUE(rows[6].starts_with("3.45,57.25,0,2025-03-10T00:00:00Z,1,,"));
}

TEST(Csv, AnAxisThatIsNotThereHasNoColumn) {
  Answer answer = made_up_answer(DomainType::point);
  answer.coverages[0].time.clear();
  answer.coverages[0].vertical_m.clear();
  EXPECT_TRUE(csv(answer).starts_with("longitude,latitude,eastward"));
  answer = made_up_answer(DomainType::point);
  answer.vertical = Vertical::height_up;
  EXPECT_TRUE(csv(answer).starts_with("longitude,latitude,height_m,time,"));
}

TEST(Csv, ANameThatWouldBreakTheRowIsQuoted) {
  Answer answer = made_up_answer(DomainType::point);
  answer.parameters.resize(1);
  answer.coverages[0].values.resize(1);
  answer.parameters[0].name = "a,\"b\"";
  EXPECT_TRUE(lines(csv(answer))[0].ends_with(R"(,"a,""b"" [m/s]")"));
}

TEST(Csv, ProvenanceTravelsInHeadersThatCannotBeBroken) {
  Answer answer = made_up_answer(DomainType::point);
  answer.provenance.headline = "late\r\nSet-Cookie: x=100%";
  const Body body = write_answer(answer, Format::csv);
  EXPECT_EQ(body.media_type, "text/csv; charset=utf-8; header=present");
  const auto header = [&](const std::string& name) {
    const auto found = std::find_if(body.headers.begin(), body.headers.end(),
                                    [&](const auto& each) { return each.first == name; });
    return found == body.headers.end() ? "absent" : found->second;
  };
  EXPECT_EQ(header("Slackwater-Headline"), "late%0D%0ASet-Cookie: x=100%25");
  EXPECT_EQ(header("Slackwater-Attribution"),
            "%C2%A9 E.U. Copernicus Marine Service Information; MET Norway, \"CC BY\" 4.0");
  EXPECT_EQ(header("Slackwater-Degraded"), "true");
  EXPECT_EQ(header("Slackwater-Note"), "below the bed at 10 m");
}

TEST(Body, EveryFormatHasItsMediaType) {
  const Answer answer = made_up_answer(DomainType::vertical_profile);
  for (const Format format : answer_formats()) {
    const Body body = write_answer(answer, format);
    EXPECT_TRUE(body.media_type.starts_with(media_type_of(format)));
    EXPECT_FALSE(body.bytes.empty());
  }
}

}  // namespace
}  // namespace slackwater::api::edr::format_csv_test
