#include "api/door/http/entity_tag.h"

#include "api/door/http/field_list.h"
#include "fields/base/encode/sha256.h"

namespace slackwater::api::http {
namespace {

constexpr std::size_t digits = 32;

std::string_view without_weakness(std::string_view tag) {
  return tag.starts_with("W/") ? tag.substr(2) : tag;
}

}  // namespace

std::string entity_tag(std::string_view body) {
  return "\"" + sha256_of_text(body).substr(0, digits) + "\"";
}

std::string coded_tag(std::string_view tag, std::string_view coding) {
  std::string coded(tag.substr(0, tag.size() - (tag.ends_with('"') ? 1 : 0)));
  return coded.append("-").append(coding).append("\"");
}

bool matches_tag(std::string_view if_none_match, std::string_view tag) {
  bool matches = false;
  for_each_item(if_none_match, [&](std::string_view item) {
    matches = matches || item == "*" || without_weakness(item) == without_weakness(tag);
  });
  return matches;
}

}  // namespace slackwater::api::http
