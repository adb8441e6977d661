#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "api/door/people/role.h"
#include "api/door/people/token_book.h"

namespace slackwater::people {

/// A place in a session: of one person, at one station at a time.
struct Seat {
  unsigned number = 0;  ///< from 1, never used twice
  std::string name;
  Role role = Role::looks_on;
  bool is_here = true;                     ///< else its station is cut off
  std::optional<Milliseconds> kept_until;  ///< of one that is cut off
  UtcTime until;                           ///< its token ends
};

/// Why a token opens no seat: the status of HTTP, and words.
struct NoSeat {
  int status = 401;
  std::string text;
};

/// Who is in a session. A seat is taken with a role token; whoever is cut off takes the same seat
/// up again with the resume token that came with it, which is good once. Pure: times are passed in.
/// Not thread-safe.
class Seats {
 public:
  static constexpr Milliseconds kept_ms = 30'000;

  explicit Seats(TokenBook book) : book_(std::move(book)) {}

  /// Nothing: the token opens a seat now. Changes nothing.
  [[nodiscard]] std::optional<NoSeat> refusal(std::string_view token, UtcTime now) const;

  struct Taken {
    unsigned seat = 0;
    bool is_back = false;  ///< the seat was there; if somebody sits there, he goes
    std::string resume;    ///< the next resume token
  };
  /// @param name  the person's own, where the token has none; empty: "operator 3"
  [[nodiscard]] std::variant<Taken, NoSeat> take(std::string_view token, std::string_view name,
                                                 UtcTime now);
  /// Its station has the resume token that it was given: the one before is spent.
  void confirm(unsigned seat);
  /// Its station is gone; the seat is kept for a while.
  void cut_off(unsigned seat, Milliseconds now);
  void leave(unsigned seat);
  /// Seats whose time is over: not taken up again, or by the end of their token.
  [[nodiscard]] std::vector<unsigned> over(Milliseconds now, UtcTime now_utc) const;

  /// Null: there is none.
  [[nodiscard]] const Seat* find(unsigned seat) const noexcept;
  [[nodiscard]] std::vector<Seat> all() const;
  [[nodiscard]] bool has(Role role) const noexcept;

 private:
  struct Held {
    Seat seat;
    std::size_t grant = 0;
    std::string resume;
    std::string before;              ///< good until `resume` has been received; empty: spent
    std::vector<std::string> spent;  ///< resume tokens that were good before, the last few
  };
  [[nodiscard]] const Held* by_resume(std::string_view token) const noexcept;
  [[nodiscard]] bool is_spent(std::string_view token) const noexcept;
  [[nodiscard]] int taken_with(std::size_t grant) const noexcept;

  TokenBook book_;
  std::vector<Held> held_;
  unsigned next_ = 1;
};

}  // namespace slackwater::people
