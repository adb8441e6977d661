#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/http/message.h"

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

using RouteHandler = std::function<Outcome(const Request&, const PathParameters&)>;

/// Sends a request to the handler of its method and path. Patterns are "/", "/shelves",
/// "/shelves/{shelf}/books"; where several fit, the one whose fixed segments come first wins. A
/// slash at the end is tolerated. Segments are decoded once, after the path was split; ".", "..",
/// and segments that decode to a slash or a control character are refused with 400. Fill it first,
/// then copy it into a `Handler`; thread-safe from then on.
class Router {
 public:
  /// HEAD is served by GET. Two handlers for one method and pattern are a ContractViolation.
  void add(std::string method, std::string_view pattern, RouteHandler handler);
  void add(std::string method, std::string_view pattern, Handler handler);
  /// 404 says what exists nearby, 405 what is allowed; what a handler throws, at once
  /// or in its long work, becomes a problem document. The response of a handler carries
  /// the pattern as its route.
  [[nodiscard]] Outcome operator()(const Request& request) const;
  /// "GET, HEAD, OPTIONS": what a path is served by, as the Allow field has it; empty where there
  /// is nothing.
  [[nodiscard]] std::string methods_at(const std::string& path) const;
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
  [[nodiscard]] static Outcome called(const Route& route, const Segments& path,
                                      const Request& request);
  [[nodiscard]] static std::string methods_of(const std::vector<const Route*>& routes);
  [[nodiscard]] std::vector<const Route*> fitting(const Segments& path) const;
  [[nodiscard]] std::string nearby(const Segments& path) const;

  std::vector<Route> routes_;
};

}  // namespace slackwater::api::http
