#include "twin/helm/authority.h"

#include "fields/base/check.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr double soon_s = 1e-6;  // what rounding leaves of a number of steps

std::string held_by(std::string_view name, const std::string& holder) {
  return formatted("{} is held by {}; one client at a time commands it", name, holder);
}

}  // namespace

const std::string& Authority::holder(std::size_t vehicle) const { return held_.at(vehicle).client; }

std::optional<std::string> Authority::ask(std::string_view client, std::size_t vehicle,
                                          std::string_view name, double now_s) {
  expects(!client.empty(), "a client has a name");
  look(now_s);
  Held& held = held_.at(vehicle);
  const bool has_leave = held.leave_until_s >= now_s;
  if (!held.client.empty() && held.client != client && !has_leave)
    return held_by(name, held.client) + formatted(
                                            "; wait until that client gives it back, or ask within "
                                            "{:g} s after it allows a take-over",
                                            take_over_s);
  held = {std::string(client), Keeping::asked, now_s, -1, false};
  return std::nullopt;
}

void Authority::lease(std::string_view client, std::size_t vehicle, double now_s) {
  expects(!client.empty(), "a client has a name");
  held_.at(vehicle) = {std::string(client), Keeping::asked, now_s, -1, true};
}

std::optional<std::string> Authority::refusal(std::string_view client, std::size_t vehicle,
                                              std::string_view name, double now_s) const {
  expects(!client.empty(), "a client has a name");
  const Held& held = held_.at(vehicle);
  if (held.client.empty() || held.client == client || is_over(held, now_s)) return std::nullopt;
  return held_by(name, held.client) + "; ask for it when that client has given it back";
}

void Authority::note_command(std::string_view client, std::size_t vehicle, Keeping keeping,
                             double now_s) {
  expects(!refusal(client, vehicle, "the vehicle", now_s), "its holder alone commands a vehicle");
  look(now_s);
  Held& held = held_.at(vehicle);
  if (held.client.empty()) held = {std::string(client), keeping, now_s, -1, false};
  held.keeping = keeping;
  held.renewed_s = now_s;
}

std::optional<std::string> Authority::release(std::string_view client, std::size_t vehicle,
                                              std::string_view name, double now_s) {
  look(now_s);
  Held& held = held_.at(vehicle);
  if (held.client == client) {
    held = {};
    return std::nullopt;
  }
  if (held.client.empty()) return formatted("nobody holds {}; there is nothing to give back", name);
  return held_by(name, held.client) + "; only that client can give it back";
}

std::optional<std::string> Authority::allow_take_over(std::string_view client, std::size_t vehicle,
                                                      std::string_view name, double now_s) {
  look(now_s);
  Held& held = held_.at(vehicle);
  if (held.client == client) {
    held.leave_until_s = now_s + take_over_s;
    return std::nullopt;
  }
  if (held.client.empty()) return formatted("nobody holds {}; ask for it to get it", name);
  return held_by(name, held.client) + "; only that client can allow a take-over";
}

std::vector<std::size_t> Authority::lost(std::string_view client, double now_s) {
  look(now_s);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (held_[i].client != client || client.empty()) continue;
    held_[i] = {};
    left.push_back(i);
  }
  return left;
}

void Authority::end(std::size_t vehicle) { held_.at(vehicle) = {}; }

void Authority::look(double now_s) {
  for (Held& held : held_)
    if (is_over(held, now_s)) held = {};
}

bool Authority::is_over(const Held& held, double now_s) noexcept {
  return !held.client.empty() && !held.is_leased && held.keeping == Keeping::renewed &&
         now_s - held.renewed_s >= renewal_s - soon_s;
}

}  // namespace slackwater::twin
