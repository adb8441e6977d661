// `slackwater detect`: what is found in pictures, how well, and all that can be wrong with them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/base/encode/sha256.h"
#include "tests/api/perception/plates_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/refusal.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_detect_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

class DetectCommand : public testing::Test {
 protected:
  DetectCommand() {
    twin::Picture rusty = plate(120, 80);
    paint(rusty, 30, 20, 50, 60, rust);
    write_png(made_.file("rusty.png"), rusty);
    write_png(made_.file("clean.png"), plate(120, 80));
  }
  ProgramResult run(Arguments arguments) const {
    arguments.insert(arguments.begin(), "detect");
    return made_.run(arguments);
  }
  /// A set of both, with the rust labelled.
  void label(const std::string& bbox, int wide = 120) const {
    made_.write("labels.json",
                R"({"categories": [{"id": 4, "name": "corrosion"}, {"id": 5, "name": "anode"}],
                    "images": [{"id": 1, "file_name": "rusty.png", "width": )" +
                    std::to_string(wide) +
                    R"(, "height": 80}, {"id": 2, "file_name": "clean.png", "width": 120,
                       "height": 80}],
                    "annotations": [{"image_id": 1, "category_id": 4, "bbox": )" +
                    bbox + "}]}");
  }
  std::string folder() const { return made_.file("").string(); }

  StoreForTests made_;
};

TEST_F(DetectCommand, SaysWhatIsInEachPicture) {
  const ProgramResult told = run(
      {made_.path("rusty.png"), made_.path("clean.png"), "--by", "corrosion_by_colour", "--json"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  const json pictures = json::parse(told.out).at("pictures");
  ASSERT_EQ(pictures.size(), 2U);
  ASSERT_EQ(pictures[0].at("found").size(), 1U);
  EXPECT_EQ(pictures[0].at("found")[0].at("bbox"), json({30.0, 20.0, 20.0, 40.0}));
  EXPECT_TRUE(pictures[1].at("found").empty());
  const ProgramResult words =
      run({made_.path("rusty.png"), made_.path("clean.png"), "--by", "corrosion_by_colour"});
  EXPECT_TRUE(contains(words.out, "clean.png: nothing found")) << words.out;
  EXPECT_TRUE(contains(words.out, "rusty.png: 1 find\n")) << words.out;
}

TEST_F(DetectCommand, ScoresAFolderAndSaysWhatItCannot) {
  label("[30, 20, 20, 40]");
  const ProgramResult told =
      run({"--score", folder(), "--by", "corrosion_by_colour", "--json", "--out",
           made_.path("results.json"), "--labels", made_.path("labels.json")});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  const json score = json::parse(told.out);
  EXPECT_EQ(score.at("pictures"), 2);
  EXPECT_EQ(score.at("not_looked_for"), json({"anode"}));
  const json& kind = score.at("kinds").at(0);
  EXPECT_EQ(kind.at("labels"), 1);
  EXPECT_EQ(kind.at("ap50").at("value"), 1.0);
  EXPECT_EQ(kind.at("false_alarms_per_100_empty_pictures"), 0.0);
  const json results = json::parse(read_bytes(made_.file("results.json")));
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].at("image_id"), 1);
  EXPECT_EQ(results[0].at("category_id"), 4);
  label("[90, 20, 20, 40]");  // somewhere else
  const ProgramResult wrong = run(
      {"--score", folder(), "--by", "corrosion_by_colour", "--labels", made_.path("labels.json")});
  EXPECT_TRUE(contains(wrong.out, "0.000 (0.000 to 0.000)")) << wrong.out;
  EXPECT_TRUE(contains(wrong.out, "Not looked for: anode")) << wrong.out;
}

// OpenCV has words and prints of its own for these, on several lines.
TEST_F(DetectCommand, ANetworkThatCannotBeReadIsOneLineToo) {
  for (const std::string& onnx : {std::string("not a network"),
                                  std::string("\x08\x07\x3a\x05"
                                              "ab",
                                              6),
                                  std::string(3000, '\xff')}) {
    write_bytes(made_.file("net.onnx"), onnx);
    const std::string file = made_.write(
        "net.yaml",
        "name: n\nsource: s\nby: network\nfile: net.onnx\nsha256: " + sha256_of_text(onnx) +
            "\nkinds: [a]\ninput: {mean: [0, 0, 0], sd: [1, 1, 1], multiple_of: 8}\n"
            "grids: [{output: head, stride_px: 8}]\n"
            "test: {seed: 7, wide: 32, high: 32, heads: [{output: head, at: [0], is: "
            "[0]}]}\n");
    expect_refusal(run({made_.path("rusty.png"), "--by", file}), 3, {"net.yaml", "OpenCV"});
  }
}

TEST_F(DetectCommand, IsRefusedInOneClearSentence) {
  label("[30, 20, 20, 40]", 121);
  const Arguments by{"--by", "corrosion_by_colour"};
  const auto with = [&](Arguments more) {
    more.insert(more.end(), by.begin(), by.end());
    return run(more);
  };
  expect_refusal(with({"--score", folder(), "--labels", made_.path("labels.json")}), 3,
                 {"120 x 80 pixels", "its labels are of 121 x 80"});
  expect_refusal(with({}), 2, {"found neither pictures nor --score", "expected one of them"});
  expect_refusal(with({made_.path("rusty.png"), "--out", "a.json"}), 2, {"--score"});
  expect_refusal(with({made_.path("none.png")}), 4, {"found no file"});
  expect_refusal(run({made_.path("rusty.png"), "--by", "corosion_by_colour"}), 4,
                 {"corrosion_by_colour", "did you mean"});
  expect_refusal(run({"--score", folder(), "--labels", made_.path("labels.json"), "--by",
                      "crack_by_percolation"}),
                 3, {"anode, corrosion", "finds crack"});
}

}  // namespace
}  // namespace slackwater::tests::cli_detect_test
