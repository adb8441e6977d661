#include "twin/scenario/actuator_table.h"

#include <array>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr std::array<std::string_view, 7> suffixes{"_share", "_rad_s", "_rpm", "_n",
                                                   "_deg",   "_m3",    "_m"};
constexpr std::size_t most_rows = 100000;

ActuatorRow read_row(const Config& config) {
  ActuatorRow row;
  row.place = place_of_key(config, ".at_s");
  row.at_s = config.number("at_s", {0, 30 * 86400.0});
  for (const std::string& key : config.keys()) {
    if (key == "at_s") continue;
    const auto parts = actuator_key(key);
    if (!parts)
      config.refuse(key,
                    "expected the name of an actuator and its unit: NAME_share, NAME_rad_s, "
                    "NAME_rpm, NAME_n, NAME_deg, NAME_m or NAME_m3");
    const bool is_share = parts->unit == KeyUnit::share;
    row.setting.emplace_back(key, config.number(key, is_share ? Range{-1, 1} : Range{-1e6, 1e6}));
  }
  if (row.setting.empty())
    config.refuse("at_s", "found a row without an actuator; give one, such as rudder_deg: 10");
  return row;
}

void read_keep(const Config& config, ActuatorTable& table) {
  for (const std::string& word : config.texts("keep")) {
    bool* const keeps = word == "depth"     ? &table.keeps_depth
                        : word == "heading" ? &table.keeps_heading
                        : word == "speed"   ? &table.keeps_speed
                                            : nullptr;
    if (keeps == nullptr)
      config.refuse("keep", "found " + word + ", expected depth, heading or speed");
    *keeps = true;
  }
}

}  // namespace

std::string_view suffix_of(KeyUnit unit) noexcept {
  return suffixes[static_cast<std::size_t>(unit)];
}

std::optional<ActuatorKey> actuator_key(std::string_view key) noexcept {
  for (std::size_t i = 0; i < suffixes.size(); ++i)
    if (key.size() > suffixes[i].size() && key.ends_with(suffixes[i]))
      return ActuatorKey{key.substr(0, key.size() - suffixes[i].size()), static_cast<KeyUnit>(i)};
  return std::nullopt;
}

ActuatorTable read_actuator_table(const Config& task, double lasts_s) {
  ActuatorTable table;
  table.place = place_of_key(task, ".do");
  read_keep(task, table);
  table.speed_m_s = task.optional_number("speed_m_s", {0.01, 60});
  if (table.speed_m_s && !table.keeps_speed)
    task.refuse("speed_m_s", "found without keep: [speed], which would keep it; add that");
  for (const Config& config : task.children("table")) {
    ActuatorRow row = read_row(config);
    if (!table.rows.empty() && !(row.at_s > table.rows.back().at_s))
      config.refuse("at_s", formatted("found {:g} after {:g}; list rows in the order of their time",
                                      row.at_s, table.rows.back().at_s));
    if (!(row.at_s < lasts_s))
      config.refuse("at_s", formatted("found {:g}, and the task lasts {:g} s; give it a longer "
                                      "duration, or leave the row out",
                                      row.at_s, lasts_s));
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty() || table.rows.size() > most_rows)
    task.refuse("table", formatted("found {} rows, expected 1 to {}: [{{at_s: 0, rudder_deg: 10}}]",
                                   table.rows.size(), most_rows));
  return table;
}

}  // namespace slackwater::twin
