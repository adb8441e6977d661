#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "ingest/ais/logged_time.h"
#include "ingest/ais/read_ais.h"
#include "tests/ingest/ais/nmea_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

// What receivers and authorities write around AIS. Values of the cases were decoded by hand from
// the six-bit payloads (ITU-R M.1371-5 annex 8), without gpsdecode.

namespace slackwater::tests::receiver_logs_test {
namespace {

using namespace ingest;

const std::string sentence = "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C";  // gpsd's AIVDM.txt

AisSentence read(const std::string& line) {
  const AisLine found = parse_ais_line(line);
  EXPECT_TRUE(std::holds_alternative<AisSentence>(found)) << line;
  return std::holds_alternative<AisSentence>(found) ? std::get<AisSentence>(found) : AisSentence{};
}

std::string problem_of(const std::filesystem::path& file) {
  try {
    (void)read_ais(file, [](const AisReport&) {});
  } catch (const Error& error) {
    return error.message();
  }
  return "read without an error";
}

TEST(ReceiverLogs, TimesBeforeAndBehindASentenceAreRead) {
  const UtcTime time = parse_utc("2025-03-08T00:00:10Z");
  const UtcTime later = time + Duration(250);
  for (const std::string around :
       {"2025-03-08T00:00:10Z ", "[2025-03-08 00:00:10 UTC] ", "2025-03-08T01:00:10+01:00,",
        "2025/03/08 00:00:10Z: ", "1741392010 ", "1741392010000;", "receiver 7 1741392010.000\t",
        "\"2025-03-08T00:00:10.000Z\",\"", "$ 2025-03-08T00:00:10Z station 2190047 "}) {
    EXPECT_EQ(read(around + sentence).logged_time, time) << around;
    EXPECT_EQ(read(sentence + " " + around).logged_time, time) << "behind: " << around;
    EXPECT_TRUE(read(around + sentence).logged_time_states_zone) << around;
  }
  EXPECT_EQ(read("2025-03-08T00:00:10.250Z " + sentence).logged_time, later);
  EXPECT_EQ(read("1741392010.25 " + sentence).logged_time, later);
  EXPECT_EQ(read(sentence + " ( MSG: 1, MMSI: 477553000, ppm: 1.9, timestamp: 20250308000010)")
                .logged_time,
            time);
  EXPECT_EQ(
      read(R"({"class":"AIS","rxtime":"20250308000010","nmea":[")" + sentence + "\"]}").logged_time,
      time);
  EXPECT_EQ(read("1741392010 " + tag_of("c:1635731889") + sentence).time,
            parse_utc("2021-11-01T01:58:09Z"))
      << "the tag block behind a prefix";
}

TEST(ReceiverLogs, NumbersThatAreNoTimeAreNone) {
  for (const std::string around :
       {"", "211000006 ", "7 ", "161975000 ", "00:00:10 ", "9999999999 ", "2025-13-08T00:00:10Z ",
        "-65.1741392010 ", "99999999999999999999 ", "1970-01-01T00:00:10Z "}) {
    EXPECT_FALSE(read(around + sentence).logged_time) << around;
  }
}

TEST(ReceiverLogs, ATimeWithoutAZoneIsNotTakenUnlessItIsSaidToBeUtc) {
  const TemporaryFolder folder;
  const auto file = write_text(folder / "log", "2025-03-08 00:00:10 " + sentence + "\n");
  AisTracks read = read_ais_tracks(file);
  EXPECT_TRUE(read.tracks.at(0).positions.empty());
  EXPECT_TRUE(contains(read.reading.warnings().at(0), "1 times of the log state no zone"));
  EXPECT_TRUE(contains(read.reading.warnings().at(0), "--assume-utc"));
  AisTrackOptions options;
  options.assume_utc = true;
  read = read_ais_tracks(file, options);
  ASSERT_EQ(read.tracks.at(0).positions.size(), 1U);
  EXPECT_EQ(read.reading.lines.zoneless_times, 0U);
}

TEST(ReceiverLogs, WhatIsCommentedOutOrTwiceInALineIsNotRead) {
  EXPECT_TRUE(std::holds_alternative<OtherLine>(parse_ais_line("# " + sentence)));
  const AisLine two = parse_ais_line(sentence + ' ' + sentence);
  ASSERT_TRUE(std::holds_alternative<MalformedLine>(two));
  EXPECT_TRUE(contains(std::get<MalformedLine>(two).reason, "several sentences"));
}

TEST(ReceiverLogs, AMessageMayStandInOneLineOfJson) {
  // Type 5 of gpsd's sample.aivdm, as AIS-catcher puts its two sentences into one object.
  const TemporaryFolder folder;
  const auto file = write_text(
      folder / "log",
      R"({"class":"AIS","rxtime":"20250308000010","nmea":[)"
      R"("!AIVDM,2,1,1,A,55?MbV02;H;s<HtKR20EHE:0@T4@Dn2222222216L961O5Gf0NSQEp6ClRp8,0*1C",)"
      R"("!AIVDM,2,2,1,A,88888888880,2*25"]})"
      "\n");
  std::vector<AisReport> reports;
  const AisReading read =
      read_ais(file, [&](const AisReport& report) { reports.push_back(report); });
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].identity.name, "EVER DIADEM");
  EXPECT_EQ(reports[0].time, parse_utc("2025-03-08T00:00:10Z"));
  EXPECT_EQ(read.lines.malformed, 0U);
  EXPECT_EQ(read.lines.lines, 1U);
}

