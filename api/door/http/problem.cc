#include "api/door/http/problem.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace slackwater::api::http {
namespace {

constexpr std::array<std::pair<int, std::string_view>, 29> reasons{{
    {101, "Switching Protocols"},
    {200, "OK"},
    {201, "Created"},
    {202, "Accepted"},
    {204, "No Content"},
    {301, "Moved Permanently"},
    {302, "Found"},
    {303, "See Other"},
    {304, "Not Modified"},
    {308, "Permanent Redirect"},
    {400, "Bad Request"},
    {401, "Unauthorized"},
    {403, "Forbidden"},
    {404, "Not Found"},
    {405, "Method Not Allowed"},
    {406, "Not Acceptable"},
    {408, "Request Timeout"},
    {409, "Conflict"},
    {410, "Gone"},
    {413, "Content Too Large"},
    {414, "URI Too Long"},
    {415, "Unsupported Media Type"},
    {422, "Unprocessable Content"},
    {426, "Upgrade Required"},
    {431, "Request Header Fields Too Large"},
    {500, "Internal Server Error"},
    {501, "Not Implemented"},
    {503, "Service Unavailable"},
    {505, "HTTP Version Not Supported"},
}};

Response hidden(const std::string& what, const std::string& instance) {
  Response response =
      problem(500, "The server failed on this request; its log says why.", instance);
  response.for_the_log = what;
  return response;
}

Response of_error(const Error& error, const std::string& instance) {
  const int status = status_of(error.kind());
  if (status == 500) return hidden(error.message(), instance);
  Response response = problem(status, error.message(), instance);
  if (status == 503) {
    response.headers.emplace_back("Retry-After", "10");
    response.for_the_log = error.message();
  }
  return response;
}

}  // namespace

std::string_view reason_of(int status) noexcept {
  const auto found = std::find_if(reasons.begin(), reasons.end(),
                                  [&](const auto& reason) { return reason.first == status; });
  return found == reasons.end() ? "Error" : found->second;
}

int status_of(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::usage:
    case ErrorKind::invalid_input:
      return 400;
    case ErrorKind::not_found:
      return 404;
    case ErrorKind::unavailable:
    case ErrorKind::not_converged:
      return 503;
    case ErrorKind::internal:
      break;
  }
  return 500;
}

Response problem(int status, const std::string& detail, const std::string& instance) {
  nlohmann::ordered_json document{{"type", "about:blank"},
                                  {"title", reason_of(status)},
                                  {"status", status},
                                  {"detail", detail}};
  if (!instance.empty()) document["instance"] = instance;
  Response response;
  response.status = status;
  response.media_type = "application/problem+json";
  response.body = document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  return response;
}

Response problem_of(const std::exception_ptr& thrown, const std::string& instance) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    return of_error(error, instance);
  } catch (const std::exception& error) {
    return hidden(error.what(), instance);
  } catch (...) {
    return hidden("an exception that is no std::exception", instance);
  }
}

}  // namespace slackwater::api::http
