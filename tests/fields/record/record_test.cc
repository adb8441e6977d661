#include "fields/record/choose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "fields/base/random.h"
#include "fields/record/leading_dataset.h"
#include "fields/record/slice.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using namespace tests;

const UtcTime midnight = parse_utc("2024-06-11T00:00:00Z");
const UtcTime next_midnight = midnight + hours(24);
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

/// A day of a dataset.
struct DayOf {
  Origin origin;
  Duration step;
  std::vector<double> depth_m;
  double distance_m = 0;
  Duration length = hours(24);
};

std::optional<std::string> fullest(const std::vector<DayOf>& sets) {
  VectorRecord record;
  for (const DayOf& set : sets) {
    record.pieces.push_back(vector_piece(set.origin,
                                         means(midnight, midnight + set.length, set.step),
                                         set.depth_m, steady({1, 0}), set.distance_m));
  }
  const auto leading = leading_dataset(record, midnight, next_midnight);
  std::reverse(record.pieces.begin(), record.pieces.end());
  EXPECT_EQ(leading_dataset(record, midnight, next_midnight), leading)
      << "the order of pieces plays no part";
  return leading;
}

TEST(FullestDataset, OfProductsTheOneWithMostValuesLeads) {
  EXPECT_EQ(fullest({{analysis_of("a"), hours(3), {1, 2}}, {analysis_of("b"), hours(1), {1, 2}}}),
            "b");
  EXPECT_EQ(fullest({{analysis_of("a"), hours(1), {1}}, {analysis_of("b"), hours(2), {1, 2}}}), "b")
      << "as many values on more levels";
  EXPECT_EQ(fullest({{analysis_of("b"), hours(1), {1}}, {analysis_of("a"), hours(1), {1}}}), "a")
      << "then the name";
}

TEST(FullestDataset, CountsWhatIsInTheSpanAlone) {
  const Origin here = analysis_of("here");
  const Origin elsewhere = analysis_of("elsewhere");
  const VectorRecord record{
      {vector_piece(here, instants(midnight, midnight + hours(3)), {1}, steady({1, 0})),
       vector_piece(elsewhere, instants(midnight - hours(99), midnight - hours(1)), {1},
                    steady({1, 0}))}};
  EXPECT_EQ(leading_dataset(record, midnight, next_midnight), "here");
  EXPECT_EQ(leading_dataset(record, next_midnight, next_midnight + hours(9)), std::nullopt);
  EXPECT_EQ(leading_dataset({}, midnight, next_midnight), std::nullopt);
}

TEST(FullestDataset, MissingValuesDoNotCount) {
  const Origin holes = analysis_of("holes");
  const Origin sparse = analysis_of("sparse");
  const VectorRecord record{
      {vector_piece(holes, instants(midnight, midnight + hours(20)), {1}, steady({nan, nan})),
       vector_piece(sparse, instants(midnight, midnight + hours(1)), {1}, steady({1, 0}))}};
  EXPECT_EQ(leading_dataset(record, midnight, next_midnight), "sparse");
}

TEST(FullestDataset, AProductThatResolvesTheTideLeadsOverAnInstrument) {
  const DayOf buoy{station_of("buoy"), minutes(10), {1, 2, 3}, 100.0};
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1}}, buoy}), "model");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(3), {1}}, buoy}), "model");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(4), {1}}, buoy}), "buoy");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(24), {1}}, buoy}), "buoy");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1}, 0, hours(20)}, buoy}), "model");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1}, 0, hours(19)}, buoy}), "buoy")
      << "it does not span the day";
}

TEST(FullestDataset, WhereNeitherSpansTheDayTheMoreValuesLead) {
  const DayOf buoy{station_of("buoy"), hours(1), {1, 2}, 100.0, hours(10)};
  EXPECT_EQ(fullest({{analysis_of("model"), hours(24), {1, 2, 3}}, buoy}), "buoy");
  EXPECT_EQ(fullest({{analysis_of("model"), hours(1), {1, 2}, 0, hours(10)}, buoy}), "model")
      << "of equals the product";
}

TEST(FullestDataset, OfInstrumentsThatSpanTheDayTheNearestLeads) {
  const DayOf far{station_of("far"), minutes(10), {1, 2, 3}, 3000.0};
  EXPECT_EQ(fullest({{station_of("near"), hours(1), {1}, 200.0}, far}), "near");
  EXPECT_EQ(fullest({{station_of("near"), hours(1), {1}, 200.0, hours(12)}, far}), "far")
      << "half a day is not the day";
}

TEST(FullestDataset, ModelOutputWrittenAsAPointSeriesIsAProduct) {
  Origin model = station_of("model");
  model.status = DataStatus::analysis;
  EXPECT_FALSE(is_in_situ(model));
  EXPECT_EQ(fullest({{model, hours(1), {1}}, {station_of("buoy"), minutes(10), {1}, 100.0}}),
            "model");
}

TEST(Slice, KeepsTheCellsThatLieWhollyInside) {
  const Origin origin = analysis_of("model");
  const VectorColumn hourly =
      vector_piece(origin, means(midnight, next_midnight), {5.0, 10.0},
                   [](UtcTime time, double depth) {
                     return Horizontal(hours_between(midnight, time), depth);
                   })
          .column;
  const VectorColumn part = slice(hourly, midnight + minutes(90), midnight + hours(5));
  ASSERT_EQ(part.times(), 3u) << "02-03, 03-04 and 04-05; 01-02 is cut and left out";
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_EQ(part.value[part.offset(t, 1)], Horizontal(2.5 + double(t), 10.0));
    EXPECT_EQ(part.source[t], DataStatus::analysis);
  }
  EXPECT_EQ(part.levels_m, hourly.levels_m);
  EXPECT_EQ(part.vertical, hourly.vertical);
  EXPECT_EQ(part.point, hourly.point);
}

