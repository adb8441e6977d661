#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/perception/detection.h"

namespace slackwater::api {

/// What somebody says is in a picture.
struct Label {
  std::string of;
  PixelBox box;
  bool is_crowd = false;  ///< a heap that was not counted: found or not, it does not matter
  std::optional<std::size_t> planted;  ///< of the look's, by its place: of pictures of a stage
};

/// A defect that was planted before a look at a stage, seen or not.
struct PlantedInLook {
  std::string of;
  double size_m = 0;
  double detail_m = 0;  ///< infinite: the inspection would say that it is not seen
  double ground_sampling_m = 0;
  double u = 0;  ///< of its centre, pixels
  double v = 0;
};

/// How a picture of a stage came about (`slackwater stage`): none of COCO's.
struct LookFacts {
  double range_m = 0;
  double visibility_m = 0;
  double seen_m2 = 0;  ///< surface in view
  std::vector<PlantedInLook> planted;
};

struct LabelledPicture {
  std::int64_t id = 0;
  std::filesystem::path file;
  int wide = 0;
  int high = 0;
  std::vector<Label> labels;
  std::optional<LookFacts> look;
};

/// A data set as COCO has it (cocodataset.org, format of "instances"): pictures in their order.
struct LabelledPictures {
  std::vector<LabelledPicture> pictures;
  std::map<std::string, std::int64_t> categories;  ///< name: id
};

/// The set of a folder: its one JSON file, or that of `annotations/`; pictures are beside it, or in
/// `images/`, by their `file_name`. Of an annotation are read `image_id`, `category_id`, `bbox`
/// (left, top, width, height) and `iscrowd`, of pictures of a stage `look` and
/// `planted_number`; other keys are left.
/// @param labels  of the JSON file where there are several; empty: the only one
/// @throws Error(not_found) for no file, Error(invalid_input) for what is no such set: numbers that
///         are none, an annotation of a picture or category that is not listed, two of one id, a
///         box without a size or outside of its picture, a name that leads out of the folder
[[nodiscard]] LabelledPictures read_labelled_pictures(const std::filesystem::path& folder,
                                                      const std::filesystem::path& labels = {});

}  // namespace slackwater::api
