// A network whose answer is known: it says how red each cell of a picture is.
#include "api/perception/network.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/api/perception/onnx_for_tests.h"
#include "tests/api/perception/plates_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/store_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::network_test {
namespace {

using api::PixelBox;
using twin::Picture;

/// 10 (red - blue) - 5 is the logit of rust, with red and blue from 0 to 1; boxes reach one stride
/// to the left and above, two to the right and below.
MeansOfCells redness() {
  MeansOfCells network;
  network.weight = {{10, 0, -10}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  network.bias = {-5, 0, 0, std::log(2.F), std::log(2.F)};
  return network;
}

/// The mean of a plane of the test's picture in its cell (0, 0), by the formula of network.h.
double mean_of_proof(int plane, int seed, int wide, int side) {
  double sum = 0;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const auto k = static_cast<std::uint32_t>(3 * (row * wide + column) + plane);
      sum += (2654435761U * (k + 1) + 40503U * static_cast<std::uint32_t>(seed)) >> 24U;
    }
  }
  return sum / (side * side) / 255;
}

class NetworkDetector : public testing::Test {
 protected:
  /// A model file beside its network. @param is  what it says must come of the test's picture
  Config model(const MeansOfCells& network, const std::string& more, const std::string& is = {},
               int proof_px = 32) const {
    const std::string onnx = onnx_of(network);
    write_bytes(folder_ / "net.onnx", onnx);
    const double red = mean_of_proof(0, 7, proof_px, network.stride_px),
                 blue = mean_of_proof(2, 7, proof_px, network.stride_px);
    const std::string value = is.empty() ? formatted("{}", 10 * (red - blue) - 5) : is;
    return Config::parse(
        formatted("file: net.onnx\nsha256: {}\nkinds: [rust]\ninput: {{mean: [0, 0, 0], sd: [1, 1, "
                  "1], {}\ntest: {{seed: 7, wide: {}, high: {}, heads: [{{output: head, at: [0], "
                  "is: [{}]}}]}}\n",
                  sha256_of_text(onnx), more, proof_px, proof_px, value),
        "model.yaml");
  }
  std::unique_ptr<api::Detector> detector(const MeansOfCells& network,
                                          const std::string& more = any_size) const {
    return api::read_network(model(network, more), folder_.path());
  }
  std::string refusal(const Config& config) const {
    try {
      (void)api::read_network(config, folder_.path());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      return error.message();
    }
    return {};
  }

  static constexpr const char* any_size =
      "multiple_of: 8}\ngrids: [{output: head, stride_px: 8}]\nmost_overlap: 1";
  TemporaryFolder folder_;
};

TEST_F(NetworkDetector, SaysTheBoxAndTheConfidenceOfTheFormula) {
  Picture picture = plate(64, 40, {0, 0, 0});
  paint(picture, 16, 8, 24, 16, {204, 0, 51});  // red 0.8, blue 0.2: a logit of 1
  const auto found = detector(redness())->find(picture);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].of, "rust");
  EXPECT_NEAR(found[0].confidence, 1 / (1 + std::exp(-1.0)), 1e-6);
  EXPECT_NEAR(found[0].box.left, 20 - 8, 1e-4);
  EXPECT_NEAR(found[0].box.top, 12 - 8, 1e-4);
  EXPECT_NEAR(found[0].box.right, 20 + 16, 1e-4);
  EXPECT_NEAR(found[0].box.bottom, 12 + 16, 1e-4);
}

TEST_F(NetworkDetector, FillsUpASizeThatIsNoMultipleAndCutsBoxesAtThePicture) {
  Picture picture = plate(61, 37, {255, 0, 0});
  const auto found = detector(redness())->find(picture);
  ASSERT_EQ(found.size(), 8U * 5U);
  for (const auto& one : found) {
    EXPECT_GE(one.box.left, 0);
    EXPECT_LE(one.box.right, 61);
    EXPECT_LE(one.box.bottom, 37);
  }
}