TEST(ReceiverLogs, DecodedJsonIsNamed) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(problem_of(write_text(folder / "log", R"({"class":"AIS","type":1})")),
                       "found JSON without NMEA sentences"));
}

TEST(ReceiverLogs, TheCasesAreReadWithTheirTimes) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto cases = shared / "data/cases/ais_prefixes";
  const struct {
    const char* file;
    std::uint32_t mmsi;
  } logs[] = {{"iso_prefix.nmea", 211000004},
              {"epoch_prefix.nmea", 211000005},
              {"ais_catcher.nmea", 211000006}};
  for (const auto& log : logs) {
    const AisTracks read = read_ais_tracks(cases / log.file);
    ASSERT_EQ(read.tracks.size(), 1U) << log.file;
    const AisTrack& track = read.tracks[0];
    EXPECT_EQ(track.mmsi, log.mmsi);
    ASSERT_EQ(track.positions.size(), 6U) << log.file;
    EXPECT_EQ(track.positions.front().time, parse_utc("2025-03-08T00:00:00Z")) << log.file;
    EXPECT_EQ(track.positions.back().time, parse_utc("2025-03-08T00:00:50Z")) << log.file;
    EXPECT_TRUE(read.reading.warnings().empty()) << read.reading.warnings().at(0);
  }
}

TEST(ReceiverLogs, LongRangePositionsAreReadToATenthOfAMinute) {
  SLACKWATER_NEEDS_SHARED(shared);
  const AisTracks read = read_ais_tracks(shared / "data/cases/silent_nothing/type27_whole.nmea");
  ASSERT_EQ(read.tracks.size(), 1U);
  const AisTrack& track = read.tracks[0];
  EXPECT_EQ(track.mmsi, 211000020U);
  ASSERT_EQ(track.positions.size(), 6U);
  // Coded -1500 and -1440, 29340 sixhundredths of a degree; 12 kn, 90 degrees.
  EXPECT_DOUBLE_EQ(track.positions.front().point.longitude_deg(), -2.5);
  EXPECT_DOUBLE_EQ(track.positions.back().point.longitude_deg(), -2.4);
  EXPECT_DOUBLE_EQ(track.positions[1].point.longitude_deg(), -1488.0 / 600);
  EXPECT_DOUBLE_EQ(track.positions[1].point.latitude_deg(), 48.9);
  EXPECT_DOUBLE_EQ(*track.positions[1].speed_over_ground_m_s, 12 * 1852.0 / 3600);
  EXPECT_NEAR(track.positions[1].course_over_ground->degrees(), 90, 1e-9);
  EXPECT_EQ(track.positions[1].time, parse_utc("2025-03-08T00:03:00Z"));
}

TEST(ReceiverLogs, AircraftOfSearchAndRescueAreReadAndNamed) {
  SLACKWATER_NEEDS_SHARED(shared);
  const AisTracks read = read_ais_tracks(shared / "data/cases/silent_nothing/type9_sar.nmea");
  ASSERT_EQ(read.tracks.size(), 1U);
  const AisTrack& track = read.tracks[0];
  EXPECT_EQ(track.mmsi, 111211500U);
  EXPECT_EQ(name_of(track.speaker), "SAR aircraft");
  ASSERT_EQ(track.positions.size(), 6U);
  EXPECT_DOUBLE_EQ(*track.positions[0].speed_over_ground_m_s, 120 * 1852.0 / 3600);
  EXPECT_DOUBLE_EQ(track.positions[0].point.longitude_deg(), -2.5);
}

