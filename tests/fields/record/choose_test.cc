#include "fields/record/choose.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <map>
#include <set>

#include "fields/base/numbers/random.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::choose_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using namespace tests;

const UtcTime midnight = parse_utc("2024-06-11T00:00:00Z");
const UtcTime next_midnight = midnight + std::chrono::hours(24);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A piece of three hours whose value says which piece it is.
PieceColumn<Horizontal> marked(const Origin& origin, double mark) {
  return vector_piece(origin, instants(midnight, midnight + hours(2)), {5.0},
                      steady({mark, -mark}));
}

/// The mark of the piece that wins; the record is asked in both orders.
double winner(const Origin& one, const Origin& two) {
  VectorRecord record{{marked(one, 1), marked(two, 2)}};
  const Chosen<Horizontal> chosen = choose(record, {}, {});
  std::swap(record.pieces[0], record.pieces[1]);
  const Chosen<Horizontal> swapped = choose(record, {}, {});
  EXPECT_EQ(chosen.column.value, swapped.column.value) << "the order of pieces plays no part";
  EXPECT_EQ(chosen.column.times(), 3u);
  return chosen.column.value.at(0).real();
}

Origin member(Origin origin, int number) {
  origin.ensemble_member = number;
  return origin;
}

TEST(Choose, AnAnalysisBeatsAForecastThatWasIngestedLater) {
  const UtcTime later = midnight + hours(1);
  EXPECT_EQ(winner(analysis_of("model", 1), forecast_of("model", later, 9)), 1);
  EXPECT_EQ(winner(station_of("model", 1), forecast_of("model", later, 9)), 1);
}

/// Four runs of a day and a half at steps of an hour, each of which begins with its analysis; what
/// is known after the last began. Values say the run, in days.
VectorRecord runs_that_begin_with_their_analysis(std::deque<Origin>& origins, hours apart) {
  VectorRecord record;
  for (int n = 0; n < 4; ++n) {
    const UtcTime run = midnight + n * apart;
    origins.push_back(analysis_of("model", 10 + n));
    record.pieces.push_back(
        vector_piece(origins.back(), instants(run, run), {}, steady({double(n), 0})));
    origins.push_back(forecast_of("model", run, 20 + n));
    record.pieces.push_back(vector_piece(origins.back(), instants(run + hours(1), run + hours(36)),
                                         {}, steady({double(n), 0})));
  }
  return record;
}

TEST(Choose, RunsThatBeginWithTheirAnalysisAreAsFineAsTheyAre) {
  for (const hours apart : {hours(6), hours(12), hours(24)}) {
    std::deque<Origin> origins;
    const VectorRecord record = runs_that_begin_with_their_analysis(origins, apart);
    const Chosen<Horizontal> chosen = choose(record, {}, {});
    const UtcTime last = midnight + 3 * apart + hours(36);
    EXPECT_EQ(chosen.column.time, instants(midnight, last)) << apart.count() << " h apart";
    for (std::size_t t = 0; t < chosen.column.times(); ++t) {
      const auto lead = chosen.column.time[t].centre() - midnight;
      EXPECT_EQ(chosen.column.value[t].real(), double(std::min<long>(3, lead / apart)))
          << "the newest run that had begun, " << apart.count() << " h apart, value " << t;
      EXPECT_EQ(chosen.origin[t]->status == DataStatus::analysis,
                lead % apart == Duration(0) && lead <= 3 * apart);
    }
  }
}

TEST(Choose, AnAnalysisOfTheStepOfItsForecastsKeepsItsGap) {
  std::deque<Origin> origins;
  VectorRecord record;
  origins.push_back(analysis_of("model", 1));
  auto times = instants(midnight, midnight + hours(12));
  times.erase(times.begin() + 6);
  record.pieces.push_back(vector_piece(origins.back(), times, {}, steady({1, 0})));
  origins.push_back(forecast_of("model", midnight, 2));
  record.pieces.push_back(
      vector_piece(origins.back(), instants(midnight, midnight + hours(12)), {}, steady({2, 0})));
  EXPECT_EQ(choose(record, {}, {}).column.time, times);
}

TEST(Choose, TheShorterLeadBeatsTheLonger) {
  EXPECT_EQ(winner(forecast_of("model", midnight - hours(12), 1),
                   forecast_of("model", midnight - hours(24), 9)),
            1);
}

