#include "api/door/people/connection.h"

#include "api/door/http/problem.h"
#include "api/door/http/trust.h"
#include "api/door/people/told.h"
#include "fields/base/error.h"

namespace slackwater::people {
namespace {

using api::http::Request;
using api::http::Worth;
using nlohmann::json;

constexpr Milliseconds hello_ms = 5'000, silent_ms = 90'000;

}  // namespace

std::optional<api::http::Response> refusal_of_origin(const Request& request) {
  if (api::http::is_of_own_origin(request)) return std::nullopt;
  return api::http::problem(403,
                            "found a page of another origin, expected this server's own; open "
                            "/session here",
                            request.path);
}

void tell(Connection& station, const json& json) {
  if (station.is_turned_out) return;
  // What a station must know to be right is never dropped; it is turned out by its silence instead.
  (void)station.socket->send({true, text_of(json), nullptr, Worth::essential});
}

void turn_out(Connection& station, const TurnOut& why) {
  if (station.is_turned_out) return;
  tell(station, {{"is", "bye"}, {"code", static_cast<int>(why.code)}, {"text", why.text}});
  station.is_turned_out = true;
  station.socket->close(static_cast<std::uint16_t>(why.code), why.text);
}

json refused_json(const StationSays& says, std::string_view reason, std::string_view text) {
  return {
      {"is", "answer"}, {"id", says.id()}, {"taken", false}, {"reason", reason}, {"text", text}};
}

std::variant<StationSays, TurnOut> hear(Connection& station, std::string_view text,
                                        Milliseconds now) {
  station.heard_at = now;
  if (!station.all.take(now))
    return TurnOut{CloseCode::too_many, "found more than 120 messages a second; send fewer"};
  try {
    return StationSays(text);
  } catch (const Error& e) {
    return TurnOut{CloseCode::malformed, e.message()};
  }
}

std::optional<TurnOut> overdue(const Connection& station, bool has_said_hello, Milliseconds now) {
  if (!has_said_hello && now > station.since + hello_ms)
    return TurnOut{CloseCode::no_hello, "found no hello within 5 s"};
  if (now > station.heard_at + silent_ms)
    return TurnOut{CloseCode::silent, "found nothing from this station for 90 s"};
  return std::nullopt;
}

bool keeps_in_touch(Connection& station, const StationSays& says, Milliseconds now) {
  if (says.what() == "time") {
    tell(station, {{"is", "clock"}, {"at", says.number("at", -1e15, 1e15)}, {"clock", now}});
    return true;
  }
  if (says.what() != "saw") return false;
  if (!station.flow.saw(static_cast<std::uint32_t>(says.whole("frame", 0, 0xFFFFFFFFLL))))
    throw Error(ErrorKind::invalid_input,
                "saw: frame: found one that was never sent, expected the last one drawn");
  if (says.flag("is_lost", false)) station.flow.lost();
  return true;
}

}  // namespace slackwater::people
