#include "twin/inspection/defect/detection_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/twin/inspection/defect/defects_for_tests.h"

namespace slackwater::tests::detection_method_test {
namespace {

using twin::Defect;
using twin::DefectKind;
using twin::DetectionMethod;
using twin::InstrumentKind;
using twin::SurfaceKind;

const std::filesystem::path data_folder = source_folder() / "data";

std::vector<std::string> files_of_data() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder / "detection"))
    files.push_back(entry.path().stem().string());
  return files;
}

DetectionMethod of_data(const std::string& name) {
  return twin::read_detection_method(Config::load(data_folder / "detection" / (name + ".yaml")));
}

Defect crack(double length_m, double depth_m = 0.001) {
  Defect defect;
  defect.size_m = length_m;
  defect.severity = depth_m;
  return defect;
}

TEST(DetectionMethods, FindHalfAtX0AndNineTenthsWhereTheLawSays) {
  const DetectionMethod m = method(method_yaml("log_logistic: {x0_mm: 37.15, b: 0.954}"));
  EXPECT_NEAR(twin::pod_of(m.curve, 0.03715), 0.5, 1e-12);
  // POD = 0.9 where (a/X0)^b = 9.
  EXPECT_NEAR(twin::pod_of(m.curve, 0.03715 * std::pow(9, 1 / 0.954)), 0.9, 1e-12);
  EXPECT_EQ(twin::pod_of(m.curve, 0), 0);
  EXPECT_LT(twin::pod_of(m.curve, 1e6), 1);
}

TEST(DetectionMethods, JoinThePointsOfATableAndHoldItsEnd) {
  const DetectionMethod m =
      method(method_yaml("table: {size_mm: [10, 20, 50], pod: [0.1, 0.5, 0.8]}"));
  for (const auto& [size_mm, pod] : {std::pair{0.0, 0.0},
                                     {5.0, 0.05},
                                     {10.0, 0.1},
                                     {15.0, 0.3},
                                     {20.0, 0.5},
                                     {35.0, 0.65},
                                     {50.0, 0.8},
                                     {900.0, 0.8}})
    EXPECT_NEAR(twin::pod_of(m.curve, 1e-3 * size_mm), pod, 1e-12) << size_mm;
}

TEST(DetectionMethods, AWorseLookIsALookAtASmallerDefect) {
  const DetectionMethod m = method(method_yaml("log_logistic: {x0_mm: 20, b: 2}"));
  const double well = twin::probability_of_detection(m, crack(0.05), 0.002);
  EXPECT_NEAR(well, 1 - 1 / (1 + 2.5 * 2.5), 1e-12);
  // Better than those of the curve: no better.
  EXPECT_EQ(twin::probability_of_detection(m, crack(0.05), 0.0001), well);
  // Five times as coarse: as if it were a fifth as long.
  EXPECT_NEAR(twin::probability_of_detection(m, crack(0.05), 0.01),
              twin::probability_of_detection(m, crack(0.01), 0.002), 1e-12);
  EXPECT_EQ(twin::probability_of_detection(m, crack(0.05), std::numeric_limits<double>::infinity()),
            0);
}

TEST(DetectionMethods, GoBySizeOrBySeverity) {
  const DetectionMethod m =
      method(method_yaml("log_logistic: {x0_mm: 1.16, b: 0.9}", "of: severity\n"));
  EXPECT_NEAR(twin::probability_of_detection(m, crack(5, 0.00116), 0.001), 0.5, 1e-12);
  const DetectionMethod anode =
      method(method_yaml("log_logistic: {x0_share: 0.4, b: 3}", "of: severity\n",
                         "finds: [anode_loss]\nby: [potential]\n"));
  EXPECT_NEAR(twin::probability_of_detection(anode, crack(5, 0.4), 0.001), 0.5, 1e-12);
}

TEST(DetectionMethods, OfDataAreProbabilitiesThatRiseAndFallWithWhatTheyShould) {
  std::set<DefectKind> found;
  for (const std::string& name : files_of_data()) {
    const DetectionMethod m = of_data(name);
    found.insert(m.finds.begin(), m.finds.end());
    double before = 0;
    for (double size = 1e-5; size < 100; size *= 1.1) {
      const double pod = twin::probability_of_detection(m, crack(size, size), m.at_detail_m);
      EXPECT_TRUE(pod >= before && pod <= 1) << name << " " << size;
      EXPECT_LE(twin::probability_of_detection(m, crack(size, size), 3 * m.at_detail_m), pod);
      before = pod;
    }
    EXPECT_GT(before, 0.9) << name << ": nothing is large enough for it";
    EXPECT_FALSE(m.source.empty() || m.status.empty()) << name;
  }
  EXPECT_EQ(found.size(), twin::defect_kinds) << "a kind that nothing finds";
}

