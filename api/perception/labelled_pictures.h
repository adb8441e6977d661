#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "api/perception/detection.h"

namespace slackwater::api {

/// What somebody says is in a picture.
struct Label {
  std::string of;
  PixelBox box;
  bool is_crowd = false;  ///< a heap that was not counted: found or not, it does not matter
};

struct LabelledPicture {
  std::int64_t id = 0;
  std::filesystem::path file;
  int wide = 0;
  int high = 0;
  std::vector<Label> labels;
};

/// A data set as COCO has it (cocodataset.org, format of "instances"): pictures in their order.
struct LabelledPictures {
  std::vector<LabelledPicture> pictures;
  std::map<std::string, std::int64_t> categories;  ///< name: id
};

/// The set of a folder: its one JSON file, or that of `annotations/`; pictures are beside it, or in
/// `images/`, by their `file_name`. Of an annotation are read `image_id`, `category_id`, `bbox`
/// (left, top, width, height) and `iscrowd`; other keys are left.
/// @param labels  of the JSON file where there are several; empty: the only one
/// @throws Error(not_found) for no file, Error(invalid_input) for what is no such set: numbers that
///         are none, an annotation of a picture or category that is not listed, two of one id, a
///         box without a size or outside of its picture, a name that leads out of the folder
[[nodiscard]] LabelledPictures read_labelled_pictures(const std::filesystem::path& folder,
                                                      const std::filesystem::path& labels = {});

}  // namespace slackwater::api
