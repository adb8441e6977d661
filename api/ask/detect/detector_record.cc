#include "api/ask/detect/detector_record.h"

namespace slackwater::api {

DetectorRecord detector_record(const RunFinds& finds, std::size_t vehicle,
                               const std::string& sensor, const std::string& detector) {
  DetectorRecord record{vehicle, sensor, detector, finds.pictures().size(), finds.score(), {}};
  for (const DetectedPicture& picture : finds.pictures())
    for (const PlacedFind& placed : picture.finds) {
      const PixelBox& box = placed.find.box;
      record.finds.push_back({placed.find.of, placed.surface, picture.t_s, placed.find.confidence,
                              box.left, box.top, box.right - box.left, box.bottom - box.top,
                              placed.place_m, placed.range_m, placed.size_m, placed.finding,
                              placed.defect});
    }
  return record;
}

}  // namespace slackwater::api
