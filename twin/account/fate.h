#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::twin {

struct Agent;
struct AgentState;

/// What can befall a vehicle that it did not choose. A run that knows none of it is a normal one.
enum class Fate : std::uint8_t {
  battery_empty,
  battery_cut_off,  ///< at its least voltage
  tether_parted,
  turned_over,
  left_depth,  ///< that it was to keep, by more than its scenario bears
  fell,        ///< out of the air
  struck_structure,
  struck_sea,
  aground,
  capsized,
  slower_than_wind,
  slower_than_water,
  left_area,       ///< of the forecast
  forecast_ended,  ///< before the run
  no_data,         ///< of the forecast, where it was
  diverged,        ///< its calculation
  not_recovered,   ///< still out when the run ended, though it has a home to come to
};
/// "battery_empty": the word of logs.
[[nodiscard]] const char* name_of(Fate fate) noexcept;
/// Nothing for a word of none.
[[nodiscard]] std::optional<Fate> fate_named(std::string_view name) noexcept;
/// "battery empty": the one wording for people.
[[nodiscard]] const char* words_of(Fate fate) noexcept;

struct FateEvent {
  Fate what{};
  std::optional<double> at_s;  ///< since the start of the run; nothing: after the one before it
  friend bool operator==(const FateEvent&, const FateEvent&) = default;
};

/// What befell a vehicle, causes first; nothing where its run was a normal one.
///
/// At most one of them is how it ended, the last. Where several could be, the first of these is:
/// what stopped it (what it struck, where it left the forecast, ...); that nobody recovered it.
/// Nothing befalls one that is aboard.
/// @param ran_s  how long the run was
[[nodiscard]] std::vector<FateEvent> fate_of(const Agent& agent, const AgentState& state,
                                             double ran_s);
/// Whether it conducts itself, was stopped by nothing, and has neither ended its mission nor come
/// aboard.
[[nodiscard]] bool is_still_out(const Agent& agent, const AgentState& state) noexcept;
/// When one of them was; nothing: it was not.
[[nodiscard]] std::optional<double> time_of(std::span<const FateEvent> events, Fate what) noexcept;

/// "battery empty at 18:42:10Z -> fell -> struck the sea at 18:42:14Z" with arrows; empty for none.
/// @param structure  the name of the one that was struck; empty: nobody says
[[nodiscard]] std::string fate_text(std::span<const FateEvent> events, UtcTime start,
                                    std::string_view structure = {});

}  // namespace slackwater::twin
