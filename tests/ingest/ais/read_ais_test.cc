#include "ingest/ais/read_ais.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/ingest/ais/nmea_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::read_ais_test {
namespace {

using namespace ingest;
using namespace std::chrono_literals;

std::vector<AisReport> reports_in(const std::filesystem::path& file,
                                  AisReading* reading = nullptr) {
  std::vector<AisReport> reports;
  const AisReading read =
      read_ais(file, [&](const AisReport& report) { reports.push_back(report); });
  if (reading != nullptr) *reading = read;
  return reports;
}

/// The PATH, put back afterwards.
class PathOf {
 public:
  explicit PathOf(const std::string& path) : before_(std::getenv("PATH")) {
    ::setenv("PATH", path.c_str(), 1);
  }
  ~PathOf() { ::setenv("PATH", before_.c_str(), 1); }
  PathOf(const PathOf&) = delete;
  PathOf& operator=(const PathOf&) = delete;

 private:
  std::string before_;
};

std::string problem_of(const std::filesystem::path& file, ErrorKind kind,
                       const FilterProgram& decoder = gpsdecode_program()) {
  try {
    (void)read_ais(
        file, [](const AisReport&) {}, decoder);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.message();
    return error.message();
  }
  ADD_FAILURE() << "read without an error";
  return {};
}

// Messages published with their decode: type 1 in gpsd's AIVDM.txt, the others in gpsd's
// test/sample.aivdm; the values stand there and were checked with pyais 3.3.1.
const std::string published = R"(!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C
!AIVDM,1,1,,A,403OviQuMGCqWrRO9>E6fE700@GO,0*4D
!AIVDM,2,1,1,A,55?MbV02;H;s<HtKR20EHE:0@T4@Dn2222222216L961O5Gf0NSQEp6ClRp8,0*1C
!AIVDM,2,2,1,A,88888888880,2*25
!AIVDM,1,1,,A,B52K>;h00Fc>jpUlNV@ikwpUoP06,0*4C
!AIVDM,1,1,,B,C5N3SRgPEnJGEBT>NhWAwwo862PaLELTBJ:V00000000S0D:R220,0*0B
!AIVDM,1,1,,A,H42O55i18tMET00000000000000,2*6D
!AIVDM,1,1,,A,H42O55lt0000000D3nink000?050,0*40
)";

class PublishedMessages : public testing::Test {
 protected:
  void SetUp() override {
    reports_ = reports_in(write_text(folder_ / "log", published), &reading_);
  }
  TemporaryFolder folder_;
  AisReading reading_;
  std::vector<AisReport> reports_;
};

TEST_F(PublishedMessages, AllAreDecodedInOrder) {
  ASSERT_EQ(reports_.size(), 7U);
  const int types[] = {1, 4, 5, 18, 19, 24, 24};
  for (std::size_t i = 0; i < reports_.size(); ++i) {
    EXPECT_EQ(reports_[i].type, types[i]);
    EXPECT_FALSE(reports_[i].time);
  }
  EXPECT_EQ(reading_.untimed, 7U);
  EXPECT_EQ(reading_.undecodable, 0U);
  EXPECT_TRUE(contains(reading_.warnings().at(0), "7 reports have no time"));
}

constexpr double position_step_deg = 1.01e-6;  // gpsdecode prints six decimals of 1/600000 degree

TEST_F(PublishedMessages, PositionsOfClassA) {
  const AisReport& report = reports_.at(0);
  EXPECT_EQ(report.mmsi, 477553000U);
  EXPECT_EQ(report.speaker, AisClass::a);
  ASSERT_TRUE(report.position && report.speed_over_ground_m_s && report.course_over_ground &&
              report.heading);
  EXPECT_NEAR(report.position->latitude_deg(), 47.582833, position_step_deg);
  EXPECT_NEAR(report.position->longitude_deg(), -122.345833, position_step_deg);
  EXPECT_EQ(*report.speed_over_ground_m_s, 0);
  EXPECT_NEAR(report.course_over_ground->degrees(), 51.0, 1e-9);
  EXPECT_NEAR(report.heading->degrees(), 181, 1e-9);
  EXPECT_EQ(report.utc_second, 15);
}

