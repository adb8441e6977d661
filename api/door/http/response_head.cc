#include "api/door/http/response_head.h"

#include <algorithm>
#include <array>

#include "api/door/http/problem.h"
#include "fields/base/check.h"
#include "fields/base/month_names.h"
#include "fields/base/text.h"

namespace slackwater::api::http {
namespace {

bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f;
  });
}

void append_field(std::string& head, std::string_view name, std::string_view value) {
  head.append(name).append(": ").append(value).append("\r\n");
}

}  // namespace

std::string http_date(std::time_t time) {
  constexpr std::array<const char*, 7> days{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
  std::tm utc{};
  gmtime_r(&time, &utc);
  return formatted("{}, {:02} {} {:04} {:02}:{:02}:{:02} GMT",
                   days.at(static_cast<std::size_t>(utc.tm_wday)), utc.tm_mday,
                   month_names.at(static_cast<std::size_t>(utc.tm_mon)), 1900 + utc.tm_year,
                   utc.tm_hour, utc.tm_min, utc.tm_sec);
}

std::string response_head(int status, const Fields& fields, std::size_t length, bool keep_alive) {
  std::string head;
  head.reserve(512);
  head.append("HTTP/1.1 ").append(std::to_string(status)).append(" ");
  head.append(reason_of(status)).append("\r\n");
  append_field(head, "Date", http_date(std::time(nullptr)));
  append_field(head, "Server", "slackwater");
  append_field(head, "Connection", keep_alive ? "keep-alive" : "close");
  append_field(head, "X-Content-Type-Options", "nosniff");
  if (status != 204 && status != 304) append_field(head, "Content-Length", std::to_string(length));
  for (const auto& [name, value] : fields) {
    expects(!name.empty() && !has_control_character(name) && !has_control_character(value),
            "a header field of a handler is one line");
    append_field(head, name, value);
  }
  return head.append("\r\n");
}

}  // namespace slackwater::api::http
