#include "api/door/cli/see/rendered_files.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "api/show/render/view_file.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_frames = 100000;

/// SENSOR_000012.500: in the order of time.
std::string name_at(const std::string& sensor, double t_s) {
  return formatted("{}_{:010.3f}", sensor, t_s);
}

nlohmann::json frame_json(const RenderView& view, const std::string& name) {
  nlohmann::json out = {
      {"t_s", view.t_s},
      {"time", format_utc(view.time)},
      {"netcdf", name + ".nc"},
      {"position_enu_m",
       {view.pose.position_m.y, view.pose.position_m.x, -view.pose.position_m.z}}};
  if (!Waterfall::has_line(view)) out["png"] = name + ".png";
  const auto* camera = std::get_if<CameraView>(&view.seen);
  const auto* infrared = std::get_if<InfraredView>(&view.seen);
  if (camera == nullptr && infrared == nullptr) return out;
  if (camera != nullptr && camera->right) out["right_png"] = name + "_right.png";
  const twin::TruthFrame& truth = camera != nullptr ? camera->truth : infrared->truth;
  std::map<std::string, std::size_t> classes;
  for (const twin::SeenClass seen : truth.seen_class) ++classes[twin::name_of(seen)];
  out["pixels"] = classes;
  out["defects"] = nlohmann::json::array();
  for (const SeenDefect& defect : view.defects)
    if (defect.pixels > 0)
      out["defects"].push_back({{"number", defect.number},
                                {"kind", twin::name_of(defect.kind)},
                                {"surface", defect.surface},
                                {"size_m", defect.size_m},
                                {"pixels", defect.pixels}});
  return out;
}

std::size_t defects_in(const RenderView& view) {
  return static_cast<std::size_t>(std::count_if(view.defects.begin(), view.defects.end(),
                                                [](const SeenDefect& d) { return d.pixels > 0; }));
}

std::string waterfall_name(const std::string& sensor) { return sensor + "_waterfall.png"; }

}  // namespace

RenderedFiles::RenderedFiles(const RenderedRun& run, std::string sensor,
                             std::filesystem::path folder)
    : run_(run), sensor_(std::move(sensor)), folder_(std::move(folder)) {
  std::error_code problem;
  std::filesystem::create_directories(folder_, problem);
  if (problem)
    throw Error(ErrorKind::unavailable,
                "--out: cannot make the folder " + folder_.string() + ": " + problem.message());
}

void RenderedFiles::add(const RenderView& view) {
  const std::string name = name_at(sensor_, view.t_s);
  write_view_netcdf(view, run_, folder_ / (name + ".nc"));
  if (Waterfall::has_line(view))
    waterfall_.add(view);
  else
    write_view_png(view, folder_ / (name + ".png"));
  (void)write_right_png(view, folder_ / (name + "_right.png"));
  labels_.add(view, name + ".png");
  with_defects_ += defects_in(view) > 0 ? 1 : 0;
  frames_.push_back(frame_json(view, name));
}

void RenderedFiles::finish() {
  if (!labels_.coco().at("images").empty())
    write_text(folder_ / (sensor_ + "_labels.json"), labels_.coco().dump() + "\n");
  if (!waterfall_.is_empty()) waterfall_.write(folder_ / waterfall_name(sensor_));
}

nlohmann::json RenderedFiles::json() const {
  nlohmann::json out = {{"sensor", sensor_},
                        {"vehicle", run_.vehicle()},
                        {"folder", folder_.string()},
                        {"warnings", run_.warnings()},
                        {"frames", frames_}};
  if (!waterfall_.is_empty()) out["waterfall"] = waterfall_name(sensor_);
  return out;
}

std::string RenderedFiles::words() const {
  const std::string of = run_.sensor().name + " of " + run_.vehicle() + ": ";
  if (!waterfall_.is_empty())
    return of + formatted("{} in {}, a .nc each, and {}\n", counted(frames_.size(), "ping"),
                          folder_.string(), waterfall_name(sensor_));
  std::string out = of + formatted("{} in {}, a .png and a .nc each",
                                   counted(frames_.size(), "picture"), folder_.string());
  if (with_defects_ > 0) out += formatted("; planted defects in {} of them", with_defects_);
  return out + "\n";
}

std::vector<double> moments_each(double step_s, const RenderedRun& run, const std::string& option) {
  const double frames = std::floor((run.to_s() - run.from_s()) / step_s + 1e-9) + 1;
  if (frames > static_cast<double>(most_frames))
    throw Error(ErrorKind::usage, formatted("{}: makes {:.0f} pictures, expected {} at most; "
                                            "take a longer step",
                                            option, frames, most_frames));
  std::vector<double> times_s;
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i)
    times_s.push_back(std::min(run.from_s() + static_cast<double>(i) * step_s, run.to_s()));
  return times_s;
}

}  // namespace slackwater::api
