#pragma once
#include <memory>
#include <optional>
#include <string>

#include "api/door/http/websocket.h"
#include "api/door/people/action.h"
#include "api/door/people/role.h"
#include "api/door/people/wire/frame.h"
#include "twin/helm/refusal.h"

namespace slackwater::people {

/// Why a station is turned out; RFC 6455 leaves these numbers to us.
enum class CloseCode : std::uint16_t {
  over = 4000,
  taken_up_elsewhere = 4001,
  no_hello = 4002,
  too_many = 4003,
  malformed = 4004,
  token_ended = 4005,
  silent = 4006,
};

/// How many messages a station may send: so many a second, and a burst.
class Allowance {
 public:
  Allowance(double per_s, double burst) : per_s_(per_s), burst_(burst), left_(burst) {}
  [[nodiscard]] bool take(Milliseconds now) noexcept {
    left_ = std::min(burst_, left_ + per_s_ * static_cast<double>(now - at_) / 1000);
    at_ = now;
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
  }

 private:
  double per_s_, burst_, left_;
  Milliseconds at_ = 0;
};

/// Sticks that follow on each other: one row of the record at their beginning, one at their end.
struct StickRow {
  Action row;                            ///< of the first one
  std::optional<twin::Refusal> refused;  ///< likewise
  std::uint64_t count = 0;
  Milliseconds last_at = 0;
  std::size_t vehicle = 0;
};

/// A connection of a session, with or without a seat.
struct Station {
  std::shared_ptr<api::http::WebSocket> socket;
  std::string token;  ///< that it came with; emptied once it has a seat
  unsigned seat = 0;  ///< 0: it has not said hello
  Milliseconds since = 0;
  Milliseconds heard_at = 0;
  Allowance all{120, 240};  ///< messages
  Allowance deeds{10, 60};  ///< those that leave a row in the record
  FrameFlow flow;
  std::optional<StickRow> stick;
  bool is_unheard = false;  ///< its helms are lost until it says something
  bool is_turned_out = false;
};

}  // namespace slackwater::people
