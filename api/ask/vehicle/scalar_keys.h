#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/yaml_value.h"

namespace slackwater::api {

/// A number of a YAML file under its dotted key: `damping.X_u`, `mounts[0].position_m[1]`.
struct ScalarKey {
  std::string key;
  double value = 0;
};
/// All of them, in the order of the file.
[[nodiscard]] std::vector<ScalarKey> scalar_keys(const YamlValue& mapping);
/// Nothing: no number stands there.
[[nodiscard]] std::optional<double> number_at(const YamlValue& mapping, std::string_view key);
/// The same mapping with another number under a key; as it is where none stands there.
[[nodiscard]] YamlValue with_number(const YamlValue& mapping, std::string_view key, double value);

}  // namespace slackwater::api
