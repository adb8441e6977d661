#include "api/door/http/exchange.h"

#include <algorithm>

#include "api/door/http/content_coding.h"
#include "api/door/http/entity_tag.h"
#include "api/door/http/field_list.h"
#include "api/door/http/problem.h"
#include "api/door/http/response_head.h"
#include "api/door/http/trust.h"
#include "api/door/http/websocket_handshake.h"

namespace slackwater::api::http {
namespace {

/// Fields that scripts of other origins may read, beside those of the handlers.
constexpr const char* usual_exposed_fields =
    "Content-Disposition, ETag, Link, Location, Retry-After";
constexpr const char* preflight_seconds = "86400";

bool reads(const std::string& method) { return method == "GET" || method == "HEAD"; }

bool has_field(const Response& response, std::string_view name) {
  return std::any_of(response.headers.begin(), response.headers.end(),
                     [&](const auto& field) { return equal_ignoring_case(field.first, name); });
}

std::string take_field(Response& response, std::string_view name) {
  const auto found =
      std::find_if(response.headers.begin(), response.headers.end(),
                   [&](const auto& field) { return equal_ignoring_case(field.first, name); });
  if (found == response.headers.end()) return {};
  std::string value = std::move(found->second);
  response.headers.erase(found);
  return value;
}

/// "http://host/path" becomes "/path" (RFC 9112 §3.2.2); the server has one host only.
void to_origin_form(Request& request) {
  constexpr std::string_view scheme = "http://";
  if (request.path.size() <= scheme.size()) return;
  if (!equal_ignoring_case(std::string_view(request.path).substr(0, scheme.size()), scheme)) return;
  const std::size_t slash = request.path.find('/', scheme.size());
  request.path = slash == std::string::npos ? "/" : request.path.substr(slash);
}

void add_cache_control(Response& response, bool cacheable) {
  if (has_field(response, "Cache-Control")) return;
  const bool stored = cacheable && response.max_age_s.has_value();
  response.headers.emplace_back(
      "Cache-Control",
      stored ? "public, max-age=" + std::to_string(*response.max_age_s) : "no-store");
}

/// A page whose handler has no policy for it may run nothing and ask for nothing.
void add_page_policy(Response& response) {
  if (!response.media_type.starts_with("text/html")) return;
  if (has_field(response, "Content-Security-Policy")) return;
  response.headers.emplace_back("Content-Security-Policy",
                                "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; "
                                "form-action 'none'; frame-ancestors 'none'");
}

/// The coding of the body where that is wanted and worth it, "" for none.
std::string_view choose_coding(Response& response, const Arrival& arrival) {
  if (has_field(response, "Content-Encoding") ||
      !is_worth_coding(response.media_type, response.body.size())) {
    return {};
  }
  response.headers.emplace_back("Vary", "Accept-Encoding");
  return prefers_gzip(arrival.accept_encoding) ? "gzip" : "";
}

/// The validator of the body as it will be sent, from the handler or from its bytes.
std::string tag_of(Response& response, std::string_view coding) {
  std::string tag = take_field(response, "ETag");
  if (tag.empty()) tag = entity_tag(response.body);
  return coding.empty() ? tag : coded_tag(tag, coding);
}

/// Gives a 200 its validator, turns it into a 304 where the client has it already, codes the rest.
void validate_and_code(Response& response, const Arrival& arrival) {
  const std::string_view coding = choose_coding(response, arrival);
  if (response.status == 200 && reads(arrival.request.method)) {
    const std::string tag = tag_of(response, coding);
    response.headers.emplace_back("ETag", tag);
    if (matches_tag(arrival.if_none_match, tag)) {
      response.status = 304;
      response.body.clear();
      return;
    }
  }
  if (coding.empty()) return;
  response.body = gzip(response.body);
  response.headers.emplace_back("Content-Encoding", coding);
}

}  // namespace

Exchange::Exchange(const ServerOptions& options, const Handler& handler)
    : options_(options), handler_(handler), exposed_fields_(usual_exposed_fields) {
  for (const std::string& field : options.exposed_fields) exposed_fields_ += ", " + field;
}

std::string Exchange::allowed_methods(const Request& request) const {
  if (options_.methods_at)
    if (std::string methods = options_.methods_at(request.path); !methods.empty()) return methods;
  return options_.read_only ? "GET, HEAD, OPTIONS" : "GET, HEAD, OPTIONS, POST";
}

/// By whoever shows what its guard wants to see.
bool Exchange::may_be_written_to(const Request& request) const {
  return allowed_methods(request).find("POST") != std::string::npos;
}

/// Scripts of other origins may read alone.
Response Exchange::options_response(const Request& request) const {
  Response response;
  response.status = 204;
  response.headers = {{"Allow", allowed_methods(request)},
                      {"Access-Control-Allow-Methods", "GET, HEAD, OPTIONS"},
                      {"Access-Control-Allow-Headers", "Accept, Content-Type, If-None-Match"},
                      {"Access-Control-Max-Age", preflight_seconds}};
  return response;
}

void Exchange::log_failure(const Request& request, const std::string& what) const {
  if (options_.on_failure) options_.on_failure(request, what);
}

void Exchange::log(const Response& response, const Request& request) const {
  // An answer that nobody waits for ends early, and is no failure of ours.
  if (response.for_the_log.empty() || request.stop.stop_requested()) return;
  log_failure(request, response.for_the_log);
}

Outcome Exchange::respond(Arrival& arrival) const {
  Request& request = arrival.request;
  if (arrival.host_fields > 1 || (arrival.is_http_1_1 && arrival.host_fields == 0)) {
    return problem(400,
                   "An HTTP/1.1 request has one Host field; found " +
                       std::to_string(arrival.host_fields) + ".",
                   request.path);
  }
  to_origin_form(request);
  if (request.method == "OPTIONS") return options_response(request);
  const bool is_post = request.method == "POST";
  if (!reads(request.method) && (!is_post || !may_be_written_to(request))) {
    const std::string allowed = allowed_methods(request);
    Response refused =
        problem(405, "The method " + request.method + " is not served; use one of " + allowed + ".",
                request.path);
    refused.headers.emplace_back("Allow", allowed);
    return refused;
  }
  if (!request.path.starts_with('/')) {
    return problem(400, "The target of a request starts with '/'; found '" + request.path + "'.",
                   "");
  }
  request.is_trusted = is_trusted(options_.token, arrival);
  const bool is_guarded = options_.guards_itself && options_.guards_itself(request);
  if (!reads(request.method) && !is_guarded && !request.is_trusted) {
    Response refused = problem(401,
                               "Writing needs 'Authorization: Bearer <token>', or a client on "
                               "the server's own machine.",
                               request.path);
    refused.headers.emplace_back("WWW-Authenticate", "Bearer");
    return refused;
  }
  if (request.method != "HEAD") return handler_(request);
  Request as_get = request;
  as_get.method = "GET";
  return handler_(as_get);
}

Reply Exchange::finish(Response response, const Arrival& arrival) const {
  Reply reply;
  reply.route = std::move(response.route);
  reply.method = arrival.request.method;
  reply.keep_alive = arrival.keep_alive;
  add_cache_control(response, response.status < 300 && reads(arrival.request.method));
  add_page_policy(response);
  response.headers.emplace_back("Access-Control-Allow-Origin", "*");
  response.headers.emplace_back("Access-Control-Expose-Headers", exposed_fields_);
  if (response.status == 204) response.body.clear();
  validate_and_code(response, arrival);
  reply.status = response.status;
  if (!response.body.empty() && !response.media_type.empty()) {
    response.headers.emplace_back("Content-Type", response.media_type);
  }
  reply.head =
      response_head(reply.status, response.headers, response.body.size(), reply.keep_alive);
  if (arrival.request.method != "HEAD") reply.body = std::move(response.body);
  return reply;
}

Reply Exchange::reply_to_upgrade(const Arrival& arrival, const Response& response) const {
  auto outcome = agree(arrival, *response.websocket);
  if (auto* refused = std::get_if<Response>(&outcome)) {
    refused->route = response.route;
    return finish(std::move(*refused), arrival);
  }
  auto& agreement = std::get<Agreement>(outcome);
  Reply reply;
  reply.status = 101;
  reply.head = std::move(agreement.head);
  reply.method = arrival.request.method;
  reply.route = response.route;
  reply.successor = {response.websocket, arrival.request, std::move(agreement.protocol)};
  return reply;
}

/// A response that cannot be sent (a field of two lines) is a failure like any other.
Reply Exchange::reply_to(const Arrival& arrival, Response response) const {
  log(response, arrival.request);
  try {
    const bool is_get = arrival.request.method == "GET";
    if (response.websocket != nullptr && arrival.upgrade.is_to_websocket && is_get) {
      return reply_to_upgrade(arrival, response);
    }
    return finish(std::move(response), arrival);
  } catch (...) {
    const Response failed = problem_of(std::current_exception(), arrival.request.path);
    log(failed, arrival.request);
    return finish(failed, arrival);
  }
}

std::variant<Reply, LongReply> Exchange::answer(Arrival arrival) const {
  Outcome outcome = made_or_problem([&] { return respond(arrival); }, arrival.request.path);
  if (auto* response = std::get_if<Response>(&outcome)) {
    return reply_to(arrival, std::move(*response));
  }
  return [this, run = std::get<LongWork>(std::move(outcome)).run, arrival = std::move(arrival)] {
    return reply_to(arrival, made_or_problem(run, arrival.request.path));
  };
}

Reply Exchange::refusal(int status, const std::string& detail) const {
  Arrival unread;
  unread.keep_alive = false;
  Response response = problem(status, detail, "");
  if (status == 503) response.headers.emplace_back("Retry-After", "1");
  Reply reply = finish(std::move(response), unread);
  reply.route = "(refused)";
  return reply;
}

}  // namespace slackwater::api::http