TEST_F(NetworkDetector, FitsAPictureIntoAFixedSizeAndItsBoxesBack) {
  Picture picture = plate(256, 128, {0, 0, 0});
  paint(picture, 64, 32, 96, 64, {255, 0, 0});  // a cell of 8 x 8 when it is fitted into 64 x 64
  const Config fixed =
      model(redness(), "wide: 64, high: 64}\ngrids: [{output: head, stride_px: 8}]", {}, 64);
  const auto found = api::read_network(fixed, folder_.path())->find(picture);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].box.left, 4 * (20 - 8), 1e-3);
  EXPECT_NEAR(found[0].box.bottom, 4 * (12 + 16), 1e-3);
}

// A logit of -2 is a confidence of 0.12, less than the file's 0.25: not told unless it is asked
// for; one of -4, 0.02, is not even then.
TEST_F(NetworkDetector, SaysWhatItIsUnsureOfWhereItIsAsked) {
  Picture picture = plate(64, 40, {0, 0, 0});
  paint(picture, 16, 8, 24, 16, {204, 0, 51});  // 10 (0.8 - 0.2) - 5 = 1
  paint(picture, 40, 8, 48, 16, {102, 0, 25});  // -1.98
  paint(picture, 40, 24, 48, 32, {51, 0, 25});  // -3.98
  const auto network = detector(redness());
  const auto told = network->find(picture), all = network->find_unsure_too(picture);
  EXPECT_EQ(network->least_confidence(), 0.25);
  ASSERT_EQ(told.size(), 1U);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].box, told[0].box);
  EXPECT_NEAR(all[1].confidence, 1 / (1 + std::exp(1.98)), 0.01);
  EXPECT_NEAR(all[1].box.left, 44 - 8, 1e-4);
}

TEST_F(NetworkDetector, IsTheSameForTheSamePicture) {
  const auto network = detector(redness());
  Picture picture = plate(64, 64, {180, 20, 40});
  const auto once = network->find(picture), twice = network->find(picture);
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].confidence, twice[i].confidence);
    EXPECT_EQ(once[i].box, twice[i].box);
  }
}

TEST_F(NetworkDetector, ThatSaysAnotherThingThanItsTestIsRefused) {
  const std::string why = refusal(model(redness(), any_size, "0.5"));
  EXPECT_TRUE(contains(why, "its test is not passed")) << why;
  EXPECT_TRUE(contains(why, "expected 0.5 within 0.0001")) << why;
}

TEST_F(NetworkDetector, OfAnotherShapeThanItsFileSaysIsRefused) {
  MeansOfCells four = redness();
  four.weight.pop_back();
  four.bias.pop_back();
  const auto network = detector(four);  // its test asks for one number alone
  try {
    (void)network->find(plate(64, 64));
    FAIL() << "it was read";
  } catch (const Error& error) {
    EXPECT_TRUE(contains(error.message(), "found 1 x 4 x 8 x 8 in the output head, expected 1 x 5"))
        << error.message();
  }
}

TEST_F(NetworkDetector, IsRefusedWhereAnythingElseIsWrong) {
  const Config good = model(redness(), any_size);
  write_bytes(folder_ / "net.onnx", "not a network");
  EXPECT_TRUE(contains(refusal(good), "sha256"));
  const std::string garbage = "not a network";
  const std::string head = "file: net.onnx\nsha256: " + sha256_of_text(garbage) +
                           "\nkinds: [rust]\ninput: {mean: [0, 0, 0], sd: [1, 1, 1], ";
  const std::string proof =
      "\ntest: {seed: 7, wide: 32, high: 32, heads: [{output: head, at: [0], is: [0]}]}\n";
  const auto why = [&](const std::string& more) {
    return refusal(Config::parse(head + more, "model.yaml"));
  };
  EXPECT_TRUE(contains(why(any_size + proof), "OpenCV"));
  EXPECT_TRUE(contains(why(any_size), "test"));
  EXPECT_TRUE(contains(why("multiple_of: 8}" + proof), "grids"));
  EXPECT_TRUE(contains(why("multiple_of: 8}\ngrids: [{output: head, stride_px: 16}]" + proof),
                       "does not divide"));
  EXPECT_TRUE(contains(
      why("multiple_of: 8, wide: 64, high: 64}\ngrids: [{output: head, stride_px: 8}]" + proof),
      "either a size or a multiple"));
}

}  // namespace
}  // namespace slackwater::tests::network_test
