// One run of one product speaks as long as it lasts: made-up products with known values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"
#include "fields/record/cadence.h"
#include "fields/record/choose.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::one_source_test {
namespace {

using std::chrono::hours;
using namespace tests;

const UtcTime start = parse_utc("2024-06-11T00:00:00Z");
constexpr Duration ramp = hours(6);

std::vector<UtcTime> at_hours(const std::vector<int>& h) {
  std::vector<UtcTime> times;
  for (const int hour : h) times.push_back(start + hours(hour));
  return times;
}

TEST(Cadence, AHoleIsMoreThanTwoAndAHalfOfTheStepsBesideIt) {
  EXPECT_FALSE(is_hole(at_hours({0, 1, 3, 4}), 1)) << "one value is missing";
  EXPECT_TRUE(is_hole(at_hours({0, 1, 4, 5}), 1));
  EXPECT_FALSE(is_hole(at_hours({0, 3, 6, 7, 8}), 1)) << "three-hourly before, hourly after";
  EXPECT_FALSE(is_hole(at_hours({0, 6}), 0)) << "nothing to compare with";
}

TEST(Cadence, TwelveHourlySeriesHaveNoGaps) {
  EXPECT_TRUE(may_interpolate(at_hours({0, 12, 24, 36}), 1));
  EXPECT_FALSE(may_interpolate(at_hours({0, 12, 36, 48}), 1)) << "one value is missing";
  EXPECT_TRUE(may_interpolate(at_hours({0, 1, 13, 14}), 1)) << "twelve hours at most";
  EXPECT_FALSE(may_interpolate(at_hours({0, 1, 14, 15}), 1));
  EXPECT_TRUE(may_interpolate(at_hours({0, 24, 48}), 0)) << "means of days";
}

TEST(Cadence, PartsEndAtHolesAndGaps) {
  const auto parts = whole_parts(at_hours({0, 1, 2, 6, 7, 8, 40}));
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0], (TimeSpan{start, start + hours(2)}));
  EXPECT_EQ(parts[1], (TimeSpan{start + hours(6), start + hours(8)}));
  EXPECT_EQ(parts[2], (TimeSpan{start + hours(40), start + hours(40)}));
  EXPECT_TRUE(whole_parts({}).empty());
}

Origin regional(Origin origin) {
  origin.rank.is_regional = true;
  return origin;
}

Choice joined_over(Duration length) {
  Choice choice;
  choice.ramp = length;
  return choice;
}

/// Two products over the same two days: one every hour, the other every six.
struct TwoProducts {
  Origin fine = analysis_of("fine", 1);
  Origin coarse = analysis_of("coarse", 2);
  VectorRecord record;

  void add(const Origin& origin, int from_h, int to_h, int step_h, Horizontal value) {
    record.pieces.push_back(
        vector_piece(origin, instants(start + hours(from_h), start + hours(to_h), hours(step_h)),
                     {}, steady(value)));
  }
};

TEST(OneSource, ProductsOfDifferentCadenceDoNotAlternate) {
  TwoProducts two;
  two.coarse = regional(two.coarse);
  two.add(two.fine, 0, 48, 1, {0, 8});
  two.add(two.coarse, 0, 48, 6, {8, 0});
  const Chosen<Horizontal> chosen = choose(two.record, {}, {});
  ASSERT_EQ(chosen.column.times(), 9u) << "six-hourly stamps of the regional one alone";
  for (const Horizontal value : chosen.column.value) EXPECT_EQ(value, Horizontal(8, 0));
  ASSERT_EQ(chosen.stretches.size(), 1u);
  EXPECT_EQ(chosen.stretches[0].origin->dataset, "coarse");
  EXPECT_EQ(chosen.stretches[0].why, "made for the region");
}

TEST(OneSource, PrecedenceIsTideThenRegionThenGridThenTheNewestRun) {
  const auto better = [&](auto change_one, auto change_other) {
    TwoProducts two;
    change_one(two.fine);
    change_other(two.coarse);
    two.add(two.fine, 0, 9, 1, {1, 0});
    two.add(two.coarse, 0, 9, 1, {2, 0});
    return choose(two.record, {}, {}).column.value.front().real();
  };
  const auto nothing = [](Origin&) {};
  const auto is_regional = [](Origin& o) { o.rank.is_regional = true; };
  const auto lacks_tide = [](Origin& o) { o.rank.has_tide = false, o.rank.is_regional = true; };
  const auto grid = [](double deg) { return [deg](Origin& o) { o.rank.spacing_deg = deg; }; };
  const auto issued = [](int h) {
    return [h](Origin& o) {
      o.status = DataStatus::forecast;
      o.reference_time = start - hours(h);
    };
  };
  EXPECT_EQ(better(nothing, nothing), 2) << "by name: coarse before fine";
  EXPECT_EQ(better(nothing, lacks_tide), 1) << "the tide counts before the region";
  EXPECT_EQ(better(is_regional, grid(0.01)), 1) << "the region before the grid";
  EXPECT_EQ(better(grid(0.02), grid(0.08)), 1);
  EXPECT_EQ(better(grid(0.25), nothing), 1) << "a grid that is not known is the coarsest";
  EXPECT_EQ(better(issued(6), issued(12)), 1);
  EXPECT_EQ(better(issued(6), issued(6)), 2);
}

