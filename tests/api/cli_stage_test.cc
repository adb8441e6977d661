// `stage`, and `detect --score --pod` on what it leaves: from looks to a curve that an inspection
// goes by.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "fields/base/config.h"
#include "ingest/netcdf/file.h"
#include "tests/support/contains.h"
#include "tests/support/store_for_tests.h"
#include "twin/inspection/defect/detection_method.h"

namespace slackwater::tests::cli_stage_test {
namespace {

using nlohmann::json;

class StageCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    const ProgramResult staged =
        made_->run({"stage", "pile_by_small_camera", "--looks", "40", "--seed", "5", "--threads",
                    "2", "--out", made_->path("looks"), "--json"});
    ASSERT_EQ(staged.exit_code, 0) << staged.err;
    told_ = json::parse(staged.out);
  }
  static void TearDownTestSuite() { made_.reset(); }
  static json labels() { return json::parse(read_bytes(made_->file("looks/labels.json"))); }

  static inline std::unique_ptr<StoreForTests> made_;
  static inline json told_;
};

TEST_F(StageCommand, LeavesPicturesLabelsAndACard) {
  const json set = labels();
  EXPECT_EQ(set.at("images").size(), 40U);
  EXPECT_GT(set.at("annotations").size(), 20U);
  std::size_t planted = 0;
  for (const json& image : set.at("images")) {
    EXPECT_TRUE(
        std::filesystem::exists(made_->path("looks/" + image.at("file_name").get<std::string>())));
    planted += image.at("look").at("planted").size();
  }
  EXPECT_EQ(told_.at("planted"), planted);
  const std::string card = read_bytes(made_->file("looks") / "README.md");
  EXPECT_TRUE(contains(card, "| visibility | 1.5 to 12 m |")) << card;
  EXPECT_TRUE(contains(card, "40 rendered pictures")) << card;
}

/// Whoever could not tell it is not asked for it.
TEST_F(StageCommand, WhatNobodyCouldTellIsACrowd) {
  const json set = labels();
  std::size_t crowds = 0, hidden = 0;
  for (const json& label : set.at("annotations")) {
    const json& image = set.at("images").at(label.at("image_id").get<std::size_t>() - 1);
    const json& planted =
        image.at("look").at("planted").at(label.at("planted_number").get<std::size_t>());
    const bool is_small = label.at("area") < 25;
    const bool is_hidden = planted.at("detail_m").is_null() ||
                           planted.at("size_m") < planted.at("detail_m") ||
                           planted.at("signal_to_noise") < 5;
    EXPECT_EQ(label.at("iscrowd"), is_small || is_hidden ? 1 : 0) << planted;
    crowds += is_small || is_hidden ? 1 : 0;
    hidden += is_hidden && !is_small ? 1 : 0;
  }
  EXPECT_GT(hidden, 0U);
  EXPECT_LT(crowds, set.at("annotations").size() / 2);
}

TEST_F(StageCommand, TheSameSeedIsTheSameBytes) {
  ASSERT_EQ(made_
                ->run({"stage", "pile_by_small_camera", "--looks", "3", "--seed", "5", "--out",
                       made_->path("again")})
                .exit_code,
            0);
  EXPECT_EQ(read_bytes(made_->file("again/look_000002.png")),
            read_bytes(made_->file("looks/look_000002.png")));
}

/// The mask of a defect in the netCDF has as many pixels as the picture's labels say, and its
/// distance is that of the look.
TEST_F(StageCommand, TheTruthBesideAPictureIsThatOfItsLabels) {
  ASSERT_EQ(made_
                ->run({"stage", "pile_by_small_camera", "--looks", "3", "--seed", "5", "--truth",
                       "--out", made_->path("true")})
                .exit_code,
            0);
  EXPECT_EQ(read_bytes(made_->file("true/look_000002.png")),
            read_bytes(made_->file("looks/look_000002.png")));
  const json set = json::parse(read_bytes(made_->file("true/labels.json")));
  std::map<int, double> area;  // of all labels of an image
  for (const json& one : set.at("annotations"))
    area[one.at("image_id").get<int>()] += one.at("area").get<double>();
  for (const json& image : set.at("images")) {
    const std::string name = image.at("file_name").get<std::string>();
    const auto file =
        ingest::netcdf::File::open(made_->path("true/" + name.substr(0, name.size() - 3) + "nc"));
    const std::vector<double> defect = file.read_all(*file.find("defect")),
                              depth = file.read_all(*file.find("depth"));
    ASSERT_EQ(defect.size(), 640U * 360);
    EXPECT_EQ(std::count_if(defect.begin(), defect.end(), [](double of) { return of > 0; }),
              area[image.at("id").get<int>()])
        << name;
    const double range_m = image.at("look").at("range_m");
    EXPECT_NEAR(depth[180 * 640 + 320], range_m, 0.01 * range_m) << name;
  }
}

TEST_F(StageCommand, ADetectorsCurveIsOneThatAnInspectionReads) {
  const ProgramResult scored =
      made_->run({"detect", "--score", made_->path("looks"), "--by", "corrosion_by_colour", "--pod",
                  made_->path("pod"), "--json"});
  ASSERT_EQ(scored.exit_code, 0) << scored.err;
  const json out = json::parse(scored.out);
  EXPECT_EQ(out.at("thirds").size(), 6U);  // of range and of visibility, three each
  const json& pod = out.at("pod").at(0);
  EXPECT_EQ(pod.at("kind"), "corrosion");
  EXPECT_GT(pod.at("looked_for"), 15);
  ASSERT_FALSE(pod.at("x0_m").is_null());
  const auto method = twin::read_detection_method(
      Config::load(made_->path("pod/corrosion_by_corrosion_by_colour.yaml")));
  EXPECT_EQ(method.status, "estimate");
  const auto& curve = std::get<twin::LogLogisticPod>(method.curve);
  EXPECT_NEAR(curve.x0, pod.at("x0_m").at("value").get<double>(), 1e-3 * curve.x0);
}

/// Looks of seeds that it did not learn from; how well it does on a stage that it never saw is
/// measured by tests/soak/learn_looks.
TEST_F(StageCommand, TheShippedDetectorFindsRustInThem) {
  const ProgramResult scored =
      made_->run({"detect", "--score", made_->path("looks"), "--by", "rust_and_cracks", "--json"});
  ASSERT_EQ(scored.exit_code, 0) << scored.err;
  const json kinds = json::parse(scored.out).at("kinds");
  ASSERT_EQ(kinds.size(), 2U);
  EXPECT_EQ(kinds[0].at("of"), "corrosion");
  EXPECT_GE(kinds[0].at("ap50").at("value"), 0.85) << kinds[0];
  EXPECT_GE(kinds[1].at("ap50").at("value"), 0.8) << kinds[1];
}

TEST_F(StageCommand, RefusesInOneLine) {
  const ProgramResult unknown =
      made_->run({"stage", "pile_by_rof", "--looks", "3", "--out", made_->path("none")});
  EXPECT_NE(unknown.exit_code, 0);
  EXPECT_TRUE(contains(unknown.err, "pile_by_small_camera")) << unknown.err;
  EXPECT_FALSE(std::filesystem::exists(made_->path("none")));
  const ProgramResult alone = made_->run({"detect", made_->path("looks/look_000000.png"), "--by",
                                          "corrosion_by_colour", "--pod", made_->path("none")});
  EXPECT_NE(alone.exit_code, 0);
  EXPECT_TRUE(contains(alone.err, "--score")) << alone.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_stage_test
