#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/people/seats.h"
#include "twin/helm/command_arbiter.h"

namespace slackwater::people {

/// Whose the helm of a vehicle is, as every station is shown it.
enum class HelmPhase : std::uint8_t { free, held, requested, allowed, lost };
[[nodiscard]] std::string_view name_of(HelmPhase state) noexcept;

struct HelmNow {
  HelmPhase state = HelmPhase::free;
  unsigned seat = 0;                  ///< of the holder; 0: nobody, or no person
  std::string agent;                  ///< a holder that is no person: a client of another door
  unsigned asker = 0;                 ///< its seat
  std::optional<Milliseconds> until;  ///< of the lease, the request, the leave or the seat
  bool is_raw = false;                ///< the holder may drive the thrusters themselves
  bool operator==(const HelmNow&) const = default;
};

/// What time made of a helm, for the record.
struct HelmChange {
  std::size_t vehicle = 0;
  unsigned seat = 0;  ///< whom it befell
  std::string what;   ///< "lease over", "request lapsed", ...
};

/// The helms of a session's vehicles, by the rules of api/docs/session.md. What is in force is the
/// arbiter's, which other doors ask too; this adds what people need: requests with a countdown, a
/// lease, a seat that is kept. Not thread-safe.
class Helms {
 public:
  static constexpr Milliseconds lease_ms = 60'000;
  static constexpr Milliseconds request_ms = 10'000;
  static constexpr Milliseconds leave_ms = 10'000;
  static constexpr Milliseconds unheard_ms = 1'000;

  explicit Helms(twin::CommandArbiter& arbiter) : arbiter_(arbiter) {}
  void open(std::string name) { vehicles_.emplace_back().name = std::move(name); }

  using Answer = std::optional<twin::Refusal>;
  /// At once where it is free or the holder allows it; else a request that others see.
  [[nodiscard]] Answer ask(const Seat& seat, std::size_t vehicle, Milliseconds now);
  [[nodiscard]] Answer give_back(const Seat& seat, std::size_t vehicle);
  [[nodiscard]] Answer allow(const Seat& seat, std::size_t vehicle, Milliseconds now);
  /// Gives it to who asks.
  [[nodiscard]] Answer grant(const Seat& seat, std::size_t vehicle, const Seats& seats,
                             Milliseconds now);
  [[nodiscard]] Answer deny(const Seat& seat, std::size_t vehicle, Milliseconds now);
  /// Whoever has it. For supervisors.
  [[nodiscard]] Answer take_over(const Seat& seat, std::size_t vehicle, Milliseconds now);
  [[nodiscard]] Answer set_raw(const Seat& seat, std::size_t vehicle, bool is_raw);

  /// The seat said something to the vehicle: its lease begins anew.
  void note_input(const Seat& seat, std::size_t vehicle, Milliseconds now);
  /// Its station is gone or silent. @param kept_until  of the seat, where it is gone
  void lose(const Seat& seat, Milliseconds now, std::optional<Milliseconds> kept_until);
  void back(const Seat& seat, Milliseconds now);
  /// The seat is no more.
  void gone(const Seat& seat);
  [[nodiscard]] std::vector<HelmChange> look(const Seats& seats, Milliseconds now);

  [[nodiscard]] const HelmNow& now(std::size_t vehicle) const { return vehicles_.at(vehicle).now; }
  [[nodiscard]] bool holds(const Seat& seat, std::size_t vehicle) const {
    return vehicles_.at(vehicle).now.seat == seat.number;
  }
  [[nodiscard]] const std::string& name(std::size_t vehicle) const {
    return vehicles_.at(vehicle).name;
  }
  [[nodiscard]] std::size_t size() const noexcept { return vehicles_.size(); }

 private:
  struct Vehicle {
    std::string name;
    HelmNow now;
    std::string client;                   ///< of the holder
    Milliseconds lease_until = 0;         ///< under what else `now.until` counts
    std::optional<Milliseconds> lost_at;  ///< the holder's station
    std::optional<Milliseconds> kept_until;
    bool is_held_for_lost = false;
  };
  void hold(Vehicle& vehicle, const Seat& seat, Milliseconds now);
  static void free(Vehicle& vehicle);
  [[nodiscard]] twin::Refusal not_yours(const Vehicle& vehicle, std::string_view to_do) const;
  void look_at(std::size_t i, const Seats& seats, Milliseconds now,
               std::vector<HelmChange>& changes);
  void end_request(Vehicle& vehicle);

  twin::CommandArbiter& arbiter_;
  std::vector<Vehicle> vehicles_;
};

/// Under which a seat is known to the arbiter, and in the record of commands.
[[nodiscard]] std::string client_of(const Seat& seat);

}  // namespace slackwater::people