TEST(Choose, TheControlBeatsTheMeanOfTheOtherMembers) {
  const Origin run = forecast_of("model", midnight, 1);
  EXPECT_EQ(winner(member(run, 0), member(forecast_of("model", midnight, 9), 3)), 1);
  EXPECT_EQ(winner(member(run, 2), member(forecast_of("model", midnight, 9), 3)), 1.5)
      << "without a control their mean";
  EXPECT_EQ(winner(member(run, 0), member(forecast_of("model", midnight + hours(6), 1), 3)), 2)
      << "a shorter lead counts for more than the control";
}

TEST(Choose, OfOneRunThatCameTwiceTheLaterIngestedBeatsTheEarlier) {
  EXPECT_EQ(winner(analysis_of("model", 7), analysis_of("model", 8)), 2);
  EXPECT_EQ(winner(forecast_of("model", midnight, 7), forecast_of("model", midnight, 8)), 2);
}

/// The height that a made-up wind is stated at: "a@100" is 100 m; currents and waves have none.
double height_m_of(const Origin& origin) {
  const std::size_t at = origin.dataset.find('@');
  return at == std::string::npos ? 10.0 : std::stod(origin.dataset.substr(at + 1));
}

/// Whether the run of one counts before that of the other; written down once more.
bool beats(const Origin& a, const Origin& b) {
  const bool a_is_forecast = a.status == DataStatus::forecast;
  const bool b_is_forecast = b.status == DataStatus::forecast;
  if (a_is_forecast != b_is_forecast) return b_is_forecast;
  if (a.reference_time != b.reference_time) return a.reference_time > b.reference_time;
  if (height_m_of(a) != height_m_of(b)) return height_m_of(a) < height_m_of(b);
  return a.dataset < b.dataset;
}

bool same_run(const Origin& a, const Origin& b) { return !beats(a, b) && !beats(b, a); }

/// Pieces of analyses and runs of two products at three heights, hour by hour with holes; each
/// piece is its value.
struct AnyPieces {
  explicit AnyPieces(std::uint64_t seed) : rng(seed, "tests/record/any_pieces") {
    for (int p = 0; p < 18; ++p) {
      const std::string name = draw(2) == 0 ? "a" : "b";
      const std::string height_m = std::array{"10", "100", "120"}[std::size_t(draw(3))];
      const std::string dataset = name + "@" + height_m;
      const UtcTime issued = midnight - hours(6 * draw(3));
      origins.push_back(draw(3) == 0 ? analysis_of(dataset, p) : forecast_of(dataset, issued, p));
      origins.back().product_id = name;
      const UtcTime from = midnight + hours(draw(24));
      record.pieces.push_back(vector_piece(origins.back(), instants(from, from + hours(draw(12))),
                                           {}, steady({double(p), 0})));
      if (height_m != "10") record.pieces.back().from_height_m = std::stod(height_m);
    }
  }
  int draw(int count) { return static_cast<int>(rng.uniform(0, count)); }

  /// A run's known times.
  std::set<UtcTime> times_of(const Origin& run, const Knowledge& knowledge) const {
    std::set<UtcTime> times;
    for (const auto& piece : record.pieces) {
      if (!same_run(*piece.origin, run)) continue;
      for (const TimeCell& cell : piece.column.time)
        if (is_known(*piece.origin, cell, knowledge)) times.insert(cell.centre());
    }
    return times;
  }
  /// Whether a run that counts before this one speaks at a time: it has a value there, or one hour
  /// is missing.
  bool is_outdone(const Origin& run, UtcTime time, const Knowledge& knowledge) const {
    for (const Origin& other : origins) {
      if (!beats(other, run)) continue;
      const std::set<UtcTime> times = times_of(other, knowledge);
      if (times.contains(time)) return true;
      if (times.contains(time - hours(1)) && times.contains(time + hours(1)) &&
          (times.contains(time - hours(2)) || times.contains(time + hours(2))))
        return true;
    }
    return false;
  }

  Rng rng;
  std::deque<Origin> origins;
  VectorRecord record;
};

