#include "api/door/people/helms.h"

#include <array>

#include "api/log/person_source.h"
#include "fields/base/text.h"

namespace slackwater::people {
namespace {

using twin::Refusal;
using twin::RefusalReason;

Refusal unauthorised(std::string text) { return {RefusalReason::unauthorised, std::move(text)}; }

/// As a lease is shown: not later than it ends, and the same for a while, so that a stick does not
/// tell every station of a new end with each command.
Milliseconds shown(Milliseconds lease_until) { return lease_until / 5'000 * 5'000; }

}  // namespace

std::string_view name_of(HelmPhase state) noexcept {
  static constexpr std::array<std::string_view, 5> names{"free", "held", "requested", "allowed",
                                                         "lost"};
  return names[static_cast<std::size_t>(state)];
}

std::string client_of(const Seat& seat) { return api::source_of_person(seat.number, seat.name); }

void Helms::hold(Vehicle& vehicle, const Seat& seat, Milliseconds now) {
  vehicle.client = client_of(seat);
  vehicle.lease_until = now + lease_ms;
  vehicle.lost_at.reset();
  vehicle.is_held_for_lost = false;
  vehicle.now = {HelmPhase::held, seat.number, "", 0, shown(vehicle.lease_until), false};
}

/// Whoever asks for it goes on asking, and gets it at the next look.
void Helms::free(Vehicle& vehicle) {
  const HelmNow was = vehicle.now;
  vehicle.client.clear();
  vehicle.lost_at.reset();
  vehicle.now = {};
  if (was.asker == 0) return;
  vehicle.now.state = HelmPhase::requested;
  vehicle.now.asker = was.asker;
  vehicle.now.until = was.until;
}

void Helms::end_request(Vehicle& vehicle) {
  vehicle.now.asker = 0;
  vehicle.now.state = vehicle.now.seat == 0 && vehicle.now.agent.empty() ? HelmPhase::free
                      : vehicle.lost_at                                  ? HelmPhase::lost
                                                                         : HelmPhase::held;
  vehicle.now.until.reset();
  if (vehicle.now.state == HelmPhase::held && vehicle.now.seat != 0)
    vehicle.now.until = shown(vehicle.lease_until);
  if (vehicle.now.state == HelmPhase::lost) vehicle.now.until = vehicle.kept_until;
}

Refusal Helms::not_yours(const Vehicle& vehicle, std::string_view to_do) const {
  if (vehicle.client.empty() && vehicle.now.agent.empty())
    return unauthorised(
        formatted("nobody has the helm of {}; ask for it to {}", vehicle.name, to_do));
  return unauthorised(formatted("{} has the helm of {}; ask for it to {}",
                                vehicle.now.agent.empty() ? vehicle.client : vehicle.now.agent,
                                vehicle.name, to_do));
}

Helms::Answer Helms::ask(const Seat& seat, std::size_t i, Milliseconds now) {
  Vehicle& vehicle = vehicles_.at(i);
  const std::string client = client_of(seat);
  if (vehicle.now.seat == seat.number) {
    vehicle.lease_until = now + lease_ms;
    if (vehicle.now.state == HelmPhase::held) vehicle.now.until = shown(vehicle.lease_until);
    return std::nullopt;
  }
  if (vehicle.now.state == HelmPhase::allowed) {
    if (auto refused = arbiter_.take_over(client, i, arbiter_.time_s())) return refused;
    hold(vehicle, seat, now);
    return std::nullopt;
  }
  if (arbiter_.holder(i).empty() || (vehicle.now.agent.empty() && vehicle.now.seat == 0)) {
    auto refused = arbiter_.ask_for_lease(client, i, arbiter_.time_s());
    if (!refused) {
      hold(vehicle, seat, now);
      return std::nullopt;
    }
    if (arbiter_.holder(i).empty()) return refused;
    vehicle.now.agent = arbiter_.holder(i);  // somebody was faster at another door
  }
  if (vehicle.now.asker != 0 && vehicle.now.asker != seat.number)
    return unauthorised(
        formatted("somebody else asks for the helm of {} already; ask again in "
                  "{:.0f} s",
                  vehicle.name, seconds(*vehicle.now.until - now)));
  if (vehicle.now.asker == seat.number) return std::nullopt;
  vehicle.now.state = HelmPhase::requested;
  vehicle.now.asker = seat.number;
  vehicle.now.until = now + request_ms;
  return std::nullopt;
}

Helms::Answer Helms::give_back(const Seat& seat, std::size_t i) {
  Vehicle& vehicle = vehicles_.at(i);
  if (vehicle.now.seat != seat.number) {
    if (vehicle.now.asker == seat.number) {
      end_request(vehicle);
      return std::nullopt;
    }
    return unauthorised(
        formatted("the helm of {} is not yours; there is nothing to give back", vehicle.name));
  }
  auto refused = arbiter_.release(vehicle.client, i, arbiter_.time_s());
  free(vehicle);
  return refused;
}

Helms::Answer Helms::allow(const Seat& seat, std::size_t i, Milliseconds now) {
  Vehicle& vehicle = vehicles_.at(i);
  if (vehicle.now.seat != seat.number) return not_yours(vehicle, "let others take it");
  if (vehicle.now.state == HelmPhase::requested)
    return unauthorised("somebody asks for this helm; grant it or deny it");
  // At every door: a client of another one may ask for it as well.
  if (auto refused = arbiter_.allow_take_over(vehicle.client, i, arbiter_.time_s())) return refused;
  vehicle.now.state = HelmPhase::allowed;
  vehicle.now.until = now + leave_ms;
  return std::nullopt;
}

Helms::Answer Helms::grant(const Seat& seat, std::size_t i, const Seats& seats, Milliseconds now) {
  Vehicle& vehicle = vehicles_.at(i);
  if (vehicle.now.seat != seat.number) return not_yours(vehicle, "grant it");
  const Seat* asker = seats.find(vehicle.now.asker);
  if (vehicle.now.asker == 0 || asker == nullptr)
    return unauthorised(formatted("nobody asks for the helm of {}", vehicle.name));
  if (auto refused = arbiter_.take_over(client_of(*asker), i, arbiter_.time_s())) return refused;
  hold(vehicle, *asker, now);
  return std::nullopt;
}

Helms::Answer Helms::deny(const Seat& seat, std::size_t i, Milliseconds now) {
  Vehicle& vehicle = vehicles_.at(i);
  if (vehicle.now.seat != seat.number) return not_yours(vehicle, "deny it");
  if (vehicle.now.asker == 0)
    return unauthorised(formatted("nobody asks for the helm of {}", vehicle.name));
  vehicle.lease_until = now + lease_ms;
  end_request(vehicle);
  return std::nullopt;
}

Helms::Answer Helms::take_over(const Seat& seat, std::size_t i, Milliseconds now) {
  Vehicle& vehicle = vehicles_.at(i);
  if (auto refused = arbiter_.take_over(client_of(seat), i, arbiter_.time_s())) return refused;
  hold(vehicle, seat, now);
  return std::nullopt;
}

Helms::Answer Helms::set_raw(const Seat& seat, std::size_t i, bool is_raw) {
  Vehicle& vehicle = vehicles_.at(i);
  if (vehicle.now.seat != seat.number) return not_yours(vehicle, "drive its thrusters");
  vehicle.now.is_raw = is_raw;
  return std::nullopt;
}

void Helms::note_input(const Seat& seat, std::size_t i, Milliseconds now) {
  Vehicle& vehicle = vehicles_.at(i);
  if (vehicle.now.seat != seat.number) return;
  vehicle.lease_until = now + lease_ms;
  if (vehicle.now.state == HelmPhase::held) vehicle.now.until = shown(vehicle.lease_until);
}

void Helms::lose(const Seat& seat, Milliseconds now, std::optional<Milliseconds> kept_until) {
  for (Vehicle& vehicle : vehicles_) {
    if (vehicle.now.seat != seat.number) continue;
    if (!vehicle.lost_at) {
      vehicle.lost_at = now;
      vehicle.is_held_for_lost = false;
    }
    vehicle.kept_until = kept_until;
    vehicle.now.is_raw = false;  // what was confirmed is confirmed anew
    if (vehicle.now.state == HelmPhase::requested) continue;
    vehicle.now.state = HelmPhase::lost;
    vehicle.now.until = kept_until;
  }
}

void Helms::back(const Seat& seat, Milliseconds now) {
  for (Vehicle& vehicle : vehicles_) {
    if (vehicle.now.seat != seat.number) continue;
    vehicle.lost_at.reset();
    vehicle.is_held_for_lost = false;
    vehicle.lease_until = now + lease_ms;
    if (vehicle.now.state == HelmPhase::requested) continue;
    end_request(vehicle);
  }
}

void Helms::gone(const Seat& seat) {
  arbiter_.lost(client_of(seat), arbiter_.time_s());
  for (Vehicle& vehicle : vehicles_) {
    if (vehicle.now.asker == seat.number) end_request(vehicle);
    if (vehicle.now.seat != seat.number) continue;
    free(vehicle);
  }
}

std::vector<HelmChange> Helms::look(const Seats& seats, Milliseconds now) {
  std::vector<HelmChange> changes;
  for (std::size_t i = 0; i < vehicles_.size(); ++i) look_at(i, seats, now, changes);
  return changes;
}

void Helms::look_at(std::size_t i, const Seats& seats, Milliseconds now,
                    std::vector<HelmChange>& changes) {
  Vehicle& vehicle = vehicles_[i];
  HelmNow& is = vehicle.now;
  const std::string holder = arbiter_.holder(i);
  // The vehicle goes no further, or was given back to its mission.
  if (is.seat != 0 && holder != vehicle.client) {
    changes.push_back({i, is.seat, "helm ended"});
    free(vehicle);
  }
  if (is.seat == 0 && is.agent != holder) {
    is.agent = holder;
    if (is.asker == 0) is.state = holder.empty() ? HelmPhase::free : HelmPhase::held;
  }
  if (vehicle.lost_at && !vehicle.is_held_for_lost && now >= *vehicle.lost_at + unheard_ms) {
    arbiter_.unheard(vehicle.client, i, arbiter_.time_s());
    vehicle.is_held_for_lost = true;
    // What nobody had told anything goes on with its own mission.
    const bool is_helmed = arbiter_.standing(i).mode != twin::HelmMode::own;
    changes.push_back({i, is.seat, is_helmed ? "link lost: holds" : "link lost"});
  }
  if (is.asker != 0) {
    const Seat* asker = seats.find(is.asker);
    if (asker == nullptr) return end_request(vehicle);
    const bool is_free = is.seat == 0 && is.agent.empty();
    if (now < *is.until && !is_free) return;
    const bool has_no_say = is.seat == 0 || vehicle.lost_at;
    const unsigned number = is.asker;
    if (has_no_say && !arbiter_.take_over(client_of(*asker), i, arbiter_.time_s())) {
      hold(vehicle, *asker, now);
      changes.push_back({i, number, "helm got"});
      return;
    }
    end_request(vehicle);
    changes.push_back({i, number, "request lapsed"});
    return;
  }
  if (is.state == HelmPhase::allowed && now >= *is.until) end_request(vehicle);
  if (is.state == HelmPhase::held && is.seat != 0 && now >= vehicle.lease_until) {
    changes.push_back({i, is.seat, "lease over"});
    (void)arbiter_.release(vehicle.client, i, arbiter_.time_s());
    free(vehicle);
  }
}

}  // namespace slackwater::people
