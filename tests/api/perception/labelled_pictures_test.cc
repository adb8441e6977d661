#include "api/perception/labelled_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::labelled_pictures_test {
namespace {

const std::string images =
    R"("images": [{"id": 3, "file_name": "a.png", "width": 64, "height": 48},
                  {"id": 9, "file_name": "b.png", "width": 32, "height": 32}])";
const std::string categories =
    R"("categories": [{"id": 1, "name": "corrosion"}, {"id": 7, "name": "crack"}])";

std::string set_with(const std::string& annotations) {
  return "{" + images + ", " + categories + R"(, "annotations": [)" + annotations + "]}";
}

class ReadLabelledPictures : public testing::Test {
 protected:
  api::LabelledPictures read(const std::string& json) const {
    std::ofstream(folder_ / "labels.json") << json;
    return api::read_labelled_pictures(folder_.path());
  }
  std::string refusal(const std::string& json) const {
    try {
      (void)read(json);
    } catch (const Error& error) {
      return error.message();
    }
    return {};
  }
  TemporaryFolder folder_;
};

TEST_F(ReadLabelledPictures, GivesEachPictureItsLabels) {
  const auto set = read(set_with(
      R"({"image_id": 9, "category_id": 7, "bbox": [1, 2, 10, 20.5], "iscrowd": 0, "area": 3},
         {"image_id": 9, "category_id": 1, "bbox": [0, 0, 5, 5], "iscrowd": 1})"));
  ASSERT_EQ(set.pictures.size(), 2U);
  EXPECT_TRUE(set.pictures[0].labels.empty());
  EXPECT_EQ(set.pictures[0].id, 3);
  EXPECT_EQ(set.categories.at("crack"), 7);
  const auto& labels = set.pictures[1].labels;
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].of, "crack");
  EXPECT_EQ(labels[0].box, (api::PixelBox{1, 2, 11, 22.5}));
  EXPECT_FALSE(labels[0].is_crowd);
  EXPECT_TRUE(labels[1].is_crowd);
}

TEST_F(ReadLabelledPictures, LooksInImagesAndAnnotationsToo) {
  std::filesystem::create_directories(folder_ / "annotations");
  std::filesystem::create_directories(folder_ / "images");
  std::ofstream(folder_ / "images" / "a.png") << "a";
  std::ofstream(folder_ / "annotations" / "instances.json") << set_with("");
  const auto set = api::read_labelled_pictures(folder_.path());
  EXPECT_EQ(set.pictures[0].file, folder_.path() / "images" / "a.png");
  EXPECT_EQ(set.pictures[1].file, folder_.path() / "b.png");
}

TEST_F(ReadLabelledPictures, RefusesWhatIsNoSuchSetAndSaysWhere) {
  const auto says = [&](const std::string& json, const std::string& words) {
    const std::string why = refusal(json);
    EXPECT_TRUE(contains(why, words)) << why;
    EXPECT_TRUE(contains(why, "labels.json")) << why;
  };
  says("[]", "no JSON object");
  says("{", "no JSON object");
  says("{}", "found no list categories");
  says("{" + categories + "}", "found no list images");
  says(R"({"categories": [], "images": [], "annotations": []})", "found no pictures");
  const auto annotation = [&](const std::string& keys) {
    return set_with(R"({"image_id": 3, "category_id": 1, )" + keys + "}");
  };
  says(set_with(R"({"image_id": 4, "category_id": 1, "bbox": [1, 2, 3, 4]})"), "not listed");
  says(set_with(R"({"image_id": 3, "category_id": 2, "bbox": [1, 2, 3, 4]})"), "not listed");
  says(set_with(R"({"category_id": 1, "bbox": [1, 2, 3, 4]})"), "no whole number image_id");
  says(set_with("7"), "annotations, number 1");
  says(annotation(R"("bbox": [1, 2, 3])"), "found no bbox");
  says(annotation(R"("bbox": [1, 2, "3", 4])"), "found no bbox");
  says(annotation(R"("bbox": [1, 2, 0, 4])"), "found the bbox 1, 2, 0 wide");
  says(annotation(R"("bbox": [60, 2, 6, 4])"), "in its picture of 64 x 48");
  says(annotation(R"("bbox": [1, 2, 1e999, 4])"), "no JSON object");
  says(annotation(R"("bbox": [1, 2, 3, 4], "iscrowd": "no")"), "iscrowd");
  says(R"({"categories": [{"id": 1, "name": "a"}, {"id": 1, "name": "b"}]})", "a second time");
  for (const std::string name : {"../a.png", "/etc/passwd", "x/../../a.png"})
    says("{" + categories + R"(, "images": [{"id": 1, "file_name": ")" + name +
             R"(", "width": 1, "height": 1}], "annotations": []})",
         "below the folder of the set");
  std::ofstream(folder_ / "other.json") << "{}";
  EXPECT_TRUE(contains(refusal(set_with("")), "found 2 JSON files"));
}

