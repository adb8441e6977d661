#include "api/door/people/seats.h"

#include <algorithm>

#include "api/door/http/trust.h"
#include "fields/base/text.h"

namespace slackwater::people {
namespace {

constexpr std::size_t most_spent = 16;
constexpr std::size_t longest_name = 40;  ///< bytes

using api::http::equal_in_constant_time;

/// Without control characters, and no longer than it may be. @param name  UTF-8
std::string shown(std::string_view name) {
  if (name.size() > longest_name) {
    std::size_t end = longest_name;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
    name = name.substr(0, end);
  }
  std::string clean(name);
  std::erase_if(clean, [](unsigned char c) { return c < ' ' || c == 0x7F; });
  return clean;
}

}  // namespace

const Seats::Held* Seats::by_resume(std::string_view token) const noexcept {
  const Held* found = nullptr;
  for (const Held& held : held_)
    if (equal_in_constant_time(held.resume, token) ||
        (!held.before.empty() && equal_in_constant_time(held.before, token)))
      found = &held;
  return found;
}

bool Seats::is_spent(std::string_view token) const noexcept {
  return std::any_of(held_.begin(), held_.end(), [&](const Held& held) {
    return std::find(held.spent.begin(), held.spent.end(), token) != held.spent.end();
  });
}

int Seats::taken_with(std::size_t grant) const noexcept {
  return static_cast<int>(std::count_if(held_.begin(), held_.end(),
                                        [&](const Held& held) { return held.grant == grant; }));
}

std::optional<NoSeat> Seats::refusal(std::string_view token, UtcTime now) const {
  const auto ended = [&](UtcTime until) {
    return NoSeat{401, "found a token that ended at " + format_utc(until) +
                           "; ask whoever runs this session for a new one"};
  };
  if (const Held* held = by_resume(token); held != nullptr) {
    if (held->seat.until <= now) return ended(held->seat.until);
    return std::nullopt;
  }
  if (is_spent(token))
    return NoSeat{401,
                  "found a resume token that was used before, expected the last one; join again "
                  "with your role token"};
  const auto grant = book_.find(token);
  if (!grant)
    return NoSeat{401,
                  "found no token of this session; ask whoever runs it for one, as it was printed "
                  "when the session began"};
  const Grant& opens = book_.grants()[*grant];
  if (opens.until <= now) return ended(opens.until);
  if (taken_with(*grant) >= opens.seats)
    return NoSeat{409, formatted("found {} of the {} seats of this token taken; wait until one is "
                                 "given up, or ask for a token of your own",
                                 taken_with(*grant), opens.seats)};
  return std::nullopt;
}

std::variant<Seats::Taken, NoSeat> Seats::take(std::string_view token, std::string_view name,
                                               UtcTime now) {
  if (auto refused = refusal(token, now)) return *std::move(refused);
  if (const Held* known = by_resume(token); known != nullptr) {
    Held& held = held_[static_cast<std::size_t>(known - held_.data())];
    // Of the two that are good the one that was shown stays so until the new one has arrived.
    std::string other = held.resume == token ? std::move(held.before) : std::move(held.resume);
    if (!other.empty()) held.spent.push_back(std::move(other));
    held.before = std::string(token);
    held.resume = new_token();
    held.seat.is_here = true;
    held.seat.kept_until.reset();
    return Taken{held.seat.number, true, held.resume};
  }
  const std::size_t grant = *book_.find(token);
  const Grant& opens = book_.grants()[grant];
  Held held;
  held.grant = grant;
  held.resume = new_token();
  held.seat = {next_++, opens.name, opens.role, true, std::nullopt, opens.until};
  if (held.seat.name.empty()) held.seat.name = shown(name);
  if (held.seat.name.empty())
    held.seat.name = formatted("{} {}", name_of(opens.role), held.seat.number);
  held_.push_back(held);
  return Taken{held.seat.number, false, held.resume};
}

void Seats::confirm(unsigned seat) {
  for (Held& held : held_) {
    if (held.seat.number != seat || held.before.empty()) continue;
    held.spent.push_back(std::exchange(held.before, {}));
    if (held.spent.size() > most_spent) held.spent.erase(held.spent.begin());
  }
}

void Seats::cut_off(unsigned seat, Milliseconds now) {
  for (Held& held : held_) {
    if (held.seat.number != seat) continue;
    held.seat.is_here = false;
    held.seat.kept_until = now + kept_ms;
  }
}

void Seats::leave(unsigned seat) {
  std::erase_if(held_, [&](const Held& held) { return held.seat.number == seat; });
}

std::vector<unsigned> Seats::over(Milliseconds now, UtcTime now_utc) const {
  std::vector<unsigned> over;
  for (const Held& held : held_)
    if ((held.seat.kept_until && now >= *held.seat.kept_until) || held.seat.until <= now_utc)
      over.push_back(held.seat.number);
  return over;
}

const Seat* Seats::find(unsigned seat) const noexcept {
  const auto found = std::find_if(held_.begin(), held_.end(),
                                  [&](const Held& held) { return held.seat.number == seat; });
  return found == held_.end() ? nullptr : &found->seat;
}

std::vector<Seat> Seats::all() const {
  std::vector<Seat> all;
  for (const Held& held : held_) all.push_back(held.seat);
  return all;
}

bool Seats::has(Role role) const noexcept {
  return std::any_of(held_.begin(), held_.end(),
                     [&](const Held& held) { return held.seat.role == role; });
}

}  // namespace slackwater::people