TEST(OneSource, WhereTheBestEndsTheNextIsMovedOntoItOverTheRamp) {
  TwoProducts two;
  two.fine = regional(two.fine);
  two.add(two.fine, 0, 24, 1, {8, 0});
  two.add(two.coarse, 0, 48, 1, {5, 3});
  const Chosen<Horizontal> chosen = choose(two.record, {}, joined_over(ramp));
  ASSERT_EQ(chosen.column.times(), 49u);
  for (std::size_t h = 0; h <= 48; ++h) {
    const double left = h <= 24 ? 1 : std::max(0.0, 1 - (double(h) - 24) / 6);
    const Horizontal expected = Horizontal(5, 3) + left * Horizontal(3, -3);
    EXPECT_NEAR(std::abs(chosen.column.value[h] - expected), 0, 1e-12) << h;
  }
  ASSERT_EQ(chosen.stretches.size(), 2u);
  EXPECT_EQ(chosen.stretches[1].from, start + hours(25));
  EXPECT_EQ(chosen.stretches[1].why, "where the analysis of fine ends");
}

TEST(OneSource, AHoleOfTheBestIsFilledByTheNextAndMeetsItAtBothEnds) {
  TwoProducts two;
  two.fine = regional(two.fine);
  two.add(two.fine, 0, 10, 1, {8, 0});
  two.add(two.fine, 14, 24, 1, {2, 0});
  two.add(two.coarse, 0, 24, 1, {5, 0});
  const Chosen<Horizontal> chosen = choose(two.record, {}, joined_over(ramp));
  ASSERT_EQ(chosen.column.times(), 25u);
  for (std::size_t h = 10; h <= 14; ++h) {
    const double line = 8 - 6 * (double(h) - 10) / 4;
    EXPECT_NEAR(chosen.column.value[h].real(), line, 1e-12)
        << "three above at one end, three below at the other, faded over the four hours";
  }
  EXPECT_EQ(chosen.stretches.size(), 3u);
}

/// Runs of five products, each at some of three heights, at drawn cadences and times, with holes.
struct AnyWinds {
  explicit AnyWinds(std::uint64_t seed) : rng(seed, "tests/record/joins") {
    for (int p = 0; p < 5; ++p) {
      const UtcTime issued = start - hours(6 * static_cast<int>(rng.uniform(0, 4)));
      const Horizontal mean(rng.uniform(-9, 9), rng.uniform(-9, 9));
      const double period_h = rng.uniform(20, 60);
      const int from_h = static_cast<int>(rng.uniform(0, 30));
      const int always = static_cast<int>(rng.uniform(0, 3));
      for (int h = 0; h < 3; ++h) {
        if (rng.uniform(0, 1) < 0.5 && h != always) continue;
        add(p, h, issued, from_h, [=](UtcTime time, double) {
          // What the profile misses of each height is of its own.
          return (1 + 0.1 * h) * mean +
                 3.0 * std::polar(1.0, 0.5 * h + 6.283 * hours_between(start, time) / period_h);
        });
        steepest_m_s_h = std::max(steepest_m_s_h, 3 * 6.283 / period_h);
      }
    }
  }
  void add(int product, int height, UtcTime issued, int from_h, const FlowForTests& flow) {
    constexpr double height_m[] = {10, 100, 120};
    const std::string name = "model " + std::to_string(product);
    const int number = 3 * product + height;
    origins.push_back(forecast_of(name + "@" + std::to_string(height), issued, number));
    origins.back().product_id = name;
    const int step_h = 1 << static_cast<int>(rng.uniform(0, 3));
    const int first_h = from_h + static_cast<int>(rng.uniform(0, 12));
    const int last_h = from_h + 48 + static_cast<int>(rng.uniform(0, 24));
    std::vector<TimeCell> times =
        instants(start + hours(first_h), start + hours(last_h), hours(step_h));
    const int hole_h = from_h + static_cast<int>(rng.uniform(0, 60));
    std::erase_if(times, [&](const TimeCell& cell) {
      return cell.start > start + hours(hole_h) && cell.start < start + hours(hole_h + 9);
    });
    record.pieces.push_back(vector_piece(origins.back(), times, {}, flow));
    if (height > 0) record.pieces.back().from_height_m = height_m[height];
    for (const FlowForTests& other : flows) {
      for (int h = 0; h < 100; ++h) {
        const UtcTime time = start + hours(h);
        apart_m_s = std::max(apart_m_s, std::abs(flow(time, 0) - other(time, 0)));
      }
    }
    flows.push_back(flow);
  }
  [[nodiscard]] const PieceColumn<Horizontal>& piece_of(const Origin* origin) const {
    return *std::find_if(record.pieces.begin(), record.pieces.end(),
                         [&](const auto& piece) { return piece.origin == origin; });
  }

