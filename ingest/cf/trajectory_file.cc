#include "ingest/cf/trajectory_file.h"

#include <algorithm>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "ingest/cf/trajectory_table_file.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {
namespace {

using netcdf::File;
using netcdf::Type;
using netcdf::Writer;

constexpr const char* since = "seconds since ";
using constants::nan;
constexpr std::size_t most_values = std::size_t{64} << 20;

/// "2025-06-02 06:00:00" of an epoch, as CF writes it.
std::string cf_text(UtcTime time) {
  std::string text = format_utc(time);
  std::replace(text.begin(), text.end(), 'T', ' ');
  std::erase(text, 'Z');
  return text;
}

UtcTime epoch_from(const File& file, const netcdf::Variable& time) {
  std::string text = time.text("units").value_or("");
  if (!text.starts_with(since)) {
    throw Error(ErrorKind::invalid_input, file.path().string() + ": found units '" + text +
                                              "' of time, expected seconds since a date");
  }
  text.erase(0, std::string(since).size());
  std::replace(text.begin(), text.end(), ' ', 'T');
  return parse_utc(text + "Z");
}

}  // namespace

std::string TrajectoryFile::attribute(std::string_view name) const {
  for (const auto& [key, text] : attributes)
    if (key == name) return text;
  return {};
}

const TrajectoryFile::Variable* TrajectoryFile::find(std::string_view name) const noexcept {
  for (const Variable& variable : variables)
    if (variable.name == name) return &variable;
  return nullptr;
}

const TrajectoryTable* TrajectoryFile::find_table(std::string_view name) const noexcept {
  for (const TrajectoryTable& table : tables)
    if (table.name == name) return &table;
  return nullptr;
}

void write_trajectories(const TrajectoryFile& tracks, const std::filesystem::path& path) {
  const std::size_t things = tracks.names.size();
  const std::size_t times = tracks.t_s.size();
  expects(things > 0 && times > 0, "tracks are of something, at some time");
  std::size_t longest = 1;
  for (const std::string& name : tracks.names) longest = std::max(longest, name.size());
  Writer out = Writer::create(path);
  const int trajectory = out.dimension("trajectory", things);
  const int time = out.dimension("time", times);
  const int letters = out.dimension("name_length", longest);
  std::vector<std::pair<std::size_t, int>> pers;
  const auto per_dimension = [&](std::size_t per) {
    for (const auto& [length, id] : pers)
      if (length == per) return id;
    pers.emplace_back(per, out.dimension("index" + std::to_string(per), per));
    return pers.back().second;
  };
  const int name_id = out.variable("trajectory", Type::character, {trajectory, letters});
  out.attribute(name_id, "cf_role", "trajectory_id");
  out.attribute(name_id, "long_name", "name of the vehicle");
  const int time_id = out.variable("time", Type::float64, {time});
  out.attribute(time_id, "standard_name", "time");
  out.attribute(time_id, "long_name", "time since the start of the run");
  out.attribute(time_id, "units", since + cf_text(tracks.epoch));
  out.attribute(time_id, "calendar", "standard");
  out.attribute(time_id, "axis", "T");
  std::vector<int> ids;
  for (const TrajectoryFile::Variable& v : tracks.variables) {
    expects(v.per > 0 && v.values.size() == things * times * v.per,
            "a value for each thing and time");
    std::vector<int> dimensions{trajectory, time};
    if (v.per > 1) dimensions.push_back(per_dimension(v.per));
    Writer::Layout layout;
    layout.chunks = {1, times};
    if (v.per > 1) layout.chunks.push_back(v.per);
    layout.deflate = 1;
    layout.fill_value = nan;
    layout.is_prefilled = false;
    const int id = out.variable(v.name, Type::float64, dimensions, layout);
    if (!v.standard_name.empty()) out.attribute(id, "standard_name", v.standard_name);
    out.attribute(id, "long_name", v.long_name);
    out.attribute(id, "units", v.units);
    const bool is_coordinate =
        v.name == "latitude" || v.name == "longitude" || v.name == "altitude";
    if (v.name == "altitude") {
      out.attribute(id, "positive", "up");
      out.attribute(id, "axis", "Z");
    }
    if (!is_coordinate) out.attribute(id, "coordinates", "time latitude longitude altitude");
    ids.push_back(id);
  }
  TableWriter tables(tracks.tables, out);
  out.attribute(Writer::global, "Conventions", "CF-1.8");
  out.attribute(Writer::global, "featureType", "trajectory");
  for (const auto& [name, text] : tracks.attributes) out.attribute(Writer::global, name, text);
  out.end_definitions();
  std::string names;
  for (std::string name : tracks.names) {
    name.resize(longest, '\0');
    names += name;
  }
  out.write_text(name_id, names);
  out.write_all(time_id, tracks.t_s);
  for (std::size_t i = 0; i < ids.size(); ++i) out.write_all(ids[i], tracks.variables[i].values);
  tables.write(out);
  out.close();
}

TrajectoryFile read_trajectories(const std::filesystem::path& path) {
  const File file = File::open(path);
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorKind::invalid_input,
                path.string() + ": " + why + "; give a log that `slackwater simulate` wrote");
  };
  const netcdf::Variable* time = file.find("time");
  const netcdf::Variable* name = file.find("trajectory");
  if (file.text("featureType") != "trajectory" || time == nullptr || name == nullptr ||
      name->type != netcdf::Type::character || name->shape.size() != 2 || time->shape.size() != 1)
    refuse("found no tracks (featureType trajectory, with variables time and trajectory)");
  TrajectoryFile tracks;
  tracks.epoch = epoch_from(file, *time);
  tracks.t_s = file.read_all(*time);
  const std::size_t things = name->shape[0];
  tracks.names = file.read_texts(*name);
  for (const netcdf::Variable& v : file.variables()) {
    if (&v == time || &v == name) continue;
    if (is_of_a_table(v)) {
      read_into(tracks.tables, file, v);
      continue;
    }
    if (v.shape.size() < 2 || v.shape[0] != things || v.shape[1] != tracks.t_s.size() ||
        v.shape.size() > 3 || v.size() > most_values)
      refuse("variable " + v.name + " is not of each track and time");
    tracks.variables.push_back({v.name, v.text("standard_name").value_or(""),
                                v.text("units").value_or(""), v.text("long_name").value_or(""),
                                v.shape.size() == 3 ? v.shape[2] : 1, file.read_all(v)});
  }
  for (const netcdf::Attribute& a : file.attributes()) {
    if (a.name == "Conventions" || a.name == "featureType") continue;
    if (const auto text = a.text()) tracks.attributes.emplace_back(a.name, *text);
  }
  return tracks;
}

}  // namespace slackwater::ingest