TEST(Slice, NeighbouringSpansShareAnInstantAndDivideMeans) {
  const Origin origin = analysis_of("model");
  const UtcTime noon = midnight + hours(12);
  const VectorColumn instant =
      vector_piece(origin, instants(midnight, next_midnight), {5.0}, steady({1, 0})).column;
  EXPECT_EQ(slice(instant, midnight, noon).times() + slice(instant, noon, next_midnight).times(),
            instant.times() + 1);
  const VectorColumn mean =
      vector_piece(origin, means(midnight, next_midnight), {5.0}, steady({1, 0})).column;
  EXPECT_EQ(slice(mean, midnight, noon).times() + slice(mean, noon, next_midnight).times(),
            mean.times());
}

/// A lone cell at a distance to the north of a point, with the value 1.
GriddedField cell_north_of(const GeoPoint& point, double distance, const std::string& name) {
  double near = 0;
  double far = 1;
  const auto place = [&](double degrees) {
    return GeoPoint::from_degrees(point.latitude_deg() + degrees, point.longitude_deg());
  };
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (near + far);
    (distance_m(point, place(middle)) < distance ? near : far) = middle;
  }
  GriddedField field;
  field.standard_name = name;
  field.grid.time = instants(midnight, midnight + hours(1));
  field.grid.latitude_deg = {place(near).latitude_deg()};
  field.grid.longitude_deg = {point.longitude_deg()};
  field.values = {1, 1};
  return field;
}

TEST(RecordAt, ASeriesSpeaksAsFarAsItsQuantityReaches) {
  const GeoPoint site = GeoPoint::from_degrees(54.0, 6.5);
  const auto is_heard = [&](const std::string& name, double distance) {
    const GriddedField field = cell_north_of(site, distance, name);
    const std::vector<VectorPiece> pieces{{station_of("buoy"), field, field}};
    const VectorRecord record = record_at(pieces, site);
    if (record.pieces.empty()) return false;
    EXPECT_NEAR(record.pieces[0].distance_m, distance, 0.01);
    EXPECT_EQ(record.pieces[0].column.value[0], Horizontal(1, 1)) << "as it is, at its own place";
    return true;
  };
  const std::map<std::string, double> reach{{"eastward_sea_water_velocity", 10000},
                                            {"northward_sea_water_velocity", 10000},
                                            {"eastward_wind", 50000},
                                            {"northward_wind", 50000},
                                            {"sea_surface_wave_significant_height", 5000},
                                            {"sea_water_potential_temperature", 5000}};
  for (const auto& [name, metres] : reach) {
    EXPECT_EQ(series_reach_m(name), metres) << name;
    EXPECT_TRUE(is_heard(name, metres - 1)) << name;
    EXPECT_FALSE(is_heard(name, metres + 1)) << name;
  }
}

/// Four cells whose value is linear in latitude and longitude.
VectorPiece sloping_cells() {
  VectorPiece piece;
  piece.origin = analysis_of("model");
  piece.east.grid.time = instants(midnight, midnight);
  piece.east.grid.latitude_deg = {54.0, 54.5};
  piece.east.grid.longitude_deg = {6.0, 6.5};
  piece.east.values = {0.0F, 1.0F, 2.0F, 3.0F};
  piece.north = piece.east;
  return piece;
}

TEST(RecordAt, AGridAnswersWhereItIsAsked) {
  const std::vector<VectorPiece> pieces{sloping_cells()};
  const VectorRecord record = record_at(pieces, GeoPoint::from_degrees(54.25, 6.125));
  ASSERT_EQ(record.pieces.size(), 1u);
  EXPECT_EQ(record.pieces[0].distance_m, 0);
  EXPECT_EQ(record.pieces[0].origin, &pieces[0].origin);
  // 2 per half degree of latitude, 1 per half degree of longitude; doubles of small numbers.
  EXPECT_NEAR(record.pieces[0].column.value[0].real(), 1.25, 1e-12);
  EXPECT_FALSE(record.on_land);
  EXPECT_TRUE(record_at(pieces, GeoPoint::from_degrees(56.0, 6.125)).pieces.empty());
}

TEST(RecordAt, DryGroundIsToldFromBeingOutside) {
  std::vector<VectorPiece> pieces{sloping_cells()};
  pieces[0].east.values.assign(4, std::numeric_limits<float>::quiet_NaN());
  const VectorRecord dry = record_at(pieces, GeoPoint::from_degrees(54.25, 6.25));
  EXPECT_TRUE(dry.pieces.empty());
  EXPECT_TRUE(dry.on_land);
  const VectorRecord outside = record_at(pieces, GeoPoint::from_degrees(56.0, 6.25));
  EXPECT_TRUE(outside.pieces.empty());
  EXPECT_FALSE(outside.on_land);
}

TEST(RecordAt, ScalarsAndVectorsAreChosenAlike) {
  const Origin early = analysis_of("waves", 1);
  const Origin late = analysis_of("waves", 2);
  const auto cells = instants(midnight, midnight + hours(2));
  const ScalarRecord record{{scalar_piece(early, cells, [](UtcTime) { return 1.0; }),
                             scalar_piece(late, cells, [](UtcTime) { return 2.0; })}};
  EXPECT_EQ(choose(record, {}, {}).column.value, std::vector<double>(3, 2.0));
  EXPECT_TRUE(choose(record, {midnight - hours(1)}, {}).empty());
}

}  // namespace
}  // namespace slackwater