TEST(Choose, AtEachTimeTheBestRunThatLastsSpeaksWhateverTheOrderOfPieces) {
  int outdone = 0;
  std::set<double> heights;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    AnyPieces any(seed);
    const Knowledge knowledge{midnight + hours(any.draw(30)), midnight - hours(6 * any.draw(3))};
    const Chosen<Horizontal> chosen = choose(any.record, knowledge, {});
    std::map<UtcTime, const Origin*> speaks;
    for (std::size_t t = 0; t < chosen.column.times(); ++t)
      EXPECT_TRUE(speaks.emplace(chosen.column.time[t].centre(), chosen.origin[t]).second);
    for (const auto& piece : any.record.pieces) {
      for (const TimeCell& cell : piece.column.time) {
        const UtcTime time = cell.centre();
        const bool known = is_known(*piece.origin, cell, knowledge);
        const bool is_wanted = known && !any.is_outdone(*piece.origin, time, knowledge);
        outdone += known && !is_wanted ? 1 : 0;
        const auto found = speaks.find(time);
        // A hole of two hours beside a lone value is nobody's business here.
        if (found == speaks.end()) continue;
        EXPECT_FALSE(is_wanted && beats(*piece.origin, *found->second)) << "seed " << seed;
      }
    }
    for (std::size_t t = 0; t < chosen.column.times(); ++t) {
      const auto& granules = chosen.origin[t]->granules;
      EXPECT_EQ(chosen.column.value[t].real(), double(granules.front())) << "its own value";
    }
    for (const Stretch& stretch : chosen.stretches) {
      const double height_m = height_m_of(*stretch.origin);
      heights.insert(height_m);
      EXPECT_EQ(stretch.from_height_m.value_or(10.0), height_m) << "seed " << seed;
      for (std::size_t t = 0; t < chosen.column.times(); ++t) {
        const UtcTime time = chosen.column.time[t].centre();
        if (time < stretch.from || time > stretch.to) continue;
        EXPECT_EQ(height_m_of(*chosen.origin[t]), height_m) << "two heights mixed, seed " << seed;
      }
    }
    for (std::size_t i = any.record.pieces.size() - 1; i > 0; --i)
      std::swap(any.record.pieces[i],
                any.record.pieces[static_cast<std::size_t>(any.draw(int(i) + 1))]);
    const Chosen<Horizontal> shuffled = choose(any.record, knowledge, {});
    EXPECT_EQ(shuffled.column.value, chosen.column.value) << "seed " << seed;
    EXPECT_EQ(shuffled.origin, chosen.origin) << "seed " << seed;
  }
  EXPECT_GT(outdone, 500) << "the drawn pieces do overlap";
  EXPECT_EQ(heights.size(), 3u) << "every height speaks somewhere";
}

TEST(Choose, OfTheSameFileTwiceTheFirstPieceStays) {
  const Origin origin = analysis_of("model");
  const VectorRecord record{{marked(origin, 1), marked(origin, 2)}};
  EXPECT_EQ(choose(record, {}, {}).column.value[0].real(), 1);
}

TEST(Choose, WhatEndsAfterTheMomentOfKnowledgeIsUnknown) {
  const Origin origin = analysis_of("model");
  const VectorRecord record{
      {vector_piece(origin, means(midnight, next_midnight), {5.0}, steady({1, 0}))}};
  const auto known = [&](UtcTime until) {
    return choose(record, {until, UtcTime::max()}, {}).column.times();
  };
  EXPECT_EQ(known(midnight + hours(3)), 3u) << "a mean is known when it ends";
  EXPECT_EQ(known(midnight + hours(3) - Duration(1)), 2u);
  EXPECT_EQ(known(midnight + minutes(59)), 0u);
  EXPECT_TRUE(choose(record, {midnight, UtcTime::max()}, {}).empty());
}

TEST(Choose, AForecastIsKnownFromItsReferenceTimeOnAndReachesBeyondIt) {
  const UtcTime issued = midnight - hours(6);
  const Origin origin = forecast_of("model", issued);
  const VectorRecord record{{marked(origin, 1)}};
  EXPECT_EQ(choose(record, {issued, issued}, {}).column.times(), 3u);
  EXPECT_TRUE(choose(record, {next_midnight, issued - Duration(1)}, {}).empty());
}

TEST(Choose, AFileThatHadComeInIsKnownHoweverFarItRunsOn) {
  Origin running_on = analysis_of("model");
  running_on.received = midnight - hours(2);
  const VectorRecord record{{marked(running_on, 1)}};
  const UtcTime at = midnight - hours(1);
  EXPECT_TRUE(choose(record, {at, at}, {}).empty()) << "valid later";
  EXPECT_EQ(choose(record, {at, at, at}, {}).column.times(), 3u);
  EXPECT_TRUE(choose(record, {at, at, at - hours(2)}, {}).empty()) << "came in later";
  running_on.received.reset();
  EXPECT_TRUE(choose({{marked(running_on, 1)}}, {at, at, at}, {}).empty()) << "nobody knows when";
}

