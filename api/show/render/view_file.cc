#include "api/show/render/view_file.h"

#include <algorithm>
#include <cmath>

#include "api/program/version.h"
#include "api/show/render/png_file.h"
#include "api/show/render/sound_file.h"
#include "api/show/render/view_variables.h"
#include "api/show/render/waterfall.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "ingest/netcdf/file.h"
#include "twin/inspection/defect/defect_kind.h"
#include "twin/render/light/heat_tones.h"

namespace slackwater::api {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

// -- pictures

void write_png_of(const CameraView& seen, const RenderView& /*view*/,
                  const std::filesystem::path& file) {
  write_png(file, seen.picture.wide, seen.picture.high, 3, seen.picture.rgb);
}

void write_png_of(const InfraredView& seen, const RenderView& /*view*/,
                  const std::filesystem::path& file) {
  write_png(file, seen.heat.wide, seen.heat.high, 1, twin::heat_tones(seen.heat));
}

void write_png_of(const twin::LidarScan& scan, const RenderView& /*view*/,
                  const std::filesystem::path& file) {
  float farthest_m = 1;
  for (const float range_m : scan.range_m)
    if (range_m > farthest_m) farthest_m = range_m;
  std::vector<std::uint8_t> grey(scan.range_m.size(), 0);
  const auto columns = static_cast<std::size_t>(scan.columns);
  for (std::size_t i = 0; i < grey.size(); ++i) {
    const float range_m = scan.range_m[i];
    if (!std::isfinite(range_m)) continue;
    const std::size_t row = static_cast<std::size_t>(scan.channels) - 1 - i / columns;
    // The axis in the middle of the picture.
    const std::size_t column = (i % columns + columns / 2) % columns;
    grey[row * columns + column] =
        static_cast<std::uint8_t>(255 - 215 * std::sqrt(range_m / farthest_m));
  }
  write_png(file, scan.columns, scan.channels, 1, grey);
}

void write_png_of(const twin::SonarImage& image, const RenderView& /*view*/,
                  const std::filesystem::path& file) {
  constexpr double shown_db = 60;
  // Echoes as they would be without spreading, so that far ones show: times r^2.
  const auto bins = static_cast<std::size_t>(image.bins);
  const auto levelled = [&](std::size_t i) {
    const double r = static_cast<double>(i % bins) + 0.5;
    return static_cast<double>(image.intensity[i]) * r * r;
  };
  double most = 0;
  for (std::size_t i = 0; i < image.intensity.size(); ++i) most = std::max(most, levelled(i));
  std::vector<std::uint8_t> grey(image.intensity.size(), 0);
  for (std::size_t i = 0; i < grey.size() && most > 0; ++i) {
    const double db = 10 * std::log10(std::max(levelled(i) / most, 1e-30));
    const std::size_t row = bins - 1 - i % bins, column = i / bins;
    grey[row * static_cast<std::size_t>(image.beams) + column] =
        static_cast<std::uint8_t>(255 * std::clamp(1 + db / shown_db, 0.0, 1.0));
  }
  write_png(file, image.beams, image.bins, 1, grey);
}

template <typename Line>
void write_png_of(const Line& /*line*/, const RenderView& view, const std::filesystem::path& file) {
  Waterfall alone;
  alone.add(view);
  alone.write(file);
}

// -- truth

void say_pose(Writer& writer, const RenderView& view, const RenderedRun& run) {
  const int of = Writer::global;
  writer.attribute(of, "Conventions", "CF-1.8");
  writer.attribute(of, "title", run.title() + ": " + run.sensor().name + " on " + run.vehicle());
  writer.attribute(of, "source", "slackwater " + code_version());
  writer.attribute(of, "sensor", run.sensor().name);
  writer.attribute(of, "sensor_source", run.sensor().source + " (" + run.sensor().status + ")");
  writer.attribute(of, "vehicle", run.vehicle());
  writer.attribute(of, "time", format_utc(view.time));
  writer.attribute(of, "seconds_since_start", view.t_s);
  writer.attribute(of, "origin",
                   formatted("{:.7f} N, {:.7f} E", run.origin().latitude.degrees(),
                             run.origin().longitude.degrees()));
  writer.attribute(of, "frame", "x east, y north, z up of the origin at mean sea level, m");
  writer.attribute(of, "sensor_position", enu_of(view.pose.position_m), Type::float64);
  writer.attribute(of, "sensor_right", enu_of(view.pose.right), Type::float64);
  writer.attribute(of, "sensor_down", enu_of(cross(view.pose.axis, view.pose.right)),
                   Type::float64);
  writer.attribute(of, "sensor_axis", enu_of(view.pose.axis), Type::float64);
}

void say_classes(Writer& writer, int variable) {
  std::vector<std::string> meanings;
  std::vector<double> values;
  for (std::size_t i = 0; i < twin::seen_classes; ++i) {
    meanings.emplace_back(twin::name_of(static_cast<twin::SeenClass>(i)));
    values.push_back(static_cast<double>(i));
  }
  writer.attribute(variable, "flag_values", values, Type::uint8);
  writer.attribute(variable, "flag_meanings", joined(meanings, " "));
}

/// The planted defects of the scene, one after the other: what the numbers of `defect` stand for.
class DefectList {
 public:
  DefectList(Writer& writer, const RenderView& view) : writer_(writer) {
    if (view.defects.empty()) return;
    dimensions_ = {writer.dimension("planted", view.defects.size())};
    const auto of = [&](auto value) {
      std::vector<double> values;
      for (const SeenDefect& one : view.defects) values.push_back(static_cast<double>(value(one)));
      return values;
    };
    add("planted_number", "1", "of the defect in the run",
        of([](const SeenDefect& d) { return d.number; }));
    say_kinds(add("planted_kind", "1", "of the defect",
                  of([](const SeenDefect& d) { return static_cast<int>(d.kind); })));
    add("planted_on", "1", "instance on which it is",
        of([](const SeenDefect& d) { return d.thing; }));
    add("planted_size", "m", "longest side", of([](const SeenDefect& d) { return d.size_m; }));
    add("planted_severity", "1", "m or share, by its kind",
        of([](const SeenDefect& d) { return d.severity; }));
    add("planted_x", "m", "east of the origin",
        of([](const SeenDefect& d) { return d.centre_m.y; }));
    add("planted_y", "m", "north of the origin",
        of([](const SeenDefect& d) { return d.centre_m.x; }));
    add("planted_z", "m", "up", of([](const SeenDefect& d) { return -d.centre_m.z; }));
    add("planted_pixels", "1", "of this picture that show it",
        of([](const SeenDefect& d) { return d.pixels; }));
  }
  void write() {
    for (const auto& [id, values] : pending_) writer_.write_all(id, values);
  }

