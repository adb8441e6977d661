#include "api/show/render/sound_file.h"

#include <cmath>
#include <limits>

#include "api/show/render/view_variables.h"
#include "fields/base/text.h"

namespace slackwater::api {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

namespace {

/// Something of each of many.
template <typename Value, typename All, typename Of>
std::vector<Value> each_of(const All& all, const Of& of) {
  std::vector<Value> values;
  for (const auto& one : all) values.push_back(static_cast<Value>(of(one)));
  return values;
}

std::vector<float> middles_m(std::size_t bins, double bin_m) {
  std::vector<float> middles;
  for (std::size_t i = 0; i < bins; ++i)
    middles.push_back(static_cast<float>((static_cast<double>(i) + 0.5) * bin_m));
  return middles;
}

}  // namespace

void write_seen(const twin::SideScanPing& ping, const RenderView& view, Writer& writer) {
  const auto bins = static_cast<std::size_t>(ping.bins);
  ViewVariables along(writer, {{"bin", bins}});
  along.add("slant_range", Type::float32, "m", "of the middle of the bin",
            middles_m(bins, ping.bin_m));
  ViewVariables sides(writer, {{"side", 2}});
  const int side = sides.add("side", Type::int8, "1", "of the sonar", std::vector<int>{0, 1});
  writer.attribute(side, "flag_values", std::vector<double>{0, 1}, Type::int8);
  writer.attribute(side, "flag_meanings", "port starboard");
  ViewVariables picture(sides, along);
  picture.add("intensity", Type::float32, "1",
              "of the echo, of a source of 1 at 1 m, with speckle and noise", ping.intensity);
  picture.add("mean_intensity", Type::float32, "1", "the same without speckle and noise",
              ping.mean);
  say_names(writer, view.things,
            picture.add("instance", Type::uint16, "1",
                        "what throws back most of it, 0: nothing, open water or a shadow",
                        ping.instance));
  writer.end_definitions();
  along.write();
  sides.write();
  picture.write();
}

void write_seen(const MultibeamView& swath, const RenderView& view, Writer& writer) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto& all = swath.soundings;
  ViewVariables beams(writer, {{"beam", all.size()}});
  const auto add = [&](const char* name, const char* units, const char* words, const auto& of) {
    beams.add(name, Type::float64, units, words, each_of<double>(all, of));
  };
  add("bearing", "rad", "to starboard of the axis, as told",
      [](const twin::Sounding& s) { return s.bearing_rad; });
  add("range", "m", "as told; NaN: none", [](const twin::Sounding& s) { return s.range_m; });
  add("true_range", "m", "of what is met there; NaN: nothing within the gate",
      [](const twin::Sounding& s) { return s.true_range_m; });
  add("level", "1", "of the mean echo, of a source of 1 at 1 m",
      [](const twin::Sounding& s) { return s.level; });
  const auto told = [](const twin::Sounding& s, double value) {
    return std::isfinite(s.range_m) ? value : none;
  };
  const auto so = [](const twin::Sounding& s, double value) {
    return std::isfinite(s.true_range_m) ? value : none;
  };
  add("x", "m", "of the sounding, east of the origin",
      [&](const twin::Sounding& s) { return told(s, s.place_m.y); });
  add("y", "m", "of the sounding, north",
      [&](const twin::Sounding& s) { return told(s, s.place_m.x); });
  add("depth", "m", "of the sounding below mean sea level, as told",
      [&](const twin::Sounding& s) { return told(s, s.place_m.z); });
  add("true_depth", "m", "of what is met there below mean sea level",
      [&](const twin::Sounding& s) { return so(s, s.true_place_m.z); });
  say_names(
      writer, view.things,
      beams.add("instance", Type::uint16, "1", "what is met, 0: nothing",
                each_of<std::int64_t>(all, [](const twin::Sounding& s) { return s.instance; })));
  writer.end_definitions();
  beams.write();
}