/// One picture of a stage, whose look planted one defect; `planted` and `number` as they are.
std::string look_with(const std::string& planted, const std::string& number,
                      const std::string& seen_m2 = "0.5") {
  return R"({"images": [{"id": 3, "file_name": "a.png", "width": 64, "height": 48, "look": )"
         R"({"range_m": 1.5, "visibility_m": 6, "seen_m2": )" +
         seen_m2 + R"(, "planted": [)" + planted + "]}}], " + categories +
         R"(, "annotations": [{"image_id": 3, "category_id": 1, "bbox": [1, 2, 3, 4], )" +
         R"("planted_number": )" + number + "}]}";
}
std::string planted_with(const std::string& size_m, const std::string& detail_m,
                         const std::string& centre_px = "[12.5, 20]") {
  return R"({"kind": "corrosion", "ground_sampling_m": 0.002, "size_m": )" + size_m +
         R"(, "detail_m": )" + detail_m + R"(, "centre_px": )" + centre_px + "}";
}

TEST_F(ReadLabelledPictures, KnowsWhatALookAtAStagePlanted) {
  const auto set = read(look_with(planted_with("0.1", "null"), "0"));
  ASSERT_TRUE(set.pictures.at(0).look.has_value());
  const api::LookFacts& look = *set.pictures[0].look;
  EXPECT_EQ(look.range_m, 1.5);
  EXPECT_EQ(look.visibility_m, 6);
  ASSERT_EQ(look.planted.size(), 1U);
  EXPECT_EQ(look.planted[0].of, "corrosion");
  EXPECT_EQ(look.planted[0].u, 12.5);
  EXPECT_TRUE(std::isinf(look.planted[0].detail_m)) << "null: not seen";
  EXPECT_EQ(set.pictures[0].labels.at(0).planted, 0U);
}

TEST_F(ReadLabelledPictures, RefusesLooksThatCannotBe) {
  const auto says = [&](const std::string& json, const std::string& words) {
    const std::string why = refusal(json);
    EXPECT_TRUE(contains(why, words)) << why;
  };
  const std::string one = planted_with("0.1", "0.003");
  says(look_with(one, "1"), "planted_number 1, but the look planted 1");
  says(look_with(one, "-1"), "planted_number -1");
  says(look_with(one, R"("0")"), "no whole number planted_number");
  says(look_with(one, "0", "-1"), "seen_m2 -1, expected 0 or more");
  says(look_with(planted_with("0", "0.003"), "0"), "size_m 0, expected more than 0");
  says(look_with(planted_with("0.1", "0"), "0"), "detail_m 0, expected more than 0");
  says(look_with(planted_with("0.1", R"("fine")"), "0"), "no number detail_m");
  says(look_with(planted_with("0.1", "0.003", "[1]"), "0"), "expected [u, v] in pixels");
}

}  // namespace
}  // namespace slackwater::tests::labelled_pictures_test
