#include "twin/inspection/defect/find_defects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/twin/inspection/defect/defects_for_tests.h"
#include "twin/inspection/defect/detection_score.h"

namespace slackwater::tests::find_defects_test {
namespace {

using twin::BestLook;
using twin::Defect;
using twin::DefectKind;
using twin::Finding;
using twin::Findings;
using twin::Instrument;
using twin::InstrumentKind;
using twin::MissReason;
using twin::Surface;
using twin::SurfaceKind;
using twin::SurfaceLooks;

constexpr int passes = 10000;
const std::string curve = "log_logistic: {x0_mm: 37.15, b: 0.954}";

/// One surface, one instrument and what it looked at.
struct Pass {
  std::vector<Surface> surfaces{squares("A01/monopile", SurfaceKind::monopile, 4, 1)};
  Instrument camera = instrument(InstrumentKind::rgb);
  std::vector<BestLook> looks = seen(4, 0.002);
  std::vector<twin::DetectionMethod> methods{method(method_yaml(curve))};
  double most_detail_m = std::numeric_limits<double>::infinity();

  [[nodiscard]] Findings find(const std::vector<Defect>& defects, std::uint64_t seed) const {
    const SurfaceLooks by{0, "rov1/camera", &camera, looks, most_detail_m};
    return twin::find_defects(defects, surfaces, {&by, 1}, methods, facts(), seed);
  }
};

Defect crack(double length_m, std::size_t patch = 0, std::uint32_t number = 0) {
  return {number, DefectKind::crack, 0, patch, length_m, 0.002};
}

TEST(FindingDefects, HappensAsOftenAsTheCurveSays) {
  // Length, detail of the look, and the size that the curve then sees: where it is worse than 2 mm
  // the length shrinks as much.
  struct Case {
    double length_m;
    double detail_m;
    double effective_m;
  };
  for (const Case& c : {Case{0.005, 0.002, 0.005}, Case{0.03715, 0.002, 0.03715},
                        Case{0.1, 0.002, 0.1}, Case{0.4, 0.002, 0.4}, Case{0.1, 0.0005, 0.1},
                        Case{0.1, 0.004, 0.05}, Case{0.1, 0.02, 0.01}, Case{0.4, 0.2, 0.004}}) {
    Pass pass;
    pass.looks = seen(4, c.detail_m);
    int found = 0;
    for (int seed = 0; seed < passes; ++seed)
      found += static_cast<int>(
          pass.find({crack(c.length_m)}, static_cast<std::uint64_t>(seed)).found.size());
    const double pod = 1 - 1 / (1 + std::pow(c.effective_m / 0.03715, 0.954));
    EXPECT_NEAR(found / double{passes}, pod, 3 * std::sqrt(pod * (1 - pod) / passes))
        << c.length_m << " m at " << c.detail_m << " m";
  }
}

TEST(FindingDefects, HappensAsOftenAsATableSays) {
  Pass pass;
  pass.methods = {method(method_yaml("table: {size_mm: [10, 20, 50], pod: [0.1, 0.5, 0.8]}"))};
  for (const auto& [length_m, pod] : {std::pair{0.005, 0.05}, {0.015, 0.3}, {0.2, 0.8}}) {
    int found = 0;
    for (int seed = 0; seed < passes; ++seed)
      found += static_cast<int>(
          pass.find({crack(length_m)}, static_cast<std::uint64_t>(seed)).found.size());
    EXPECT_NEAR(found / double{passes}, pod, 3 * std::sqrt(pod * (1 - pod) / passes)) << length_m;
  }
}

TEST(FindingDefects, RaisesAsManyFalseAlarmsAsItsRate) {
  // 25 m2, of which 6 were not seen and 1 was seen too poorly to be read.
  for (const double rate : {0.5, 20.0}) {
    Pass pass;
    pass.surfaces = {sheet_of("A01/monopile", SurfaceKind::monopile, {1, 2, 1, 1}, {1, 3, 1})};
    pass.looks = seen(12, 0.002);
    pass.looks[5] = {};  // 2 m by 3 m
    pass.looks[11].detail_m = 0.1F;
    pass.most_detail_m = 0.05;
    const double area_m2 = 25 - 6 - 1;
    pass.methods[0].false_alarms_per_100_m2 = rate;
    double alarms = 0, on_large = 0;
    for (int seed = 0; seed < passes; ++seed) {
      const Findings findings = pass.find({}, static_cast<std::uint64_t>(seed));
      ASSERT_EQ(findings.read_m2, area_m2);
      alarms += static_cast<double>(findings.found.size());
      for (const Finding& finding : findings.found) {
        ASSERT_FALSE(finding.defect);
        ASSERT_TRUE(finding.patch != 5 && finding.patch != 11);
        on_large += finding.patch == 1 ? 1 : 0;
      }
    }
    // Poisson: the variance of a count is its mean.
    const double expected = passes * 0.01 * rate * area_m2, large = passes * 0.01 * rate * 2;
    EXPECT_NEAR(alarms, expected, 3 * std::sqrt(expected)) << rate;
    EXPECT_NEAR(on_large, large, 3 * std::sqrt(large)) << rate;
  }
}

TEST(FindingDefects, LosesNothingThatAWorseLookFound) {
  Rng rng(3, "tests/better_looks");
  Pass worse, better;
  worse.surfaces = better.surfaces = {squares("A01/monopile", SurfaceKind::monopile, 20, 10)};
  std::vector<Defect> defects;
  for (std::uint32_t i = 0; i < 200; ++i)
    defects.push_back(crack(0.01 * std::pow(50, rng.uniform()), i, i));
  std::size_t gained = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    worse.looks = seen(200, 0.01);
    for (BestLook& look : worse.looks) {
      look.detail_m *= static_cast<float>(std::pow(10, rng.uniform(-1, 1)));
      if (rng.uniform() < 0.2) look = {};
    }
    better.looks = worse.looks;
    for (BestLook& look : better.looks) {
      if (!look.is_seen()) look = seen(1, 0.05)[0];
      look.detail_m *= static_cast<float>(rng.uniform());
      look.looks += 7;
    }
    std::set<std::uint32_t> before, after;
    for (const Finding& f : worse.find(defects, seed).found) before.insert(*f.defect);
    for (const Finding& f : better.find(defects, seed).found) after.insert(*f.defect);
    for (const std::uint32_t number : before) EXPECT_TRUE(after.contains(number)) << number;
    gained += after.size() - before.size();
  }
  EXPECT_GT(gained, 500U) << "better looks bring nothing: the test says nothing";
}

TEST(FindingDefects, IsNotThrownAgainByLookingAgain) {
  Pass pass;
  pass.methods[0].false_alarms_per_100_m2 = 50;
  const auto reported = [&](std::uint32_t looks) {
    for (BestLook& look : pass.looks) look.looks = looks;
    std::vector<std::pair<bool, std::size_t>> all;
    for (std::uint64_t seed = 0; seed < 200; ++seed)
      for (const Finding& f : pass.find({crack(0.04)}, seed).found)
        all.emplace_back(f.defect.has_value(), f.patch);
    return all;
  };
  EXPECT_EQ(reported(1), reported(100));
}

TEST(FindingDefects, SaysWhereTheVehicleTookItselfToBe) {
  Pass pass;
  pass.methods[0].false_alarms_per_100_m2 = 100;
  for (BestLook& look : pass.looks) {
    look.off_north_m = 0.75F;
    look.off_east_m = -1.5F;
    look.off_down_m = 0.25F;
    look.t_s = 1234;
  }
  std::size_t alarms = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const Finding& f : pass.find({crack(50, 2)}, seed).found) {
      const twin::Triple<double> at = pass.surfaces[0].patches[f.patch].centre_m;
      EXPECT_EQ(f.true_position_m.x, at.x);
      EXPECT_EQ(f.position_m.x, at.x + 0.75);
      EXPECT_EQ(f.position_m.y, at.y - 1.5);
      EXPECT_EQ(f.position_m.z, at.z + 0.25);
      EXPECT_EQ(f.t_s, 1234);
      EXPECT_EQ(f.instrument, "rov1/camera");
      EXPECT_NEAR(f.detail_m, 0.002, 1e-9);
      alarms += f.defect ? 0 : 1;
    }
  EXPECT_GT(alarms, 20U);
}

