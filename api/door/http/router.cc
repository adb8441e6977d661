#include "api/door/http/router.h"

#include <algorithm>
#include <optional>
#include <set>

#include "api/door/http/problem.h"
#include "fields/base/check.h"
#include "fields/base/encode/percent.h"
#include "fields/base/text.h"

namespace slackwater::api::http {
namespace {

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> segments;
  // Clients that are given the service's address with a slash at its end ask for //shelves.
  path.remove_prefix(std::min(path.find_first_not_of('/'), path.size()));
  if (path.ends_with('/')) path.remove_suffix(1);
  while (!path.empty()) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    segments.emplace_back(path.substr(0, slash));
    if (slash + 1 == path.size()) segments.emplace_back();  // "a//": an empty segment
    path.remove_prefix(std::min(slash + 1, path.size()));
  }
  return segments;
}

bool is_parameter(const std::string& segment) { return segment.starts_with('{'); }

bool is_hostile(const std::string& segment) {
  return segment == "." || segment == ".." ||
         std::any_of(segment.begin(), segment.end(), [](char c) {
           return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
         });
}

/// The decoded segments; nothing where one of them is malformed or hostile.
std::optional<std::vector<std::string>> decoded_segments(const std::string& path) {
  std::vector<std::string> segments = split(path);
  for (std::string& segment : segments) {
    auto decoded = percent_decoded(segment);
    if (!decoded || is_hostile(*decoded)) return std::nullopt;
    segment = std::move(*decoded);
  }
  return segments;
}

/// How many leading segments of a path a pattern agrees with.
std::size_t common_length(const std::vector<std::string>& pattern,
                          const std::vector<std::string>& path) {
  std::size_t n = 0;
  while (n < pattern.size() && n < path.size() &&
         (pattern[n] == path[n] || (is_parameter(pattern[n]) && !path[n].empty()))) {
    ++n;
  }
  return n;
}

std::string path_of(const std::vector<std::string>& segments, std::size_t count) {
  std::string path;
  for (std::size_t i = 0; i < count; ++i) path += "/" + segments[i];
  return path.empty() ? "/" : path;
}

}  // namespace

void PathParameters::add(std::string name, std::string value) {
  values_.emplace_back(std::move(name), std::move(value));
}

const std::string& PathParameters::at(std::string_view name) const {
  const auto found = std::find_if(values_.begin(), values_.end(),
                                  [&](const auto& value) { return value.first == name; });
  expects(found != values_.end(), "the pattern of the route has this parameter");
  return found->second;
}

void Router::add(std::string method, std::string_view pattern, RouteHandler handler) {
  expects(pattern.starts_with('/'), "a pattern starts with '/'");
  for (const Route& route : routes_) {
    expects(route.method != method || route.pattern != pattern, "one handler a method and pattern");
  }
  routes_.push_back({std::move(method), std::string(pattern), split(pattern), std::move(handler)});
}

void Router::add(std::string method, std::string_view pattern, Handler handler) {
  add(std::move(method), pattern,
      RouteHandler([handler = std::move(handler)](const Request& request, const PathParameters&) {
        return handler(request);
      }));
}

std::vector<const Router::Route*> Router::fitting(const Segments& path) const {
  std::vector<const Route*> routes;
  for (const Route& route : routes_) {
    if (route.segments.size() == path.size() &&
        common_length(route.segments, path) == path.size()) {
      routes.push_back(&route);
    }
  }
  // Fixed segments before parameters, from the left.
  std::stable_sort(routes.begin(), routes.end(), [](const Route* a, const Route* b) {
    return std::lexicographical_compare(
        a->segments.begin(), a->segments.end(), b->segments.begin(), b->segments.end(),
        [](const auto& x, const auto& y) { return !is_parameter(x) && is_parameter(y); });
  });
  return routes;
}

std::string Router::nearby(const Segments& path) const {
  std::size_t depth = 0;
  for (const Route& route : routes_) {
    depth = std::max(depth, common_length(route.segments, path));
  }
  std::set<std::string> names;
  for (const Route& route : routes_) {
    if (common_length(route.segments, path) != depth) continue;
    names.insert(path_of(route.segments, std::min(depth + 1, route.segments.size())));
  }
  return joined(names, ", ");
}

Outcome Router::called(const Route& route, const Segments& path, const Request& request) {
  PathParameters parameters;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::string& name = route.segments[i];
    if (is_parameter(name)) parameters.add(name.substr(1, name.size() - 2), path[i]);
  }
  Outcome outcome =
      made_or_problem([&] { return route.handler(request, parameters); }, request.path);
  if (auto* response = std::get_if<Response>(&outcome)) {
    response->route = route.pattern;
    return outcome;
  }
  return LongWork{[run = std::get<LongWork>(std::move(outcome)).run, route = route.pattern,
                   path = request.path] {
    Response response = made_or_problem(run, path);
    response.route = route;
    return response;
  }};
}

std::string Router::methods_of(const std::vector<const Route*>& routes) {
  std::string methods;
  for (const Route* route : routes)
    methods += route->method == "GET" ? "GET, HEAD, " : route->method + ", ";
  return methods + "OPTIONS";
}

std::string Router::methods_at(const std::string& path) const {
  const auto segments = decoded_segments(path);
  if (!segments) return {};
  const auto routes = fitting(*segments);
  return routes.empty() ? std::string() : methods_of(routes);
}

Outcome Router::operator()(const Request& request) const {
  const auto path = decoded_segments(request.path);
  if (!path) {
    return problem(400,
                   "A segment of the path is malformed: '%' wants two hexadecimal digits, and "
                   "'.', '..', slashes and control characters cannot be part of a name.",
                   request.path);
  }
  const auto routes = fitting(*path);
  if (routes.empty()) {
    return problem(404, "There is nothing at this path; nearby are: " + nearby(*path) + ".",
                   request.path);
  }
  for (const Route* route : routes)
    if (route->method == (request.method == "HEAD" ? "GET" : request.method))
      return called(*route, *path, request);
  const std::string allowed = methods_of(routes);
  Response refused = problem(
      405, "The method " + request.method + " is not served here; use one of " + allowed + ".",
      request.path);
  refused.headers.emplace_back("Allow", allowed);
  return refused;
}

std::vector<std::string> Router::labels() const {
  std::set<std::string> labels;
  for (const Route& route : routes_) labels.insert(route.pattern);
  return {labels.begin(), labels.end()};
}

}  // namespace slackwater::api::http
