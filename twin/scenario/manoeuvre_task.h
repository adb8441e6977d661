#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/yaml_value.h"
#include "twin/scenario/source_place.h"

namespace slackwater::twin {

/// The standard manoeuvres of trials (IMO MSC.137(76) and MSC/Circ.1053; ITTC 7.5-02-06), and steps
/// of what an autopilot keeps.
enum class ManoeuvreKind {
  turning_circle,  ///< the helm put over and kept there
  zig_zag,         ///< the helm to the other side each time that the heading has changed by so much
  spiral,          ///< Dieudonne's: helm after helm, each until the turn is steady
  pull_out,        ///< the helm amidships out of a steady turn
  steps,           ///< of heading, speed and depth, kept by the autopilot
};
/// "turning_circle": the word of scenarios and logs.
[[nodiscard]] const char* name_of(ManoeuvreKind kind) noexcept;
/// Nothing for a word of none.
[[nodiscard]] std::optional<ManoeuvreKind> manoeuvre_named(std::string_view word) noexcept;

/// From a time on, what the autopilot is to keep; of the rest what it kept before.
struct KeptStep {
  double at_s = 0;  ///< since the task began
  std::optional<double> heading_rad;
  std::optional<double> speed_m_s;
  std::optional<double> depth_m;
  SourcePlace place;
  bool operator==(const KeptStep&) const = default;
};

/// A manoeuvre as a scenario asks for it. It begins with an approach, under the autopilot; then the
/// helm is put over with the propulsion as it was, and the autopilot keeps the depth alone. Helms
/// are rad of the rudder, positive: bow to starboard, or shares: of the rudder's range, or of the
/// most yaw moment of the thrusters.
struct ManoeuvreTask {
  ManoeuvreKind kind{};
  std::optional<double> speed_m_s;  ///< of the approach, and before the first step that says one;
                                    ///< nothing: that of the vehicle
  double approach_s = 60;
  bool to_port = false;  ///< the first helm
  bool helms_are_shares = false;
  /// Of a spiral in their order, signed; of the others one, above 0, or none: all that there is, of
  /// a zig-zag 20 degrees.
  std::vector<double> helms;
  /// Of a zig-zag: at which the helm goes to the other side. Of a turning circle: after which it is
  /// over.
  double heading_change_rad = 0;
  std::size_t executes = 5;  ///< of a zig-zag: how often the helm is put over
  double turn_s = 0;         ///< of a pull-out: how long it turns
  double each_s = 0;         ///< of a spiral: at each helm
  double lasts_s = 0;        ///< since the helm was put over, of a pull-out since it is amidships,
                             ///< of steps since they began; at most. Of a spiral 0
  std::vector<KeptStep> steps;  ///< `at_s` rising
  SourcePlace place;
  SourcePlace helm_place;  ///< of the key that says the helm; that of the task where none does
  bool operator==(const ManoeuvreTask&) const = default;
};

/// Its approach and all after it, at most.
[[nodiscard]] double longest_s(const ManoeuvreTask& task) noexcept;

/// The task of a scenario whose `do` is that. @throws Error(invalid_input) with the line
[[nodiscard]] ManoeuvreTask read_manoeuvre(const Config& task, ManoeuvreKind kind);
/// Its keys but for `do` and `phase`.
void put_manoeuvre(const ManoeuvreTask& task, YamlValue& value);

}  // namespace slackwater::twin