TEST_F(PublishedMessages, BaseStations) {
  const AisReport& report = reports_.at(1);
  EXPECT_EQ(report.mmsi, 3669702U);
  EXPECT_EQ(report.speaker, AisClass::base_station);
  EXPECT_NEAR(report.position->latitude_deg(), 36.883767, position_step_deg);
  EXPECT_NEAR(report.position->longitude_deg(), -76.352362, position_step_deg);
}

TEST_F(PublishedMessages, ParticularsInTwoSentences) {
  const AisIdentity& identity = reports_.at(2).identity;
  EXPECT_EQ(reports_[2].mmsi, 351759000U);
  EXPECT_EQ(identity.name, "EVER DIADEM");
  EXPECT_EQ(identity.callsign, "3FOF8");
  EXPECT_EQ(identity.imo, 9134270U);
  EXPECT_EQ(identity.ship_type, 70);
  EXPECT_EQ(identity.length_m, 225 + 70);
  EXPECT_EQ(identity.beam_m, 1 + 31);
  EXPECT_EQ(identity.antenna_from_bow_m, 225);
  EXPECT_EQ(identity.antenna_from_port_m, 1);
  EXPECT_FALSE(reports_[2].position);
}

TEST_F(PublishedMessages, PositionsOfClassBInKnots) {
  const AisReport& small = reports_.at(3);
  EXPECT_EQ(small.mmsi, 338087471U);
  EXPECT_EQ(small.speaker, AisClass::b);
  EXPECT_NEAR(small.position->latitude_deg(), 40.68454, position_step_deg);
  EXPECT_NEAR(small.position->longitude_deg(), -74.072132, position_step_deg);
  EXPECT_NEAR(*small.speed_over_ground_m_s, 0.1 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(small.course_over_ground->degrees(), 79.6, 1e-9);
  EXPECT_FALSE(small.heading) << "511";
  EXPECT_EQ(small.utc_second, 49);
  const AisReport& extended = reports_.at(4);
  EXPECT_EQ(extended.mmsi, 367059850U);
  EXPECT_NEAR(*extended.speed_over_ground_m_s, 8.7 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(extended.position->longitude_deg(), -88.810392, position_step_deg);
  EXPECT_EQ(extended.identity.name, "CAPT.J.RIMES");
  EXPECT_EQ(extended.identity.length_m, 5 + 21);
  EXPECT_EQ(extended.identity.beam_m, 4 + 4);
}

TEST_F(PublishedMessages, ParticularsInTwoParts) {
  EXPECT_EQ(reports_.at(5).mmsi, 271041815U);
  EXPECT_EQ(reports_[5].identity.name, "PROGUY");
  EXPECT_FALSE(reports_[5].identity.callsign);
  const AisIdentity& part_b = reports_.at(6).identity;
  EXPECT_EQ(part_b.callsign, "TC6163");
  EXPECT_EQ(part_b.ship_type, 60);
  EXPECT_EQ(part_b.length_m, 15);
  EXPECT_EQ(part_b.beam_m, 5);
  EXPECT_FALSE(part_b.antenna_from_bow_m) << "bow and port 0: the antenna's place is not given";
}

TEST(ReadAis, WhatIsNotAvailableIsAbsent) {
  // Made with pyais 3.3.1 (encode_dict): 91 N, 181 E, 102.3 and 102.2 kn, course 360, heading 511,
  // second 60; the second one at 50 N, 1 E, course 359.9, heading 359, second 59.
  const TemporaryFolder folder;
  const auto reports =
      reports_in(write_text(folder / "log", R"(!AIVDO,1,1,,A,11mg=5OP?w<tSF0l4Q@>4?wqP000,0*06
!AIVDO,1,1,,A,11mg=5OP?v04Tv0LW3P>3s?oP000,0*50
!AIVDO,1,1,,A,B1mg=5@3wk?8mP=18D3Q3wv00000,0*10
!AIVDO,1,1,,A,B1mg=5@3wS?8mP=18D3Q3wv00000,0*28
)"));
  ASSERT_EQ(reports.size(), 4U);
  for (const AisReport& report : reports) {
    EXPECT_EQ(report.mmsi, 123456789U);
    EXPECT_TRUE(report.is_own_ship);
    EXPECT_FALSE(report.speed_over_ground_m_s);
    const bool is_second = &report == &reports[1];
    EXPECT_EQ(report.position.has_value(), is_second);
    EXPECT_EQ(report.course_over_ground.has_value(), is_second);
    EXPECT_EQ(report.heading.has_value(), is_second);
    EXPECT_EQ(report.utc_second.has_value(), is_second);
  }
  EXPECT_NEAR(reports[1].course_over_ground->degrees(), 359.9, 1e-9);
}

TEST(ReadAis, EachMessageOfAManyFindsItsOwnTime) {
  // Every fourth is of two sentences, every fifth none of our types, every seventh one that no one
  // can decode (type 5 of a few bits): an answer given to its neighbour would show.
  const TemporaryFolder folder;
  const std::string one = "177KQJ5000G?tO`K>RA1wUbN0TKH";
  const std::string two = "55?MbV02;H;s<HtKR20EHE:0@T4@Dn2222222216L961O5Gf0NSQEp6ClRp8";
  std::ofstream log(folder / "log");
  std::vector<std::pair<int, std::int64_t>> expected;
  std::size_t undecodable = 0;
  constexpr std::int64_t start = 1'635'731'889;
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t time = start + i;
    const std::string tag = tag_of("c:" + std::to_string(time));
    if (i % 7 == 3) {
      log << tag << sentence_of("AIVDM,1,1,,A,55?MbV02,0") << '\n';
      ++undecodable;
    } else if (i % 5 == 2) {
      log << tag << sentence_of("AIVDM,1,1,,A,E77KQJ5000,0") << '\n';
    } else if (i % 4 == 1) {
      log << tag << sentence_of("AIVDM,2,1,1,A," + two + ",0") << '\n'
          << sentence_of("AIVDM,2,2,1,A,88888888880,2") << '\n';
      expected.emplace_back(5, time);
    } else {
      log << tag << sentence_of("AIVDM,1,1,,A," + one + ",0") << '\n';
      expected.emplace_back(1, time);
    }
  }
  log.close();
  AisReading reading;
  const auto reports = reports_in(folder / "log", &reading);
  ASSERT_EQ(reports.size(), expected.size());
  for (std::size_t i = 0; i < reports.size(); ++i) {
    ASSERT_EQ(reports[i].type, expected[i].first) << i;
    ASSERT_EQ(reports[i].time, UtcTime(std::chrono::seconds(expected[i].second))) << i;
  }
  EXPECT_EQ(reading.undecodable, undecodable);
  EXPECT_EQ(reading.messages, 20'000U);
}

TEST(ReadAis, AHundredThousandLinesOfGarbageAroundOneMessageLeaveTheMessage) {
  const TemporaryFolder folder;
  Rng rng(7, "tests/garbage");
  std::ofstream log(folder / "log", std::ios::binary);
  for (int i = 0; i < 100'000; ++i) {
    if (i == 50'000)
      log << '\n'
          << tag_of("c:1635731889") << "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\r\n";
    const char* beginnings[] = {"!AIVDM,", "$PGHP,", "\\c:1", "", "{\"class\":\"AIS\",\"type\":1,"};
    std::string line = beginnings[rng.bits() % 5];
    for (std::uint64_t length = rng.bits() % 60; length > 0; --length)
      line += static_cast<char>(rng.bits());
    log << line << '\n';
  }
  log.close();
  AisReading reading;
  const auto reports = reports_in(folder / "log", &reading);
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].mmsi, 477553000U);
  EXPECT_EQ(reports[0].time, parse_utc("2021-11-01T01:58:09Z"));
  EXPECT_GT(reading.lines.malformed, 20'000U);
  EXPECT_TRUE(contains(reading.warnings().at(0), "lines are malformed (the first is line "));
}

TEST(ReadAis, AFileWithoutAisSaysWhatItExpected) {
  const TemporaryFolder folder;
  const std::string problem = problem_of(
      write_text(folder / "log", "hello\n!AIVDM,1,1,,B,177K,0*00\n"), ErrorKind::invalid_input);
  EXPECT_TRUE(contains(
      problem, "found no AIS message in 2 lines (line 2: a sentence with a wrong checksum)"))
      << problem;
  EXPECT_TRUE(contains(problem, "expected NMEA 0183 sentences")) << problem;
  EXPECT_TRUE(
      contains(problem_of(write_text(folder / "empty", ""), ErrorKind::invalid_input), "empty"));
  EXPECT_TRUE(contains(problem_of(folder / "absent", ErrorKind::not_found), "absent"));
  EXPECT_TRUE(contains(problem_of(folder.path(), ErrorKind::invalid_input), "a file was expected"));
}

TEST(ReadAis, ALineLongerThanAnySentenceDoesNotFillTheMemoryOrHideTheNext) {
  const TemporaryFolder folder;
  const auto file = write_text(folder / "log", std::string(5'000'000, '!') + '\n' + published);
  AisReading reading;
  EXPECT_EQ(reports_in(file, &reading).size(), 7U);
  EXPECT_EQ(reading.lines.malformed, 1U);
  EXPECT_EQ(reading.lines.lines, 9U);
}

TEST(ReadAis, LinesOfDosAndALastLineWithoutEndAreRead) {
  const TemporaryFolder folder;
  std::string dos;
  for (const char c : published) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  dos.resize(dos.size() - 2);
  EXPECT_EQ(reports_in(write_text(folder / "log", dos)).size(), 7U);
}

TEST(ReadAis, WithoutGpsdecodeItSaysWhatToInstall) {
  const TemporaryFolder folder;
  const auto file = write_text(folder / "log", published);
  const PathOf empty(folder.path().string());
  EXPECT_EQ(problem_of(file, ErrorKind::unavailable),
            "reading AIS of " + file.string() +
                ": found no program gpsdecode on the PATH, which is needed here; install it: apt "
                "install gpsd-clients");
}

TEST(ReadAis, AGpsdecodeThatIsKilledOrDropsMessagesIsUnavailable) {
  const TemporaryFolder folder;
  const auto file = write_text(folder / "log", published);
  const auto with = [&](const std::string& script) {
    return problem_of(file, ErrorKind::unavailable,
                      {{"sh", "-c", script}, "apt install gpsd-clients", 500ms});
  };
  EXPECT_TRUE(contains(with("gpsdecode -j -s -v | head -n 3; kill -9 $$"), "ended by signal 9"));
  EXPECT_TRUE(contains(with("gpsdecode -j -s -v | head -n 3; cat >/dev/null"), "lost"));
  EXPECT_TRUE(contains(with("gpsdecode -j -s"), "repeats no sentence"));
  EXPECT_TRUE(contains(with("cat >/dev/null"), "lost 7 messages"));
  EXPECT_TRUE(contains(with("exec sleep 600"), "does not answer"));
}

TEST(ReadAis, WhatGpsdecodeMightSayNeverHarms) {
  for (const char* json : {"", "{", "[]", "{}", "null", "{\"type\":1}", "{\"type\":1,\"mmsi\":0}",
                           "{\"type\":1,\"mmsi\":-5}", "{\"type\":6,\"mmsi\":5}",
                           "{\"type\":1.5,\"mmsi\":5}", "{\"type\":\"1\",\"mmsi\":5}",
                           "{\"type\":1,\"mmsi\":1e300}", "{\"type\":1,\"mmsi\":1000000000}"}) {
    EXPECT_FALSE(report_from_json(json)) << json;
  }
  const auto odd = report_from_json(
      R"({"type":1,"mmsi":5,"lat":1e999,"lon":[],"speed":-1,"course":-0.1,"heading":null,)"
      R"("shipname":7,"to_bow":-1})");
  EXPECT_FALSE(odd);  // 1e999 is no number of JSON's
  const auto report = report_from_json(
      R"({"type":1,"mmsi":5,"lat":"x","lon":[],"speed":-1,"course":-0.1,"heading":{},)"
      R"("shipname":7,"to_bow":-1})");
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->position || report->speed_over_ground_m_s || report->course_over_ground ||
               report->heading);
  EXPECT_EQ(report->identity, AisIdentity{});
}

TEST(ReadAis, NamesAreCleanedOfPaddingAndWhatCannotBePrinted) {
  EXPECT_EQ(clean_ais_text("  RUM LASS @@@@"), "RUM LASS");
  EXPECT_EQ(clean_ais_text("A\x1b[31mB\n"), "A[31mB");
  EXPECT_EQ(clean_ais_text("@"), std::nullopt);
  EXPECT_EQ(clean_ais_text("   "), std::nullopt);
  EXPECT_EQ(clean_ais_text(std::string(20, 'A')), std::string(20, 'A'));
  EXPECT_EQ(clean_ais_text(std::string(21, 'A')), std::nullopt);
}

TEST(ReadAisTracks, TooManyPositionsAreRefusedWithAdvice) {
  const TemporaryFolder folder;
  std::string log;
  for (int i = 0; i < 50; ++i) {
    log += tag_of("c:" + std::to_string(1'635'731'889 + 60 * i)) +
           "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\n";
  }
  const auto file = write_text(folder / "log", log);
  AisTrackOptions options;
  options.most_positions = 55;
  EXPECT_EQ(read_ais_tracks(file, options).tracks.at(0).positions.size(), 50U);
  options.most_positions = 54;
  try {
    (void)read_ais_tracks(file, options);
    FAIL() << "read without an error";
  } catch (const Error& error) {
    EXPECT_TRUE(
        contains(error.message(), "found more than 54 positions; give a box, a time or a vessel"));
  }
}

TEST(ReadAisTracks, TheCutKeepsWhatIsInside) {
  const TemporaryFolder folder;
  std::string log;
  for (int i = 0; i < 10; ++i) {
    log += tag_of("c:" + std::to_string(1'635'731'895 + 60 * i)) +
           "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\n";
  }
  log += tag_of("c:1635731895") + "!AIVDM,1,1,,A,B52K>;h00Fc>jpUlNV@ikwpUoP06,0*4C\n";
  const auto file = write_text(folder / "log", log);
  EXPECT_EQ(read_ais_tracks(file).tracks.size(), 2U);
  AisTrackOptions options;
  options.cut = BoundingBox::from_degrees(-123, 47, -122, 48);
  ASSERT_EQ(read_ais_tracks(file, options).tracks.size(), 1U);
  options.from = UtcTime(std::chrono::seconds(1'635'731'895 + 60));
  options.to = UtcTime(std::chrono::seconds(1'635'731'895 + 240));
  const AisTracks cut = read_ais_tracks(file, options);
  ASSERT_EQ(cut.tracks.size(), 1U);
  EXPECT_EQ(cut.tracks[0].mmsi, 477553000U);
  EXPECT_EQ(cut.tracks[0].positions.size(), 4U);
  AisTrackOptions one;
  one.mmsi = 338087471;
  ASSERT_EQ(read_ais_tracks(file, one).tracks.size(), 1U);
}

}  // namespace
}  // namespace slackwater::tests::read_ais_test
