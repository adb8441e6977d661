// Logs of strangers. The figures were obtained once with pyais 3.3.1 (PyPI), an independent
// decoder, from messages joined in the order of the log with the same rules of absence; sums stand
// for all values.
#include <gtest/gtest.h>

#include <cmath>

#include "ingest/ais/read_ais.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::real_logs_test {
namespace {

using namespace ingest;

/// What all reports of a log add up to.
struct Sums {
  std::size_t positions = 0, speeds = 0, courses = 0, headings = 0, timed = 0;
  double latitude_deg = 0, longitude_deg = 0, speed_m_s = 0, course_deg = 0, heading_deg = 0;
};

Sums sums_of(const std::filesystem::path& file, AisReading& reading) {
  Sums sums;
  reading = read_ais(file, [&](const AisReport& report) {
    sums.timed += report.time ? 1U : 0U;
    if (report.position) {
      ++sums.positions;
      sums.latitude_deg += report.position->latitude_deg();
      sums.longitude_deg += report.position->longitude_deg();
    }
    if (report.speed_over_ground_m_s) {
      ++sums.speeds;
      sums.speed_m_s += *report.speed_over_ground_m_s;
    }
    if (report.course_over_ground) {
      ++sums.courses;
      sums.course_deg += report.course_over_ground->degrees();
    }
    if (report.heading) {
      ++sums.headings;
      sums.heading_deg += report.heading->degrees();
    }
  });
  return sums;
}

TEST(RealAisLogs, TheDanishShoreStationIsReadAsAnIndependentDecoderReadsIt) {
  SLACKWATER_NEEDS_SHARED(shared);
  AisReading reading;
  const Sums sums = sums_of(shared / "data/ais/danish_shore_station_2010-06-11.nmea", reading);
  EXPECT_EQ(reading.lines.sentences, 4500U);  // 4346 VDM and 154 VDO: the data's index
  EXPECT_EQ(reading.messages, 4051U);
  EXPECT_EQ(reading.lines.malformed, 0U);
  EXPECT_EQ(reading.lines.lost_fragments, 0U);
  EXPECT_EQ(reading.undecodable, 2U) << "types 1 and 5 of MMSI 0";
  EXPECT_EQ(reading.untimed, 0U);
  EXPECT_EQ(reading.other_types, 435U);
  const auto& n = reading.reports_of_type;
  EXPECT_EQ(n[1], 2511U - 1);
  EXPECT_EQ(n[2], 7U);
  EXPECT_EQ(n[3], 369U);
  EXPECT_EQ(n[4], 129U);
  EXPECT_EQ(n[5], 424U - 1) << "gpsdecode alone finds 416: it loses messages that interleave";
  EXPECT_EQ(n[9], 1U) << "an aircraft that knows no place, speed or course";
  EXPECT_EQ(n[18], 101U);
  EXPECT_EQ(n[24], 74U);
  EXPECT_EQ(sums.positions, 3090U);
  EXPECT_NEAR(sums.latitude_deg, 173881.5825, 2e-3);  // a rounding of 5e-7 a position
  EXPECT_NEAR(sums.longitude_deg, 29829.6449, 2e-3);
  EXPECT_EQ(sums.speeds, 2960U);
  EXPECT_NEAR(sums.speed_m_s, 10420.43233, 1e-4);
  EXPECT_EQ(sums.courses, 2958U);
  EXPECT_NEAR(sums.course_deg, 543978.0, 1e-4);
  EXPECT_EQ(sums.headings, 2441U);
  EXPECT_NEAR(sums.heading_deg, 441572, 1e-4);
}

TEST(RealAisLogs, TheSatelliteIsReadAsAnIndependentDecoderReadsIt) {
  SLACKWATER_NEEDS_SHARED(shared);
  AisReading reading;
  const Sums sums = sums_of(shared / "data/ais/exactearth_20211101.nm4", reading);
  EXPECT_EQ(reading.messages, 979U);
  EXPECT_EQ(reading.undecodable, 1U) << "type 1 of MMSI 0";
  // Of type 27, by the bits of its payloads: 127, with 126 places (the sums behind the signs) and
  // 126 speeds; the others by pyais.
  EXPECT_EQ(reading.reports_of_type[27], 127U);
  EXPECT_EQ(sums.timed, 836U + 127U);
  const auto& n = reading.reports_of_type;
  EXPECT_EQ(n[1], 608U - 1);
  EXPECT_EQ(n[3], 104U);
  EXPECT_EQ(n[4], 5U);
  EXPECT_EQ(n[5], 18U);
  EXPECT_EQ(n[18], 74U);
  EXPECT_EQ(n[19], 4U);
  EXPECT_EQ(n[24], 24U);
  EXPECT_EQ(sums.positions, 793U + 126U);
  EXPECT_NEAR(sums.latitude_deg, -6782.7180 - 1006.2350, 1e-3);
  EXPECT_NEAR(sums.longitude_deg, 9794.8011 + 2323.50667, 1e-3);
  EXPECT_EQ(sums.speeds, 783U + 126U);
  EXPECT_NEAR(sums.speed_m_s, 3110.74267 + 289.11778, 1e-4);
}

TEST(RealAisLogs, EveryTimeOfTheDanishLogIsTheStampBeforeItsMessage) {
  SLACKWATER_NEEDS_SHARED(shared);
  // Of the messages by their place in the log, read with pyais: the first, one in two sentences,
  // one of a vessel in two parts, and the last.
  std::vector<AisReport> reports;
  (void)read_ais(shared / "data/ais/danish_shore_station_2010-06-11.nmea",
                 [&](const AisReport& report) {
                   if (report.type != 9) reports.push_back(report);  // not in that list
                 });
  struct Expected {
    std::size_t place;
    const char* time;
    int type;
    std::uint32_t mmsi;
  };
  for (const Expected& expected : {
           Expected{0, "2010-06-11T11:46:11.390Z", 4, 2311200},
           Expected{6, "2010-06-11T11:46:11.929Z", 5, 246901005},
           Expected{7, "2010-06-11T11:46:12.553Z", 24, 219012981},
           Expected{1000, "2010-06-11T11:46:19.724Z", 1, 305377000},
           Expected{2000, "2010-06-11T11:46:26.941Z", 1, 218106000},
           Expected{3000, "2010-06-11T11:46:34.399Z", 1, 220000054},
           Expected{3612, "2010-06-11T11:46:38.873Z", 1, 220241000},
       }) {
    ASSERT_LT(expected.place, reports.size());
    const AisReport& report = reports[expected.place];
    EXPECT_EQ(report.time, parse_utc(expected.time)) << expected.place;
    EXPECT_EQ(report.type, expected.type) << expected.place;
    EXPECT_EQ(report.mmsi, expected.mmsi) << expected.place;
  }
}

/// How far positions lie from where speed and course over ground would have brought the vessel
/// since the one before.
struct Consistency {
  std::size_t pairs = 0;
  std::size_t backwards = 0;  ///< by more than 5 m
  double rms_m = 0;           ///< along the course
};

Consistency consistency_of(const std::vector<AisTrack>& tracks) {
  Consistency result;
  double squares = 0;
  for (const AisTrack& track : tracks) {
    for (std::size_t i = 1; i < track.positions.size(); ++i) {
      const AisPosition& a = track.positions[i - 1];
      const AisPosition& b = track.positions[i];
      const double time_s = seconds_between(a.time, b.time);
      if (!a.speed_over_ground_m_s || !b.speed_over_ground_m_s || !a.course_over_ground) continue;
      if (time_s > 120 || *a.speed_over_ground_m_s < 2 || *b.speed_over_ground_m_s < 2) continue;
      if (a.point == b.point) continue;  // one message heard twice
      const double north_m = (b.point.latitude_deg() - a.point.latitude_deg()) * 111'200;
      const double east_m = (b.point.longitude_deg() - a.point.longitude_deg()) * 111'320 *
                            std::cos(a.point.latitude.radians());
      const double course = a.course_over_ground->radians();
      const double along_m = north_m * std::cos(course) + east_m * std::sin(course);
      const double expected_m = (*a.speed_over_ground_m_s + *b.speed_over_ground_m_s) / 2 * time_s;
      ++result.pairs;
      result.backwards += along_m < -5 ? 1U : 0U;
      squares += (along_m - expected_m) * (along_m - expected_m);
    }
  }
  result.rms_m = std::sqrt(squares / static_cast<double>(result.pairs));
  return result;
}

TEST(RealAisLogs, TracksAgreeWithTheirOwnSpeedsAsTimesOfReceiptDoNot) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto file = shared / "data/ais/danish_shore_station_2010-06-11.nmea";
  AisTrackCollector by_receipt;
  (void)read_ais(file, [&](AisReport report) {
    report.utc_second.reset();
    by_receipt.add(report);
  });
  const Consistency late = consistency_of(std::move(by_receipt).take());
  const Consistency ours = consistency_of(read_ais_tracks(file).tracks);
  // A small script over pyais found 26.1 m and 8 jumps against 7.0 m and none, in 864 pairs.
  EXPECT_NEAR(static_cast<double>(ours.pairs), 864, 20);
  EXPECT_NEAR(late.rms_m, 26.1, 2);
  EXPECT_NEAR(ours.rms_m, 7.0, 1);
  EXPECT_GE(late.backwards, 6U);
  EXPECT_EQ(ours.backwards, 0U);
}