void write_seen(const twin::EchoSounding& sounding, const RenderView& view, Writer& writer) {
  ViewVariables echo(writer, {{"bin", sounding.mean.size()}});
  echo.add("bin_range", Type::float32, "m", "of the middle of the bin",
           middles_m(sounding.mean.size(), sounding.bin_m));
  echo.add("intensity", Type::float32, "1",
           "of the echo, of a source of 1 at 1 m, with speckle and noise", sounding.intensity);
  echo.add("mean_intensity", Type::float32, "1", "the same without speckle and noise",
           sounding.mean);
  ViewVariables ping(writer, {{"ping", 1}});
  const auto add = [&](const char* name, const char* words, float value) {
    ping.add(name, Type::float32, "m", words, std::vector<float>{value});
  };
  add("range", "as told: of the footprint, with noise; NaN: no bottom", sounding.range_m);
  add("footprint_range", "the same without noise", sounding.footprint_range_m);
  add("nearest_range", "of what is within the half-power beam", sounding.nearest_range_m);
  add("axis_range", "straight along the axis", sounding.axis_range_m);
  say_names(writer, view.things,
            ping.add("instance", Type::uint16, "1", "what the axis meets, 0: nothing",
                     std::vector<std::int64_t>{sounding.instance}));
  writer.end_definitions();
  echo.write();
  ping.write();
}

void write_seen(const twin::CurrentProfile& profile, const RenderView& /*view*/, Writer& writer) {
  using twin::ProfileBin;
  const auto& all = profile.bins;
  ViewVariables bins(writer, {{"bin", all.size()}});
  const auto add = [&](const char* name, const char* units, const char* words, const auto& of) {
    return bins.add(name, Type::float64, units, words, each_of<double>(all, of));
  };
  add("distance", "m", "of the bin's centre along the axis",
      [](const ProfileBin& b) { return b.distance_m; });
  add("depth", "m", "of that place below mean sea level",
      [](const ProfileBin& b) { return b.depth_m; });
  const auto named = [&](int id, const char* standard_name) {
    writer.attribute(id, "standard_name", standard_name);
  };
  named(add("eastward_velocity", "m s-1", "of the water over ground, as told; NaN: no value",
            [](const ProfileBin& b) { return b.velocity_m_s.y; }),
        "eastward_sea_water_velocity");
  named(add("northward_velocity", "m s-1", "likewise",
            [](const ProfileBin& b) { return b.velocity_m_s.x; }),
        "northward_sea_water_velocity");
  named(add("upward_velocity", "m s-1", "likewise",
            [](const ProfileBin& b) { return -b.velocity_m_s.z; }),
        "upward_sea_water_velocity");
  add("true_eastward_velocity", "m s-1",
      "the bin's mean along the axis, orbital motion of waves included",
      [](const ProfileBin& b) { return b.true_velocity_m_s.y; });
  add("true_northward_velocity", "m s-1", "likewise",
      [](const ProfileBin& b) { return b.true_velocity_m_s.x; });
  add("true_upward_velocity", "m s-1", "likewise",
      [](const ProfileBin& b) { return -b.true_velocity_m_s.z; });
  add("error_velocity", "m s-1", "by which both planes of beams disagree; NaN with three beams",
      [](const ProfileBin& b) { return b.error_m_s; });
  const int flaw = bins.add(
      "flaw", Type::uint8, "1", "why there is no value",
      each_of<std::int64_t>(all, [](const ProfileBin& b) { return static_cast<int>(b.flaw); }));
  std::vector<std::string> meanings;
  for (const auto one : {twin::BinFlaw::none, twin::BinFlaw::side_lobe, twin::BinFlaw::no_water})
    meanings.emplace_back(twin::name_of(one));
  writer.attribute(flaw, "flag_values", std::vector<double>{0, 1, 2}, Type::uint8);
  writer.attribute(flaw, "flag_meanings", joined(meanings, " "));
  ViewVariables beams(writer, {{"beam", profile.beams.size()}});
  beams.add("boundary_range", Type::float32, "m", "of what the beam meets; NaN: nothing in reach",
            std::vector<float>(profile.boundary_range_m.begin(), profile.boundary_range_m.end()));
  const auto add_beam = [&](const char* name, const auto& of) {
    beams.add(name, Type::float64, "1", "part of the beam's direction",
              each_of<double>(profile.beams, of));
  };
  add_beam("beam_east", [](const twin::Triple<double>& b) { return b.y; });
  add_beam("beam_north", [](const twin::Triple<double>& b) { return b.x; });
  add_beam("beam_up", [](const twin::Triple<double>& b) { return -b.z; });
  ViewVariables heard(bins, beams);
  std::vector<float> approach;
  for (const ProfileBin& bin : all)
    approach.insert(approach.end(), bin.approach_m_s.begin(), bin.approach_m_s.end());
  heard.add("approach_velocity", Type::float32, "m s-1",
            "of instrument and water along the beam, with noise, folded; NaN: no value", approach);
  writer.end_definitions();
  bins.write();
  beams.write();
  heard.write();
}

}  // namespace slackwater::api