 private:
  int add(const char* name, const char* units, const char* words, std::vector<double> values) {
    const int id = writer_.variable(name, Type::float64, dimensions_);
    writer_.attribute(id, "units", units);
    writer_.attribute(id, "long_name", words);
    pending_.emplace_back(id, std::move(values));
    return id;
  }
  void say_kinds(int id) {
    std::vector<std::string> meanings;
    std::vector<double> values;
    for (const twin::DefectKind kind : twin::all_defect_kinds()) {
      meanings.emplace_back(twin::name_of(kind));
      values.push_back(static_cast<double>(kind));
    }
    writer_.attribute(id, "flag_values", values, Type::float64);
    writer_.attribute(id, "flag_meanings", joined(meanings, " "));
  }
  Writer& writer_;
  std::vector<int> dimensions_;
  std::vector<std::pair<int, std::vector<double>>> pending_;
};

std::vector<float> part_of(const std::vector<std::array<float, 3>>& all, std::size_t i) {
  std::vector<float> part;
  part.reserve(all.size());
  for (const auto& one : all) part.push_back(one[i]);
  return part;
}

/// The truth of a picture, and its camera.
void add_truth(const twin::TruthFrame& truth, const std::array<double, 9>& matrix,
               const RenderView& view, Writer& writer, ViewVariables& picture) {
  writer.attribute(Writer::global, "camera_matrix", matrix, Type::float64);
  writer.attribute(
      Writer::global, "camera_model",
      "pinhole without distortion; the upper left corner of the picture is (0, 0), the "
      "middle of its first pixel (0.5, 0.5)");
  picture.add("range", Type::float32, "m", "from the camera along the ray; NaN: nothing",
              truth.range_m);
  picture.add("depth", Type::float32, "m", "along the camera's axis; NaN: nothing", truth.depth_m);
  say_names(writer, view,
            picture.add("instance", Type::uint16, "1", "what is seen, 0: nothing", truth.instance));
  say_classes(writer,
              picture.add("seen_class", Type::uint8, "1", "what kind it is of", truth.seen_class));
  picture.add("defect", Type::uint16, "1",
              "planted defect that is seen: 1 is the first of dimension planted, 0 none",
              truth.defect);
  picture.add("normal_right", Type::float32, "1", "of the surface, towards the camera",
              part_of(truth.normal, 0));
  picture.add("normal_down", Type::float32, "1", "of the surface, towards the camera",
              part_of(truth.normal, 1));
  picture.add("normal_axis", Type::float32, "1", "of the surface, towards the camera",
              part_of(truth.normal, 2));
}

ViewVariables pixels_of(const twin::TruthFrame& truth, Writer& writer) {
  return {writer,
          {{"row", static_cast<std::size_t>(truth.high)},
           {"column", static_cast<std::size_t>(truth.wide)}}};
}

void write_seen(const CameraView& seen, const RenderView& view, Writer& writer) {
  ViewVariables picture = pixels_of(seen.truth, writer);
  add_truth(seen.truth, seen.matrix, view, writer, picture);
  writer.attribute(Writer::global, "gain", seen.picture.gain);
  if (seen.flakes > 0)
    writer.attribute(Writer::global, "marine_snow_flakes", static_cast<double>(seen.flakes));
  DefectList defects(writer, view);
  if (seen.right) {
    writer.attribute(Writer::global, "baseline", seen.right->baseline_m);
    picture.add("disparity", Type::float32, "1",
                "pixels that it lies farther left in the right picture; NaN: nothing",
                seen.right->truth.disparity);
    picture.add("in_both", Type::uint8, "1", "1 where the right camera sees the place, too",
                seen.right->truth.is_in_both);
  }
  writer.end_definitions();
  picture.write();
  defects.write();
}

void write_seen(const InfraredView& seen, const RenderView& view, Writer& writer) {
  ViewVariables picture = pixels_of(seen.truth, writer);
  add_truth(seen.truth, seen.matrix, view, writer, picture);
  picture.add("apparent_temperature", Type::float32, "K",
              "as told: of a black body that radiates so, with noise", seen.heat.apparent_k);
  picture.add("radiance", Type::float32, "W m-2 sr-1", "that comes in the band, without noise",
              seen.heat.radiance);
  picture.add("surface_temperature", Type::float32, "K", "of the place; NaN: sky",
              seen.heat.temperature_k);
  picture.add("emissivity", Type::float32, "1", "of the place; NaN: sky", seen.heat.emissivity);
  DefectList defects(writer, view);
  writer.end_definitions();
  picture.write();
  defects.write();
}

void write_seen(const twin::LidarScan& scan, const RenderView& view, Writer& writer) {
  ViewVariables picture(writer, {{"channel", static_cast<std::size_t>(scan.channels)},
                                 {"column", static_cast<std::size_t>(scan.columns)}});
  picture.add("range", Type::float32, "m", "as told; NaN: nothing came back", scan.range_m);
  picture.add("true_range", Type::float32, "m", "of what the pulse met; NaN: nothing",
              scan.true_range_m);
  picture.add("intensity", Type::float32, "1", "of the least that is told", scan.intensity);
  say_names(writer, view,
            picture.add("instance", Type::uint16, "1", "what is met, 0: nothing", scan.instance));
  writer.end_definitions();
  picture.write();
}

void write_seen(const twin::SonarImage& image, const RenderView& view, Writer& writer) {
  (void)view;
  ViewVariables picture(writer, {{"beam", static_cast<std::size_t>(image.beams)},
                                 {"bin", static_cast<std::size_t>(image.bins)}});
  picture.add("intensity", Type::float32, "1",
              "of the echo, of a source of 1 at 1 m, with speckle and noise", image.intensity);
  picture.add("mean_intensity", Type::float32, "1", "the same without speckle and noise",
              image.mean);
  writer.end_definitions();
  picture.write();
}

}  // namespace

void write_view_png(const RenderView& view, const std::filesystem::path& file) {
  std::visit([&](const auto& seen) { write_png_of(seen, view, file); }, view.seen);
}

bool write_right_png(const RenderView& view, const std::filesystem::path& file) {
  const auto* camera = std::get_if<CameraView>(&view.seen);
  if (camera == nullptr || !camera->right) return false;
  const twin::Picture& picture = camera->right->picture;
  write_png(file, picture.wide, picture.high, 3, picture.rgb);
  return true;
}

void write_view_netcdf(const RenderView& view, const RenderedRun& run,
                       const std::filesystem::path& file) {
  write_beside(file, [&](const std::filesystem::path& partial) {
    Writer writer = Writer::create(partial);
    say_pose(writer, view, run);
    std::visit([&](const auto& seen) { write_seen(seen, view, writer); }, view.seen);
    writer.close(Writer::Durable::no);
  });
}

}  // namespace slackwater::api
