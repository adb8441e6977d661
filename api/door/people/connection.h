#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "api/door/http/websocket.h"
#include "api/door/people/role.h"
#include "api/door/people/station_says.h"
#include "api/door/people/wire/frame.h"

namespace slackwater::people {

/// Of the sub-protocol, live or recorded.
inline constexpr std::string_view protocol_name = "slackwater.session.v1";

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

struct TurnOut {
  CloseCode code{};
  std::string text;  ///< for people
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

/// What a station is to whoever serves it, a live session or a recording.
struct Connection {
  std::shared_ptr<api::http::WebSocket> socket;
  Milliseconds since = 0;
  Milliseconds heard_at = 0;
  Allowance all{120, 240};  ///< messages
  FrameFlow flow;
  bool is_turned_out = false;
};

/// A page of another origin is let in nowhere.
[[nodiscard]] std::optional<api::http::Response> refusal_of_origin(
    const api::http::Request& request);

/// Nothing to one that was turned out.
void tell(Connection& station, const nlohmann::json& json);
/// Says why, and closes. Once.
void turn_out(Connection& station, const TurnOut& why);
/// The answer to a message that is not carried out.
[[nodiscard]] nlohmann::json refused_json(const StationSays& says, std::string_view reason,
                                          std::string_view text);

/// What a station says, or why it is turned out for it.
[[nodiscard]] std::variant<StationSays, TurnOut> hear(Connection& station, std::string_view text,
                                                      Milliseconds now);
/// Why a station is turned out that says too little.
[[nodiscard]] std::optional<TurnOut> overdue(const Connection& station, bool has_said_hello,
                                             Milliseconds now);
/// "time" and "saw", which are the same wherever a station sits. @return whether it was one of them
/// @throws Error(invalid_input)
[[nodiscard]] bool keeps_in_touch(Connection& station, const StationSays& says, Milliseconds now);

}  // namespace slackwater::people
