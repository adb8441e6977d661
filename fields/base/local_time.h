#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/time.h"

namespace slackwater {

/// When a zone's clocks are set anew.
struct ClockChange {
  UtcTime at{};                   ///< the first instant of the new offset
  std::chrono::minutes offset{};  ///< from then on, local minus UTC
  std::string name;  ///< of the time from then on: "CET", "CEST"; "-03" where it has none
  bool operator==(const ClockChange&) const = default;
};

/// The clocks of a place: one zone of the IANA database, as the operating system holds it
/// (package tzdata; an update of the system is an update of the zones). A value; cheap to copy,
/// thread-safe.
class TimeZone {
 public:
  /// By its IANA name, "Europe/Paris"; also "UTC". Error(invalid_input) for an unknown name, with
  /// the nearest known one; Error(unavailable) where the system has no zones.
  [[nodiscard]] static TimeZone named(std::string_view iana_name);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Local minus UTC at an instant.
  [[nodiscard]] std::chrono::minutes offset_at(UtcTime time) const;
  /// "CEST".
  [[nodiscard]] std::string abbreviation_at(UtcTime time) const;
  /// "2024-07-01 14:00 CEST", to the minute.
  [[nodiscard]] std::string text(UtcTime time) const;
  /// What holds at `from`, then every change up to `to`.
  [[nodiscard]] std::vector<ClockChange> changes(UtcTime from, UtcTime to) const;

 private:
  TimeZone(std::string name, const void* zone) : name_(std::move(name)), zone_(zone) {}
  std::string name_;
  const void* zone_ = nullptr;  ///< owned by the library, for as long as the program runs
};

}  // namespace slackwater