TEST(FindingDefects, MeasuresSizesWithTheErrorOfItsMethod) {
  Pass pass;
  pass.methods[0].size_sd = 0.2;
  pass.methods[0].size_bias = -0.1;
  double sum = 0, squares = 0, n = 0;
  for (int seed = 0; seed < passes; ++seed)
    for (const Finding& f : pass.find({crack(4)}, static_cast<std::uint64_t>(seed)).found) {
      const double off = f.size_m / f.true_size_m - 1;
      EXPECT_EQ(f.true_size_m, 4);
      sum += off;
      squares += off * off;
      ++n;
    }
  const double sd = std::sqrt((squares - sum * sum / n) / (n - 1));
  EXPECT_NEAR(sum / n, -0.1, 3 * 0.2 / std::sqrt(n));
  EXPECT_NEAR(sd, 0.2, 3 * 0.2 / std::sqrt(2 * n));
}

TEST(FindingDefects, ReadsTheSeverityOffWhereTheInstrumentMeasuresIt) {
  Pass pass;
  pass.surfaces = {squares("A01/bed", SurfaceKind::bed, 4, 1)};
  pass.camera = instrument(InstrumentKind::multibeam);
  pass.camera.noise_sd = 0.02;
  pass.camera.noise_per_range = 0.001;
  pass.camera.bias_sd = 0.05;
  for (BestLook& look : pass.looks) look.range_m = 30;
  pass.methods = {method(method_yaml("log_logistic: {x0_mm: 1, b: 9}", "of: severity\n",
                                     "finds: [scour]\nby: [multibeam]\n"))};
  const Defect scour{0, DefectKind::scour, 0, 1, 5, 1.5};
  double sum = 0, squares = 0;
  for (int seed = 0; seed < passes; ++seed) {
    const Findings findings = pass.find({scour}, static_cast<std::uint64_t>(seed));
    ASSERT_EQ(findings.found.size(), 1U);
    const Finding& f = findings.found[0];
    ASSERT_TRUE(f.severity && f.reading);
    EXPECT_EQ(f.reading->truth, 1.5);
    EXPECT_EQ(*f.severity, f.reading->value);
    const double off = *f.severity - f.true_severity;
    sum += off;
    squares += off * off;
  }
  const double variance = 0.05 * 0.05 + 0.05 * 0.05;  // of noise at 30 m, and of bias
  EXPECT_NEAR(sum / passes, 0, 3 * std::sqrt(variance / passes));
  EXPECT_NEAR(squares / passes / variance, 1, 3 * std::sqrt(2.0 / passes));
}