TEST(ReceiverLogs, SpeedsInWholeKnotsEndWhereTheirTypesSay) {
  const auto speed = [](const std::string& type, int speed_kn) {
    const auto report = report_from_json(R"({"type":)" + type + R"(,"mmsi":5,"scaled":false,)" +
                                         R"("speed":)" + std::to_string(speed_kn) + "}");
    return report->speed_over_ground_m_s;
  };
  EXPECT_DOUBLE_EQ(*speed("9", 1021), 1021 * 1852.0 / 3600);
  EXPECT_FALSE(speed("9", 1022));
  EXPECT_FALSE(speed("9", 1023));
  EXPECT_DOUBLE_EQ(*speed("27", 62), 62 * 1852.0 / 3600);
  EXPECT_FALSE(speed("27", 63));
  EXPECT_DOUBLE_EQ(*speed("1", 1021), 102.1 * 1852 / 3600);
  EXPECT_FALSE(speed("1", 1022));
}

TEST(ReceiverLogs, APlaceToATenthOfAMinuteIsNoneOfAVesselThatTellsBetterOnes) {
  AisTrackCollector collector;
  AisReport report;
  report.mmsi = 5;
  report.time = parse_utc("2025-03-08T00:00:00Z");
  report.position = GeoPoint::from_degrees(50, 1);
  report.type = 27;
  collector.add(report);
  report.type = 1;
  *report.time += std::chrono::seconds(10);
  report.position = GeoPoint::from_degrees(50.0004, 1);
  collector.add(report);
  const auto tracks = std::move(collector).take();
  ASSERT_EQ(tracks.at(0).positions.size(), 1U);
  EXPECT_EQ(tracks[0].positions[0].point.latitude_deg(), 50.0004);
  EXPECT_EQ(tracks[0].reports, 2U);
}

TEST(ReceiverLogs, TypesPassedOverAreCountedAndNamed) {
  const TemporaryFolder folder;
  // The second is a made-up aid to navigation: type 21 by its first six bits.
  const auto file = write_text(folder / "log", tag_of("c:1635731889") + sentence + "\n" +
                                                   sentence_of("AIVDM,1,1,,A,E77KQJ5000,0") + "\n" +
                                                   sentence_of("AIVDM,1,1,,A,877KQJ5000,0") + "\n" +
                                                   sentence_of("AIVDM,1,1,,A,E77KQJ5001,0") + "\n");
  const AisTracks read = read_ais_tracks(file);
  EXPECT_EQ(read.reading.other_types, 3U);
  EXPECT_EQ(read.reading.others_of_type[21], 2U);
  EXPECT_TRUE(read.reading.warnings().empty());
  EXPECT_EQ(read.reading.passed_over(),
            "3 messages of types that tell of no vessel's way are passed over: type 8 (binary "
            "broadcast) 1, type 21 (aid to navigation) 2");
}

TEST(AisDownloads, MarineCadastreWithItsNewNames) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const char* name : {"csv2.csv", "csv2.csv.zst"}) {
    const AisTracks read = read_ais_tracks(shared / "data/cases/usual_downloads" / name);
    ASSERT_EQ(read.tracks.size(), 1U) << name;
    const AisTrack& track = read.tracks[0];
    EXPECT_EQ(track.mmsi, 366000001U);
    EXPECT_EQ(track.identity.name, "EXAMPLE ONE");
    EXPECT_EQ(track.identity.callsign, "XXXX001");
    EXPECT_EQ(track.identity.length_m, 20);
    ASSERT_EQ(track.positions.size(), 5U);
    EXPECT_EQ(track.positions[4].time, parse_utc("2026-03-31T00:00:40Z"));
    EXPECT_DOUBLE_EQ(track.positions[4].point.longitude_deg(), -82.55241);
    EXPECT_DOUBLE_EQ(*track.positions[4].speed_over_ground_m_s, 8.1 * 1852 / 3600);
  }
}

