#include "api/show/render/view_file.h"

#include <algorithm>
#include <cmath>

#include "api/program/version.h"
#include "api/show/render/picture_truth.h"
#include "api/show/render/png_file.h"
#include "api/show/render/sound_file.h"
#include "api/show/render/view_variables.h"
#include "api/show/render/waterfall.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "ingest/netcdf/file.h"
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
  say_where(writer, view.pose);
}

void write_seen(const CameraView& seen, const RenderView& view, Writer& writer) {
  TruthVariables truth(writer, {seen.truth, seen.matrix, view.things, view.defects});
  ViewVariables& picture = truth.pixels();
  writer.attribute(Writer::global, "gain", seen.picture.gain);
  if (seen.flakes > 0)
    writer.attribute(Writer::global, "marine_snow_flakes", static_cast<double>(seen.flakes));
  if (seen.drops > 0)
    writer.attribute(Writer::global, "spray_drops", static_cast<double>(seen.drops));
  if (seen.right) {
    writer.attribute(Writer::global, "baseline", seen.right->baseline_m);
    picture.add("disparity", Type::float32, "1",
                "pixels that it lies farther left in the right picture; NaN: nothing",
                seen.right->truth.disparity);
    picture.add("in_both", Type::uint8, "1", "1 where the right camera sees the place, too",
                seen.right->truth.is_in_both);
  }
  writer.end_definitions();
  truth.write();
}

void write_seen(const InfraredView& seen, const RenderView& view, Writer& writer) {
  TruthVariables truth(writer, {seen.truth, seen.matrix, view.things, view.defects});
  ViewVariables& picture = truth.pixels();
  picture.add("apparent_temperature", Type::float32, "K",
              "as told: of a black body that radiates so, with noise", seen.heat.apparent_k);
  picture.add("radiance", Type::float32, "W m-2 sr-1", "that comes in the band, without noise",
              seen.heat.radiance);
  picture.add("surface_temperature", Type::float32, "K", "of the place; NaN: sky",
              seen.heat.temperature_k);
  picture.add("emissivity", Type::float32, "1", "of the place; NaN: sky", seen.heat.emissivity);
  writer.end_definitions();
  truth.write();
}

void write_seen(const twin::LidarScan& scan, const RenderView& view, Writer& writer) {
  ViewVariables picture(writer, {{"channel", static_cast<std::size_t>(scan.channels)},
                                 {"column", static_cast<std::size_t>(scan.columns)}});
  picture.add("range", Type::float32, "m", "as told; NaN: nothing came back", scan.range_m);
  picture.add("true_range", Type::float32, "m", "of what the pulse met; NaN: nothing",
              scan.true_range_m);
  picture.add("intensity", Type::float32, "1", "of the least that is told", scan.intensity);
  say_names(writer, view.things,
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
