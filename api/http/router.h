#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "api/http/message.h"
#include "api/http/problem.h"

namespace slackwater::api::http {

/// The values of the {names} of a pattern, decoded.
class PathParameters {
 public:
  void add(std::string name, std::string value);
  /// A name that the pattern does not have is a ContractViolation.
  [[nodiscard]] const std::string& at(std::string_view name) const;

 private:
  std::vector<std::pair<std::string, std::string>> values_;
};

using RouteHandler = std::function<Response(const Request&, const PathParameters&)>;

/// A field of responses by which a router tells the server the label of the route, for the metrics;
/// the server takes it out again.
constexpr std::string_view route_field = "Slackwater-Route";

/// What a router throws where a handler failed on something that the log should know (500, 503).
class RouteFailure : public std::runtime_error {
 public:
  RouteFailure(std::string route, Failure failure)
      : std::runtime_error(failure.for_the_log),
        route_(std::move(route)),
        failure_(std::move(failure)) {}
  [[nodiscard]] const std::string& route() const noexcept { return route_; }
  [[nodiscard]] const Failure& failure() const noexcept { return failure_; }

 private:
  std::string route_;
  Failure failure_;
};

/// Sends a request to the handler of its method and path. Patterns are "/", "/collections",
/// "/collections/{collection}/position"; where several fit, the one whose fixed segments come first
/// wins. A slash at the end is tolerated. Segments are decoded once, after the path was split;
/// ".", "..", and segments that decode to a slash or a control character are refused with 400.
/// Fill it first, then copy it into a `Handler`; thread-safe from then on.
class Router {
 public:
  /// HEAD is served by GET. Two handlers for one method and pattern are a ContractViolation.
  void add(std::string method, std::string_view pattern, RouteHandler handler);
  void add(std::string method, std::string_view pattern, Handler handler);
  /// 404 says what exists nearby, 405 what is allowed. An `Error` of the handler that is the
  /// client's to mend becomes its problem document, anything else a `RouteFailure`.
  [[nodiscard]] Response operator()(const Request& request) const;
  /// The patterns, each once: the labels of the metrics.
  [[nodiscard]] std::vector<std::string> labels() const;

 private:
  struct Route {
    std::string method;
    std::string pattern;
    std::vector<std::string> segments;
    RouteHandler handler;
  };
  using Segments = std::vector<std::string>;
  [[nodiscard]] static Response called(const Route& route, const Segments& path,
                                       const Request& request);
  [[nodiscard]] std::vector<const Route*> fitting(const Segments& path) const;
  [[nodiscard]] std::string nearby(const Segments& path) const;

  std::vector<Route> routes_;
};

}  // namespace slackwater::api::http
