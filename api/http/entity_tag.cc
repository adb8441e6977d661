#include "api/http/entity_tag.h"

#include "api/http/field_list.h"
#include "fields/base/sha256.h"

namespace slackwater::api::http {
namespace {

constexpr std::size_t digits = 32;

std::string_view without_weakness(std::string_view tag) {
  return tag.starts_with("W/") ? tag.substr(2) : tag;
}

}  // namespace

std::string entity_tag(std::string_view body, std::string_view coding) {
  std::string tag = "\"" + sha256_of_text(body).substr(0, digits);
  if (!coding.empty()) tag.append("-").append(coding);
  return tag + "\"";
}

bool matches_tag(std::string_view if_none_match, std::string_view tag) {
  bool matches = false;
  for_each_item(if_none_match, [&](std::string_view item) {
    matches = matches || item == "*" || without_weakness(item) == without_weakness(tag);
  });
  return matches;
}

}  // namespace slackwater::api::http
