#include "api/door/dds/message/names.h"

#include <optional>

#include "fields/base/check.h"

namespace slackwater::dds {
namespace {

std::string prefixed(std::string_view prefix, std::string_view ros_name, std::string_view ending) {
  expects(ros_name.starts_with('/'), "a fully qualified name of ROS");
  return std::string(prefix) + std::string(ros_name) + std::string(ending);
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string dds_type(std::string_view ros_type) {
  const std::size_t package = ros_type.find('/');
  const std::size_t name = ros_type.rfind('/');
  expects(package != std::string_view::npos && name > package, "a type of ROS: package/msg/Name");
  return std::string(ros_type.substr(0, package)) +
         "::" + std::string(ros_type.substr(package + 1, name - package - 1)) +
         "::dds_::" + std::string(ros_type.substr(name + 1)) + "_";
}

std::string dds_topic(std::string_view ros_topic) { return prefixed("rt", ros_topic, ""); }
std::string request_topic(std::string_view service) { return prefixed("rq", service, "Request"); }
std::string reply_topic(std::string_view service) { return prefixed("rr", service, "Reply"); }
std::string request_type(std::string_view ros_type) {
  return dds_type(std::string(ros_type) + "_Request");
}
std::string reply_type(std::string_view ros_type) {
  return dds_type(std::string(ros_type) + "_Response");
}

std::string ros_topic_of(const std::string& topic) {
  const auto between = [&](std::string_view prefix, std::string_view ending,
                           std::string_view kind) -> std::optional<std::string> {
    if (!topic.starts_with(prefix) || !topic.ends_with(ending) ||
        topic.size() < prefix.size() + ending.size())
      return std::nullopt;
    return topic.substr(2, topic.size() - 2 - ending.size()) + std::string(kind);
  };
  if (const auto name = between("rt/", "", "")) return *name;
  if (const auto name = between("rq/", "Request", " (requests)")) return *name;
  if (const auto name = between("rr/", "Reply", " (replies)")) return *name;
  return topic;
}

std::string ros_type_of(const std::string& type) {
  constexpr std::string_view inside = "::dds_::";
  const std::size_t at = type.find(inside), package = type.find("::");
  if (at == std::string::npos || package >= at || !type.ends_with('_')) return type;
  const std::size_t name = at + inside.size();
  return type.substr(0, package) + "/" + type.substr(package + 2, at - package - 2) + "/" +
         type.substr(name, type.size() - name - 1);
}

std::string ros_token(std::string_view name) {
  std::string token;
  for (const char c : name) {
    const char taken = is_letter(c) || is_digit(c) ? c : '_';
    if (taken == '_' && (token.empty() || token.back() == '_')) continue;
    token += taken;
  }
  while (token.ends_with('_')) token.pop_back();
  if (token.empty() || is_digit(token.front())) token.insert(0, "n");
  return token;
}

}  // namespace slackwater::dds