TEST(FindingDefects, SaysWhyOneWasMissed) {
  Pass pass;
  pass.looks[1] = {};
  pass.looks[2].detail_m = 0.05F;
  const auto reason = [&](const Defect& defect, std::uint64_t seed) {
    const Findings findings = pass.find({defect}, seed);
    EXPECT_EQ(findings.found.size() + findings.missed.size(), 1U);
    return findings.missed.empty() ? "" : findings.missed[0].words;
  };
  EXPECT_EQ(reason(crack(0.5, 1), 1), "not seen");
  Defect rust = crack(0.5, 0);
  rust.kind = DefectKind::corrosion;
  EXPECT_EQ(reason(rust, 1), "no instrument that looked at A01/monopile finds corrosion");
  // Seen at 50 mm in the place of 2, 37.15 mm are 1.486: 4.4 of 100 such looks would find it, half
  // of good ones. So of all misses, (1/2 - 0.044) are of the look and 1/2 of chance.
  int poor = 0, chance = 0;
  for (std::uint64_t seed = 0; seed < passes; ++seed) {
    const std::string words = reason(crack(0.03715, 2), seed);
    poor += words == "seen too poorly: least detail 50 mm, found in 4 of 100 such looks" ? 1 : 0;
    chance +=
        words == "overlooked by chance: least detail 50 mm, found in 4 of 100 such looks" ? 1 : 0;
  }
  const double pod = 1 - 1 / (1 + std::pow(0.04, 0.954));
  EXPECT_NEAR(poor / double{passes}, 0.5 - pod, 3 * 0.5 / std::sqrt(passes));
  EXPECT_NEAR(chance / double{passes}, 0.5, 3 * 0.5 / std::sqrt(passes));
}

