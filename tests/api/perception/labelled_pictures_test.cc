#include "api/perception/labelled_pictures.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace slackwater::tests::labelled_pictures_test