  Rng rng;
  std::deque<Origin> origins;
  VectorRecord record;
  std::vector<FlowForTests> flows;
  double steepest_m_s_h = 0;
  double apart_m_s = 0;
};

/// From the first to the last value of each unbroken part of a piece.
std::vector<TimeSpan> parts_of(const PieceColumn<Horizontal>& piece) {
  std::vector<UtcTime> times;
  for (const TimeCell& cell : piece.column.time) times.push_back(cell.centre());
  return whole_parts(times);
}

TEST(OneSource, NoJumpAtAJoinIsLargerThanTheRunsOwnAndNobodySpeaksBeyondItsTime) {
  std::size_t joins = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    AnyWinds any(seed);
    Knowledge knowledge;
    knowledge.forecasts_issued_by = start - hours(6 * static_cast<int>(any.rng.uniform(0, 3)));
    const Chosen<Horizontal> chosen = choose(any.record, knowledge, joined_over(ramp));
    joins += chosen.stretches.empty() ? 0 : chosen.stretches.size() - 1;
    for (const Stretch& stretch : chosen.stretches) {
      EXPECT_LE(*stretch.origin->reference_time, knowledge.forecasts_issued_by);
      const PieceColumn<Horizontal>& piece = any.piece_of(stretch.origin);
      EXPECT_GE(stretch.from, piece.column.time.front().start) << "before its run begins";
      EXPECT_LE(stretch.to, piece.column.time.back().start) << "beyond its run's end";
      EXPECT_EQ(stretch.from_height_m, piece.from_height_m);
    }
    for (std::size_t t = 1; t < chosen.column.times(); ++t) {
      // Across a hole that nobody fills no step is promised.
      if (chosen.column.time[t].start - chosen.column.time[t - 1].start > hours(4)) continue;
      const double h =
          hours_between(chosen.column.time[t - 1].centre(), chosen.column.time[t].centre());
      const double step = std::abs(chosen.column.value[t] - chosen.column.value[t - 1]);
      // What the runs do themselves, and the ramp's share of how far they are apart, at both ends.
      const double most = any.steepest_m_s_h * (h + 4) + 2 * any.apart_m_s * h / 6;
      EXPECT_LE(step, most) << "seed " << seed << " at " << t;
    }
    std::reverse(any.record.pieces.begin(), any.record.pieces.end());
    EXPECT_EQ(choose(any.record, knowledge, joined_over(ramp)).column.value, chosen.column.value);
  }
  EXPECT_GT(joins, 200u) << "the drawn runs do take over from each other";
}

TEST(OneSource, TwoHeightsOfARunNeverAlternateWhateverTheirCadences) {
  std::size_t silenced = 0;
  std::size_t taken_over = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    const AnyWinds any(seed);
    const Chosen<Horizontal> chosen = choose(any.record, {}, joined_over(ramp));
    std::vector<std::vector<TimeSpan>> parts;
    for (const PieceColumn<Horizontal>& piece : any.record.pieces) parts.push_back(parts_of(piece));
    for (std::size_t t = 0; t < chosen.column.times(); ++t) {
      const UtcTime time = chosen.column.time[t].centre();
      const PieceColumn<Horizontal>& speaks = any.piece_of(chosen.origin[t]);
      for (std::size_t p = 0; p < parts.size(); ++p) {
        const PieceColumn<Horizontal>& other = any.record.pieces[p];
        if (other.origin->product_id != speaks.origin->product_id) continue;
        const bool is_nearer = other.from_height_m.value_or(10) < speaks.from_height_m.value_or(10);
        const bool lasts = std::any_of(parts[p].begin(), parts[p].end(), [&](const TimeSpan& part) {
          return part.from <= time && time <= part.to;
        });
        EXPECT_FALSE(is_nearer && lasts)
            << "seed " << seed << ": " << speaks.from_height_m.value_or(10) << " m speaks at "
            << format_utc(time) << " while " << other.from_height_m.value_or(10) << " m lasts";
        if (&other != &speaks && lasts) ++silenced;
        if (is_nearer) ++taken_over;
      }
    }
    for (const Stretch& stretch : chosen.stretches) {
      for (std::size_t t = 0; t < chosen.column.times(); ++t) {
        const UtcTime time = chosen.column.time[t].centre();
        if (time < stretch.from || time > stretch.to) continue;
        EXPECT_EQ(any.piece_of(chosen.origin[t]).from_height_m, stretch.from_height_m)
            << "seed " << seed << ": a stretch of two heights";
      }
    }
  }
  EXPECT_GT(silenced, 1000u) << "the heights do overlap";
  EXPECT_GT(taken_over, 100u) << "and one goes on where a nearer one ends";
}