TEST(FindingDefects, IsIndependentFromInstrumentToInstrument) {
  const Pass pass;
  int by_either = 0, by_both = 0;
  const std::vector<SurfaceLooks> looks{{0, "rov1/camera", &pass.camera, pass.looks},
                                        {0, "rov2/camera", &pass.camera, pass.looks}};
  const std::vector<Defect> defects{crack(0.03715)};
  for (std::uint64_t seed = 0; seed < passes; ++seed) {
    const Findings findings =
        twin::find_defects(defects, pass.surfaces, looks, pass.methods, facts(), seed);
    by_either += findings.missed.empty() ? 1 : 0;
    by_both += findings.found.size() == 2 ? 1 : 0;
    const twin::DetectionScore score = twin::score_of(defects, findings);
    ASSERT_EQ(score.all.found, findings.missed.empty() ? 1U : 0U);
  }
  EXPECT_NEAR(by_either / double{passes}, 0.75, 3 * std::sqrt(0.75 * 0.25 / passes));
  EXPECT_NEAR(by_both / double{passes}, 0.25, 3 * std::sqrt(0.75 * 0.25 / passes));
}

TEST(FindingDefects, RefusesMethodsThatContradictEachOther) {
  Pass pass;
  pass.methods.push_back(pass.methods[0]);
  EXPECT_NE(message_of([&] { (void)pass.find({}, 1); }).find("leave one of them out"),
            std::string::npos);
}

TEST(DetectionScores, AreTheRatesOfWhatWasReported) {
  const std::vector<Defect> defects{
      crack(0.1, 0, 0), crack(0.2, 1, 1), {2, DefectKind::scour, 0, 0, 4, 1}};
  Findings findings;
  findings.read_m2 = 50;
  const auto add = [&](std::optional<std::uint32_t> defect, DefectKind kind, double size_m,
                       double true_size_m) {
    Finding finding;
    finding.defect = defect;
    finding.kind = kind;
    finding.size_m = size_m;
    finding.true_size_m = true_size_m;
    findings.found.push_back(finding);
  };
  add(0, DefectKind::crack, 0.13, 0.1);
  add(2, DefectKind::scour, 4.4, 4);
  add(std::nullopt, DefectKind::crack, 0.3, 0);
  findings.missed.push_back({defects[1], MissReason::not_seen, "not seen"});
  const twin::DetectionScore score = twin::score_of(defects, findings);
  EXPECT_NEAR(*score.detection_rate, 2.0 / 3, 1e-12);
  EXPECT_NEAR(*score.false_alarms_per_100_m2, 2, 1e-12);
  EXPECT_NEAR(*score.size_error_rms_m, std::sqrt((0.03 * 0.03 + 0.4 * 0.4) / 2), 1e-12);
  EXPECT_NEAR(*score.size_error_relative_rms, std::sqrt((0.09 + 0.01) / 2), 1e-12);
  const auto& cracks = score.kinds[static_cast<std::size_t>(DefectKind::crack)];
  EXPECT_EQ(cracks.planted, 2U);
  EXPECT_EQ(cracks.found, 1U);
  EXPECT_EQ(cracks.false_alarms, 1U);
  EXPECT_EQ(score.all.planted, 3U);
  EXPECT_EQ(score.all.false_alarms, 1U);
}

TEST(DetectionScores, AreAbsentWhereThereIsNothingToRate) {
  const twin::DetectionScore score = twin::score_of({}, {});
  EXPECT_FALSE(score.detection_rate || score.false_alarms_per_100_m2 || score.size_error_rms_m);
}

}  // namespace
}  // namespace slackwater::tests::find_defects_test