TEST(DetectionMethods, OfDataHaveTheFiguresOfTheirSource) {
  struct Case {
    const char* name;
    double x0_mm;
    double b;
  };
  for (const Case& c :
       {Case{"close_visual_easy", 15.78, 1.079}, Case{"close_visual_moderate", 37.15, 0.954},
        Case{"close_visual_difficult", 83.03, 1.079}, Case{"underwater_mpi_ec", 1.16, 0.90},
        Case{"mpi_ec_in_air", 0.45, 0.90}}) {
    const auto curve = std::get<twin::LogLogisticPod>(of_data(c.name).curve);
    EXPECT_NEAR(1e3 * curve.x0, c.x0_mm, 1e-9) << c.name;
    EXPECT_EQ(curve.b, c.b) << c.name;
  }
}

/// The share of normal errors above a number of deviations, added up by Simpson's rule.
double share_above(double deviations) {
  constexpr int steps = 2000;
  const double to = 12, step = (to - deviations) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double z = deviations + i * step;
    sum += (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * std::exp(-z * z / 2);
  }
  return sum * step / 3 / std::sqrt(2 * constants::pi);
}

// Those that call what a measurement with a normal error says: by their files, in words.
TEST(DetectionMethods, OfDataThatMeasureFindWhatANormalErrorLetsThem) {
  const double special_order_m = std::hypot(0.25, 0.0075 * 25) / 2;
  EXPECT_NEAR(special_order_m, 0.156, 5e-4);
  struct Case {
    const char* name;
    double called_from;
    double sd;
  };
  for (const Case& c :
       {Case{"multibeam_scour", 0.312, 0.156}, Case{"magnetometer_burial", 0.2, 0.05},
        Case{"thickness_corrosion", 0.0005, 0.0002}, Case{"optical_chain", 0.02, 0.004},
        Case{"potential_anode", 0.48, 0.032}}) {
    const DetectionMethod m = of_data(c.name);
    for (double size = c.called_from / 20; size < 2.5 * c.called_from; size *= 1.07)
      EXPECT_NEAR(twin::probability_of_detection(m, crack(1, size), m.at_detail_m),
                  share_above((c.called_from - size) / c.sd), 1e-9)
          << c.name << " " << size;
    EXPECT_EQ(twin::pod_of(m.curve, 0), 0) << c.name << ": nothing is not found";
  }
  const DetectionMethod scour = of_data("multibeam_scour");
  EXPECT_NEAR(twin::probability_of_detection(scour, crack(1, 0.08), 1), 0.0685, 5e-5);
  EXPECT_NEAR(twin::probability_of_detection(scour, crack(1, 0.312), 1), 0.5, 1e-12);
}

TEST(DetectionMethods, FindTheirKindsOnTheirSurfacesByTheirInstruments) {
  const DetectionMethod m =
      method(method_yaml("log_logistic: {x0_mm: 20, b: 2}", "",
                         "finds: [crack, corrosion, scour]\nby: [rgb, lidar]\non: [tower, bed]\n"));
  EXPECT_TRUE(m.can_find(DefectKind::crack, SurfaceKind::tower, InstrumentKind::rgb));
  EXPECT_TRUE(m.can_find(DefectKind::scour, SurfaceKind::bed, InstrumentKind::lidar));
  EXPECT_FALSE(m.can_find(DefectKind::crack, SurfaceKind::bed, InstrumentKind::rgb));
  EXPECT_FALSE(m.can_find(DefectKind::crack, SurfaceKind::monopile, InstrumentKind::rgb));
  EXPECT_FALSE(m.can_find(DefectKind::crack, SurfaceKind::tower, InstrumentKind::multibeam));
  EXPECT_FALSE(m.can_find(DefectKind::marine_growth, SurfaceKind::tower, InstrumentKind::rgb));
}