TEST(OneSource, StatedTenMetreWindBeforeAnyOtherHeightOfTheRun) {
  const Origin low = analysis_of("model@10", 1);
  const Origin high = analysis_of("model@100", 2);
  for (const bool is_high_first : {false, true}) {
    VectorRecord record{
        {vector_piece(low, instants(start, start + hours(9), hours(3)), {}, steady({8, 0})),
         vector_piece(high, instants(start, start + hours(9)), {}, steady({12.4, 0}))}};
    record.pieces[1].from_height_m = 100;
    if (is_high_first) std::swap(record.pieces[0], record.pieces[1]);
    const Chosen<Horizontal> chosen = choose(record, {}, {});
    ASSERT_EQ(chosen.column.times(), 4u) << "not mixed along the series";
    for (const Horizontal value : chosen.column.value) EXPECT_EQ(value.real(), 8);
    EXPECT_EQ(chosen.stretches[0].why, "stated nearer to 10 m");
    EXPECT_FALSE(chosen.stretches[0].from_height_m);
  }
}

TEST(OneSource, WhereOnlyAnotherHeightIsThereItSpeaksAndIsMarked) {
  const Origin high = analysis_of("model@100", 2);
  VectorRecord record{
      {vector_piece(high, instants(start, start + hours(9)), {}, steady({12.4, 0}))}};
  record.pieces[0].from_height_m = 100;
  EXPECT_EQ(choose(record, {}, {}).stretches.at(0).from_height_m, 100);
}

Origin member(const std::string& dataset, UtcTime issued, int number) {
  Origin origin = forecast_of(dataset, issued, number);
  origin.ensemble_member = number;
  return origin;
}

TEST(OneSource, AnEnsembleWithoutControlIsItsMean) {
  std::deque<Origin> origins;
  VectorRecord record;
  for (int m = 1; m <= 5; ++m) {
    origins.push_back(member("ensemble", start, m));
    record.pieces.push_back(vector_piece(origins.back(),
                                         instants(start, start + hours(m == 3 ? 6 : 9)), {},
                                         steady({double(m * m), -double(m)})));
  }
  const Chosen<Horizontal> chosen = choose(record, {}, {});
  ASSERT_EQ(chosen.column.times(), 7u) << "as long as all members last";
  for (const Horizontal value : chosen.column.value) EXPECT_EQ(value, Horizontal(11, -3));
  EXPECT_EQ(chosen.stretches.at(0).members, 5u);
}

TEST(OneSource, AtTheEndOfADeterministicRunNoMemberJumpsIn) {
  std::deque<Origin> origins{forecast_of("model", start, 9)};
  VectorRecord record{
      {vector_piece(origins[0], instants(start, start + hours(12)), {}, steady({10, 0}))}};
  for (int m = 1; m <= 4; ++m) {
    origins.push_back(member("model", start, m));
    record.pieces.push_back(vector_piece(origins.back(), instants(start, start + hours(48)), {},
                                         steady({m < 3 ? 2.0 : 6.0, 0})));
  }
  const Chosen<Horizontal> chosen = choose(record, {}, joined_over(ramp));
  ASSERT_EQ(chosen.column.times(), 49u);
  EXPECT_EQ(chosen.column.value[12].real(), 10);
  EXPECT_NEAR(chosen.column.value[15].real(), 7, 1e-12) << "half way to the mean of 4";
  EXPECT_EQ(chosen.column.value[18].real(), 4);
  EXPECT_EQ(chosen.column.value[48].real(), 4);
}

