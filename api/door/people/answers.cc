#include "api/door/people/answers.h"

#include <charconv>

#include "api/door/people/told.h"

namespace slackwater::people {

using api::http::Response;
using nlohmann::json;

std::optional<std::size_t> number_in_path(const std::string& part) {
  std::size_t number = 0;
  const char* const end = part.data() + part.size();
  const auto [rest, problem] = std::from_chars(part.data(), end, number);
  if (problem != std::errc() || rest != end) return std::nullopt;
  return number;
}

Response json_response(const json& body) {
  Response response;
  response.media_type = "application/json";
  response.body = text_of(body);
  return response;
}

}  // namespace slackwater::people