TEST(RealAisLogs, AVesselIsWhoItSaysItIs) {
  SLACKWATER_NEEDS_SHARED(shared);
  AisTrackOptions options;
  options.mmsi = 210248000;
  const AisTracks read =
      read_ais_tracks(shared / "data/ais/danish_shore_station_2010-06-11.nmea", options);
  ASSERT_EQ(read.tracks.size(), 1U);
  const AisTrack& track = read.tracks[0];
  EXPECT_EQ(track.identity.name, "TRANSJORUND");
  EXPECT_EQ(track.identity.callsign, "C4RK2");
  EXPECT_EQ(track.identity.length_m, 130 + 16);
  EXPECT_EQ(track.identity.beam_m, 10 + 10);
  EXPECT_EQ(track.reports, 7U);
  EXPECT_EQ(track.positions.size(), 6U);
}

TEST(RealAisLogs, TheTableOfSmallCraftIsReadWhole) {
  SLACKWATER_NEEDS_SHARED(shared);
  // Counts by awk and Python's csv.
  const AisTracks read = read_ais_tracks(shared / "data/ais/classB_moving_20220103.csv");
  EXPECT_EQ(read.reading.messages, 1634U);
  EXPECT_EQ(read.reading.lines.malformed, 0U);
  EXPECT_EQ(read.tracks.size(), 118U);
  std::size_t positions = 0, most = 0;
  for (const AisTrack& track : read.tracks) {
    EXPECT_EQ(track.speaker, AisClass::b);
    positions += track.positions.size();
    most = std::max(most, track.positions.size());
    if (track.mmsi != 367479170) continue;
    EXPECT_EQ(track.identity.name, "CAPTAIN D");
    EXPECT_EQ(track.identity.length_m, 23);
    EXPECT_EQ(track.positions.front().time, parse_utc("2022-01-03T00:00:01Z"));
    EXPECT_EQ(track.positions.back().time, parse_utc("2022-01-03T00:20:48Z"));
  }
  EXPECT_EQ(positions, 1634U);
  EXPECT_EQ(most, 19U);
}

}  // namespace
}  // namespace slackwater::tests::real_logs_test