Origin edition(std::int64_t granule, int received_h, std::optional<int> published_h = {}) {
  Origin origin = analysis_of("model", granule);
  origin.received = start + hours(received_h);
  if (published_h) origin.published = start + hours(*published_h);
  return origin;
}

/// The value that counts for an eye that stands at an hour; 1 is the first edition.
double seen_at(const Origin& first, const Origin& second, std::optional<int> hour,
               bool* may_be_revised = nullptr) {
  VectorRecord record;
  const auto day = instants(start - hours(24), start);
  record.pieces.push_back(vector_piece(first, day, {5.0}, steady({1, 0})));
  record.pieces.push_back(vector_piece(second, day, {5.0}, steady({2, 0})));
  Knowledge knowledge;
  if (hour) knowledge.seen_by = start + hours(*hour);
  const Chosen<Horizontal> chosen = choose(record, knowledge, {});
  if (may_be_revised != nullptr) *may_be_revised = chosen.stretches.at(0).may_be_revised;
  return chosen.column.value.at(0).real();
}

TEST(Editions, WhatWasThereThenIsSeenThen) {
  bool revised = true;
  EXPECT_EQ(seen_at(edition(1, 5), edition(2, 29), 6, &revised), 1);
  EXPECT_FALSE(revised);
  EXPECT_EQ(seen_at(edition(1, 5), edition(2, 29), 30), 2);
  EXPECT_EQ(seen_at(edition(1, 5), edition(2, 29), std::nullopt), 2);
  EXPECT_EQ(seen_at(edition(2, 29), edition(1, 5), 6), 2) << "whichever stands first";
}

TEST(Editions, TwoOfThemDoNotAlternate) {
  const Origin coarse = edition(2, 9);
  const Origin fine = edition(1, 5);
  const VectorRecord record{
      {vector_piece(fine, instants(start, start + hours(24)), {}, steady({1, 0})),
       vector_piece(coarse, instants(start, start + hours(12), hours(3)), {}, steady({2, 0}))}};
  const Chosen<Horizontal> chosen = choose(record, {}, {});
  ASSERT_EQ(chosen.column.times(), 5u + 12u);
  for (std::size_t t = 0; t < 17; ++t) EXPECT_EQ(chosen.column.value[t].real(), t < 5 ? 2 : 1);
}

TEST(Editions, TimesThatCameMoreThanOnceAreCounted) {
  const Origin old = edition(1, 5);
  const Origin rewritten = edition(2, 29);
  const VectorRecord record{
      {vector_piece(old, instants(start, start + hours(48)), {}, steady({1, 0})),
       vector_piece(rewritten, instants(start + hours(25), start + hours(60)), {},
                    steady({2, 0}))}};
  const Chosen<Horizontal> chosen = choose(record, {}, {});
  ASSERT_EQ(chosen.stretches.size(), 1u);
  EXPECT_EQ(chosen.stretches[0].revised_times, 24u);
}

TEST(Editions, OfAnArchiveThatWasReadLaterPublicationDecidesElseItIsSaid) {
  bool revised = false;
  EXPECT_EQ(seen_at(edition(1, 900, 3), edition(2, 800, 27), 6, &revised), 1);
  EXPECT_FALSE(revised) << "published before";
  EXPECT_EQ(seen_at(edition(1, 900, 3), edition(2, 800, 27), 28), 2) << "not by ingest order";
  EXPECT_EQ(seen_at(edition(1, 900), edition(2, 800), 6, &revised), 1) << "the last received";
  EXPECT_TRUE(revised) << "what stood there then cannot be told";
  EXPECT_EQ(seen_at(edition(1, 900, 30), edition(2, 800, 40), 6, &revised), 1)
      << "the earliest is nearest to what stood there";
  EXPECT_TRUE(revised);
}

TEST(Editions, WhereTheStoreWasBeingFilledWhatCameLaterIsUnseen) {
  const Origin of_then = edition(1, 5);
  const Origin of_later = edition(2, 50);
  VectorRecord record;
  record.pieces.push_back(
      vector_piece(of_then, instants(start - hours(48), start - hours(24)), {}, steady({1, 0})));
  record.pieces.push_back(
      vector_piece(of_later, instants(start - hours(23), start), {}, steady({2, 0})));
  Knowledge knowledge;
  knowledge.seen_by = start + hours(6);
  EXPECT_EQ(choose(record, knowledge, {}).column.times(), 25u);
  record.pieces.erase(record.pieces.begin());
  EXPECT_EQ(choose(record, knowledge, {}).column.times(), 24u) << "an archive";
}

}  // namespace
}  // namespace slackwater::one_source_test
