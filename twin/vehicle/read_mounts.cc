#include "twin/vehicle/read_mounts.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

Triple<double> read_triple(const Config& config, std::string_view key, Range range) {
  const std::vector<double> v = config.numbers(key, range);
  if (v.size() != 3)
    config.refuse(key, "found " + std::to_string(v.size()) + " numbers; give three, [x, y, z]");
  return {v[0], v[1], v[2]};
}

/// @return the names of the kinds; none where all mounts have the same
std::vector<std::string> read_kinds(const Config& config, const std::filesystem::path& data_folder,
                                    Vehicle& vehicle) {
  if (!config.has("thrusters")) {
    vehicle.thrusters = {read_thruster(config.child("thruster"), data_folder)};
    return {};
  }
  if (config.has("thruster"))
    config.refuse("thruster", "`thrusters` names the kinds already; leave one of the two out");
  const Config thrusters = config.child("thrusters");
  const std::vector<std::string> names = thrusters.keys();
  if (names.empty() || names.size() > most_thruster_kinds)
    config.refuse("thrusters",
                  formatted("found {} kinds, expected 1 to {}: {{NAME: {{kind: ...}}}}",
                            names.size(), most_thruster_kinds));
  for (const std::string& name : names)
    vehicle.thrusters.push_back(read_thruster(thrusters.child(name), data_folder));
  return names;
}

std::size_t read_kind_of_mount(const Config& config, const std::vector<std::string>& kinds) {
  if (kinds.empty()) {
    if (config.has("thruster"))
      config.refuse("thruster",
                    "names one of `thrusters`, and there is but `thruster`; name it there, or "
                    "leave this out");
    return 0;
  }
  const std::string name = config.text("thruster");
  const auto found = std::find(kinds.begin(), kinds.end(), name);
  if (found == kinds.end()) {
    std::string all = kinds.front();
    for (std::size_t i = 1; i < kinds.size(); ++i) all += ", " + kinds[i];
    config.refuse("thruster", "found " + name + ", expected one of `thrusters`: " + all);
  }
  return static_cast<std::size_t>(found - kinds.begin());
}

bool is_plain_name(const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && name.size() <= 40 && name.front() >= 'a' && name.front() <= 'z' &&
         std::all_of(name.begin(), name.end(), is_plain);
}

Mount read_mount(const Config& config, const std::vector<std::string>& kinds) {
  Mount mount;
  mount.kind = read_kind_of_mount(config, kinds);
  mount.position_m = read_triple(config, "position_m", {-100, 100});
  const Triple<double> d = read_triple(config, "direction", {-1, 1});
  const double length = std::sqrt(dot(d, d));
  if (std::abs(length - 1) > 1e-3)
    config.refuse("direction",
                  "its length is " + std::to_string(length) + "; give a direction of length 1");
  mount.direction = (1 / length) * d;
  if (const auto turns = config.optional_text("turns")) {
    if (*turns != "clockwise" && *turns != "counterclockwise")
      config.refuse("turns", "found " + *turns +
                                 ", expected clockwise or counterclockwise, seen along the thrust");
    mount.spin = *turns == "clockwise" ? 1 : -1;
  }
  if (const auto name = config.optional_text("name")) {
    if (!is_plain_name(*name))
      config.refuse("name", "found " + *name +
                                "; expected small letters, digits and _, a letter first, 40 at "
                                "most: left_propeller");
    mount.name = *name;
  }
  return mount;
}

void name_mount(const Config& config, std::size_t index, Vehicle& vehicle) {
  Mount& mount = vehicle.mount[index];
  if (mount.name.empty()) mount.name = "thruster_" + std::to_string(index + 1);
  for (const char* taken : {"rudder", "elevator", "moving_mass", "volume"})
    if (mount.name == taken)
      config.refuse("name", "found " + mount.name + ", which is no thruster; give another");
  for (std::size_t i = 0; i < index; ++i)
    if (vehicle.mount[i].name == mount.name)
      config.refuse("name", formatted("found {}, as of mount {}; give each a name of its own",
                                      mount.name, i + 1));
}

/// A kind that no mount has is a slip of the pen.
void expect_all_mounted(const Config& config, const std::vector<std::string>& kinds,
                        const Vehicle& vehicle) {
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    if (mounts_of_kind(vehicle, kind) == 0)
      config.child("thrusters")
          .refuse(kinds[kind], "no mount has it; name it as `thruster` of one, or leave it out");
}

}  // namespace

void read_mounts(const Config& config, const std::filesystem::path& data_folder, Vehicle& vehicle) {
  const std::vector<std::string> kinds = read_kinds(config, data_folder, vehicle);
  const std::vector<Config> mounts = config.children("mounts");
  if (mounts.empty() || mounts.size() > most_mounts) {
    config.refuse("mounts", "found " + std::to_string(mounts.size()) +
                                " thrusters, expected 1 to " + std::to_string(most_mounts));
  }
  for (const Config& mount : mounts) {
    vehicle.mount[vehicle.mounts] = read_mount(mount, kinds);
    name_mount(mount, vehicle.mounts++, vehicle);
  }
  expect_all_mounted(config, kinds, vehicle);
}

}  // namespace slackwater::twin