TEST(Choose, ALaterForecastThatIsUnknownDoesNotHideTheEarlier) {
  const Origin early = forecast_of("model", midnight - hours(24), 1);
  const Origin late = forecast_of("model", midnight - hours(12), 2);
  const VectorRecord record{{marked(late, 2), marked(early, 1)}};
  const Chosen<Horizontal> chosen = choose(record, {midnight, midnight - hours(18)}, {});
  ASSERT_EQ(chosen.column.times(), 3u);
  EXPECT_EQ(chosen.column.value[0].real(), 1);
}

TEST(Choose, OnlyWhatTheChoiceAllowsTakesPart) {
  const Origin analysis = analysis_of("model", 1);
  const Origin forecast = forecast_of("model", midnight, 2);
  const Origin station = station_of("buoy", 3);
  const Origin other = analysis_of("other", 4);
  const VectorRecord record{
      {marked(analysis, 1), marked(forecast, 2), marked(station, 3), marked(other, 4)}};
  const auto mark = [&](const Choice& choice) {
    return choose(record, {}, choice).column.value.at(0).real();
  };
  EXPECT_EQ(mark({}), 1) << "analysed, a product, and first by name";
  EXPECT_EQ(mark({true, false, false, {}}), 2);
  EXPECT_EQ(mark({false, false, true, {}}), 3);
  EXPECT_EQ(mark({.dataset = "model"}), 1);
  EXPECT_EQ(mark({.only_forecasts = true, .dataset = "model"}), 2);
  EXPECT_TRUE(choose(record, {}, {.only_forecasts = true, .dataset = "other"}).empty());
  EXPECT_TRUE(choose(record, {}, {.dataset = "unheard of"}).empty());
  const VectorRecord without_other{{marked(analysis, 1), marked(station, 3)}};
  EXPECT_EQ(choose(without_other, {}, {false, true, false, {}}).column.value.at(0).real(), 1);
}

/// Even hours at 2 km, all hours at 4 km.
struct TwoStations {
  Origin near = station_of("near", 1);
  Origin far = station_of("far", 2);
  VectorRecord record{
      {vector_piece(far, instants(midnight, midnight + hours(4)), {5.0}, steady({2, 0}), 4000.0),
       vector_piece(near, instants(midnight, midnight + hours(4), hours(2)), {5.0}, steady({1, 0}),
                    2000.0)}};
};

TEST(Choose, TheNearestStationSpeaksAlone) {
  const TwoStations two;
  const Chosen<Horizontal> chosen = choose(two.record, {}, {});
  ASSERT_EQ(chosen.column.times(), 3u) << "its gaps are not filled by the other";
  for (const Origin* origin : chosen.origin) EXPECT_EQ(origin->dataset, "near");
  EXPECT_EQ(choose(two.record, {}, {.dataset = "far"}).column.times(), 5u);
}

TEST(Choose, AStationOfWhichNothingIsKnownYetDoesNotSilenceTheNext) {
  TwoStations two;
  for (TimeCell& cell : two.record.pieces[1].column.time)
    cell = TimeCell::instant(cell.start + hours(24));
  const Chosen<Horizontal> chosen = choose(two.record, {next_midnight - hours(1)}, {});
  ASSERT_EQ(chosen.column.times(), 5u);
  EXPECT_EQ(chosen.origin[0]->dataset, "far");
}

TEST(Choose, OtherLevelsThanTheFirstAreLeftOut) {
  const Origin first = analysis_of("model", 1);
  const Origin second = analysis_of("model", 2);
  const VectorRecord record{
      {vector_piece(first, instants(midnight, midnight + hours(1)), {5.0, 10.0}, steady({1, 0})),
       vector_piece(second, instants(midnight, midnight + hours(3)), {5.0}, steady({2, 0}))}};
  const Chosen<Horizontal> chosen = choose(record, {}, {});
  EXPECT_EQ(chosen.column.levels_m, (std::vector<double>{5.0, 10.0}));
  ASSERT_EQ(chosen.column.times(), 2u);
  EXPECT_EQ(chosen.column.value, std::vector<Horizontal>(4, Horizontal(1, 0)));
}

TEST(Choose, MissingStaysMissing) {
  const Origin origin = analysis_of("model");
  const VectorRecord record{{vector_piece(
      origin, instants(midnight, midnight + hours(1)), {5.0, 10.0}, [](UtcTime time, double depth) {
        return Horizontal(time == midnight && depth > 6 ? nan : depth, 0);
      })}};
  const Chosen<Horizontal> chosen = choose(record, {}, {});
  EXPECT_TRUE(chosen.column.has(0, 0));
  EXPECT_FALSE(chosen.column.has(0, 1));
  EXPECT_TRUE(chosen.column.has(1, 1));
}

}  // namespace
}  // namespace slackwater::choose_test