TEST(DetectionMethods, RefuseCurvesThatAreNone) {
  struct Case {
    const char* curve;
    const char* says;
  };
  for (const Case& c : {
           Case{"table: {size_mm: [1, 2], pod: [0.1, 1.1]}", "pod"},
           Case{"table: {size_mm: [1, 2], pod: [-0.1, 0.1]}", "pod"},
           Case{"table: {size_mm: [1, 2, 3], pod: [0.1, 0.5, 0.4]}", "falls with the size"},
           Case{"table: {size_mm: [1, 3, 2], pod: [0.1, 0.2, 0.4]}", "rising order"},
           Case{"table: {size_mm: [1, 1], pod: [0.1, 0.2]}", "rising order"},
           Case{"table: {size_mm: [1, 2, 3], pod: [0.1, 0.5]}", "found 2 probabilities for 3"},
           Case{"table: {size_mm: [], pod: []}", "no sizes"},
           Case{"table: {share: [0.1], pod: [0.5]}", "size_mm"},
           Case{"log_logistic: {x0_mm: 0, b: 1}", "found 0, expected more than 0"},
           Case{"log_logistic: {x0_mm: -3, b: 1}", "found -3, expected more than 0"},
           Case{"log_logistic: {x0_mm: 3, b: 0}", "larger defects are found more often"},
           Case{"log_logistic: {x0_mm: .nan, b: 1}", "x0_mm"},
           Case{"log_logistic: {x0: 3, b: 1}", "x0_mm"},
           Case{"log_logistic: {x0_mm: 3, b: 1}\ntable: {size_mm: [1], pod: [0.5]}", "one of"},
           Case{"", "one of log_logistic, table and normal_error"},
           Case{"normal_error: {called_from_mm: 3, sd_mm: 0}", "found 0, expected more than 0"},
           Case{"normal_error: {called_from_mm: -3, sd_mm: 1}", "called_from_mm"},
           Case{"normal_error: {called_from_share: 0.3, sd_share: 0.1}", "called_from_mm"},
           Case{"normal_error: {called_from_mm: 3, sd_mm: 1}\ntable: {size_mm: [1], pod: [0.5]}",
                "one of"},
       }) {
    const std::string message = message_of([&] { (void)method(method_yaml(c.curve)); });
    EXPECT_NE(message.find(c.says), std::string::npos) << c.curve << "\n  " << message;
  }
}

TEST(DetectionMethods, RefuseWhatNobodyVouchesFor) {
  const std::string good = method_yaml("log_logistic: {x0_mm: 3, b: 1}");
  struct Case {
    const char* from;
    const char* to;
    const char* says;
  };
  for (const Case& c : {
           Case{"source: this test\n", "", "source"},
           Case{"source: this test\n", "source: ''\n", "source: is empty"},
           Case{"status: estimate\n", "", "status"},
           Case{"at_detail_mm: 2\n", "", "at_detail_mm"},
           Case{"at_detail_mm: 2\n", "at_detail_mm: 0\n", "at_detail_mm"},
           Case{"false_alarms_per_100_m2: 0\n", "", "false_alarms_per_100_m2"},
           Case{"m2: 0\n", "m2: -1\n", "false_alarms_per_100_m2"},
           Case{"finds: [crack]", "finds: [crakc]", "did you mean 'crack'"},
           Case{"finds: [crack]", "finds: []", "says nothing"},
           Case{"by: [rgb]", "by: [camera]", "found camera, expected of rgb"},
           Case{"by: [rgb]", "by: [rgb]\non: [blde]", "did you mean 'blade'"},
           Case{"finds: [crack]", "of: depth\nfinds: [crack]", "expected size or severity"},
           Case{"finds: [crack]", "of: severity\nfinds: [crack, chain_wear]", "different units"},
           Case{"by: [rgb]", "by: [rgb]\nsize_error: {relative_sd: -1}", "relative_sd"},
           Case{"by: [rgb]", "by: [rgb]\ncolour: red", "colour"},
       }) {
    std::string yaml = good;
    yaml.replace(yaml.find(c.from), std::string(c.from).size(), c.to);
    const std::string message = message_of([&] { (void)method(yaml); });
    EXPECT_NE(message.find(c.says), std::string::npos) << c.to << "\n  " << message;
  }
}

TEST(DetectionMethods, AreNamedByAPlanAndDoNotOverlap) {
  const auto read = [&](const std::vector<std::string>& names) {
    return twin::read_detection_methods(names, data_folder);
  };
  EXPECT_EQ(read({"close_visual_easy", "rgb_corrosion", "multibeam_scour"}).size(), 3U);
  // By one camera, but in air and under water.
  EXPECT_EQ(read({"underwater_mpi_ec", "mpi_ec_in_air"}).size(), 2U);
  EXPECT_NE(message_of([&] {
              (void)read({"close_visual_easy", "close_visual_difficult"});
            }).find("find crack by rgb on the same surface"),
            std::string::npos);
  const std::string message = message_of([&] { (void)read({"close_visual_eassy"}); });
  EXPECT_NE(message.find("did you mean 'close_visual_easy'"), std::string::npos) << message;
}

}  // namespace
}  // namespace slackwater::tests::detection_method_test
