#include "api/perception/score_detector.h"

#include <algorithm>
#include <utility>

#include "api/perception/read_picture.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

bool is_among(const std::string& kind, const std::vector<std::string>& kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

twin::Picture read_as_labelled(const LabelledPicture& labelled) {
  twin::Picture picture = read_picture(labelled.file);
  if (picture.wide != labelled.wide || picture.high != labelled.high)
    refuse(formatted(
        "found {} x {} pixels in {}, but its labels are of {} x {}: the labels are of "
        "another picture, or it was scaled",
        picture.wide, picture.high, labelled.file.string(), labelled.wide, labelled.high));
  return picture;
}

}  // namespace

DetectorScore score_detector(Detector& detector, const LabelledPictures& set,
                             const std::function<void(std::size_t)>& on_picture) {
  DetectorScore score;
  std::vector<std::string> labelled, both;
  for (const auto& [name, id] : set.categories) {
    labelled.push_back(name);
    if (!is_among(name, detector.kinds())) score.only_labels.push_back(name);
  }
  for (const std::string& kind : detector.kinds())
    (is_among(kind, labelled) ? both : score.only_finds).push_back(kind);
  if (both.empty())
    refuse("found labels of " + joined(labelled, ", ") + ", but the detector finds " +
           joined(detector.kinds(), ", ") + ": expected at least one kind of the same name");
  for (const LabelledPicture& one : set.pictures) {
    ScoredPicture picture{one.labels, detector.find_unsure_too(read_as_labelled(one)), {}};
    const auto told = std::stable_partition(
        picture.found.begin(), picture.found.end(),
        [&](const Detection& find) { return find.confidence >= detector.least_confidence(); });
    picture.unsure.assign(told, picture.found.end());
    picture.found.erase(told, picture.found.end());
    score.pictures.push_back(std::move(picture));
    if (on_picture) on_picture(score.pictures.size());
  }
  for (const std::string& kind : both) score.kinds.push_back(score_of_kind(score.pictures, kind));
  return score;
}

}  // namespace slackwater::api