TEST(AisDownloads, TheDanishTable) {
  SLACKWATER_NEEDS_SHARED(shared);
  const AisTracks read = read_ais_tracks(shared / "data/cases/usual_downloads/dma.csv");
  ASSERT_EQ(read.tracks.size(), 1U);
  const AisTrack& track = read.tracks[0];
  EXPECT_EQ(track.mmsi, 219000002U);
  EXPECT_EQ(track.identity.name, "TESTSHIP");
  EXPECT_EQ(track.identity.ship_type, 70);
  EXPECT_EQ(track.identity.length_m, 80);
  EXPECT_EQ(track.identity.beam_m, 12);
  EXPECT_EQ(track.identity.antenna_from_bow_m, 40);
  EXPECT_EQ(track.identity.antenna_from_port_m, 6);
  EXPECT_FALSE(track.identity.imo) << "Unknown";
  ASSERT_EQ(track.positions.size(), 5U);
  EXPECT_EQ(track.positions[0].time, parse_utc("2025-06-01T00:00:00Z")) << "the day stands first";
  EXPECT_DOUBLE_EQ(track.positions[0].point.latitude_deg(), 55.90);
}

TEST(AisDownloads, DanishRowsOfNoShipArePassedOver) {
  const TemporaryFolder folder;
  const auto file = write_text(folder / "dma.csv",
                               "# Timestamp,Type of mobile,MMSI,Latitude,Longitude,SOG\n"
                               "31/12/2015 23:59:59,Class B,219000002,55.9,17.3,5\n"
                               "31/12/2015 23:59:59,AtoN,992190001,55.9,17.3,\n"
                               "31/12/2015 23:59:59,SAR Airborne,111219501,55.9,17.3,99\n"
                               "12/31/2015 23:59:59,Class A,219000003,55.9,17.3,5\n");
  const AisTracks read = read_ais_tracks(file);
  ASSERT_EQ(read.tracks.size(), 2U);
  EXPECT_EQ(read.tracks[0].speaker, AisClass::aircraft);
  EXPECT_EQ(read.tracks[1].positions.at(0).time, parse_utc("2015-12-31T23:59:59Z"));
  EXPECT_EQ(read.reading.other_types, 1U);
  EXPECT_EQ(read.reading.lines.malformed, 1U) << "there is no 31st month";
}

TEST(AisDownloads, AnUnknownTableIsNamedByItsColumns) {
  const TemporaryFolder folder;
  const std::string problem = problem_of(
      write_text(folder / "a.csv", "mmsi,timestamp,lat,lon\n5,2025-01-01T00:00:00,1,2\n"));
  EXPECT_TRUE(contains(problem, "found a table with the columns mmsi, timestamp, lat, lon"))
      << problem;
  EXPECT_TRUE(contains(problem, "base_date_time"));
}

/// A Zstandard frame of one raw block (RFC 8878, 3.1.1): single segment, one byte of content size.
std::string raw_frame(const std::string& content) {
  const auto size = content.size();
  std::string frame = "\x28\xb5\x2f\xfd\x20";
  frame += static_cast<char>(size);
  frame += static_cast<char>(1 | ((size << 3U) & 0xff));
  frame += static_cast<char>((size >> 5U) & 0xff);
  frame += '\0';
  return frame + content;
}

TEST(AisDownloads, ZstandardFramesOneAfterTheOtherAreOneText) {
  const TemporaryFolder folder;
  const std::string line = tag_of("c:1635731889") + sentence + "\n";
  const std::string both = raw_frame(line) + raw_frame(line);
  AisReading reading = read_ais(write_text(folder / "a.zst", both), [](const AisReport&) {});
  EXPECT_EQ(reading.messages, 2U);
  const std::string cut = both.substr(0, both.size() - 5);
  EXPECT_TRUE(contains(problem_of(write_text(folder / "b.zst", cut)), "ends early"));
  std::string damaged = both;
  damaged[6] = static_cast<char>(damaged[6] | 6);  // a block of the reserved type
  EXPECT_TRUE(contains(problem_of(write_text(folder / "c.zst", damaged)), "damaged"));
}

TEST(AisDownloads, OtherPackingsAreNamedWithWhatUnpacksThem) {
  const TemporaryFolder folder;
  const std::string zip = problem_of(write_text(folder / "a.zip", "PK\x03\x04 rest"));
  EXPECT_TRUE(contains(zip, "found a zip archive")) << zip;
  EXPECT_TRUE(contains(zip, "`unzip`"));
  EXPECT_TRUE(contains(problem_of(write_text(folder / "a.gz", "\x1f\x8b\x08 rest")), "`gunzip`"));
}

}  // namespace
}  // namespace slackwater::tests::receiver_logs_test
