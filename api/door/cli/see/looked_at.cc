#include "api/door/cli/see/looked_at.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/ask/detect/detector_record.h"
#include "api/show/rehearse/detections_report.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "ingest/apart/read_tracks_apart.h"

namespace slackwater::api {
namespace {

std::unique_ptr<Detector> detector_for(const std::string& by, const RenderedRun& run) {
  if (!run.sensor().is_camera())
    throw Error(ErrorKind::usage, "--by: found the sensor " + run.sensor().name +
                                      ", expected a camera: detectors read its pictures");
  return load_detector(by);
}

}  // namespace

LookedAt::LookedAt(const std::string& by, const RenderedRun& run, const std::string& sensor,
                   bool keeps_pictures)
    : detector_(detector_for(by, run)),
      finds_(detector_->kinds()),
      who_{std::filesystem::path(by).stem().string(), sensor, run.vehicle(), run.origin()},
      title_(run.title()),
      keeps_pictures_(keeps_pictures) {}

std::vector<Detection> LookedAt::add(const RenderView& view) {
  const twin::Picture& picture = std::get<CameraView>(view.seen).picture;
  std::vector<Detection> found = detector_->find(picture);
  finds_.add(view, found);
  if (keeps_pictures_) thumbnails_.push_back(thumbnail_of(picture));
  return found;
}

void LookedAt::record_in(const std::filesystem::path& log) const {
  ingest::TrajectoryFile file = ingest::read_tracks_apart(log);
  const auto ours = std::find(file.names.begin(), file.names.end(), who_.vehicle);
  expects(ours != file.names.end(), "the log that the pictures are of");
  const auto vehicle = static_cast<std::size_t>(ours - file.names.begin());
  with_context(log.string(), [&] {
    add_detections(detector_record(finds_, vehicle, who_.sensor, who_.detector), file);
  });
  write_beside(log, [&](const std::filesystem::path& partial) {
    ingest::write_trajectories(file, partial);
  });
}

std::string LookedAt::words() const {
  std::string out =
      formatted("{}: {}\n", who_.detector, counted(finds_.findings().size(), "finding"));
  for (const KindFound& kind : finds_.score())
    out += formatted("  {:12} {} of {} planted in view found, {}\n", kind.of, kind.found,
                     kind.in_view, counted(kind.false_alarms, "false alarm"));
  return out;
}

nlohmann::json LookedAt::json() const {
  using Json = nlohmann::json;
  Json out = {{"by", who_.detector},
              {"kinds", kinds_found_json(finds_.score())},
              {"findings", Json::array()}};
  for (const RunFinding& one : finds_.findings())
    out["findings"].push_back({{"of", one.of},
                               {"surface", one.surface},
                               {"position_enu_m", {one.place_m.y, one.place_m.x, -one.place_m.z}},
                               {"size_m", one.size_m},
                               {"range_m", one.range_m},
                               {"confidence", one.confidence},
                               {"time", format_utc(one.time)},
                               {"pictures", one.pictures},
                               {"defect", one.defect ? Json(*one.defect) : Json(nullptr)}});
  return out;
}

std::string LookedAt::page() const { return seen_page(finds_, thumbnails_, who_, title_); }
std::string LookedAt::geojson(bool shows_truth) const {
  return found_geojson(finds_, who_, shows_truth);
}

}  // namespace slackwater::api
