#include "api/door/http/framing.h"

#include <algorithm>
#include <string>

#include "api/door/http/field_list.h"
#include "api/door/http/letters.h"
#include "fields/base/text.h"

namespace slackwater::api::http {
namespace {

using boost::beast::http::field;
using boost::beast::http::verb;
using Head = boost::beast::http::request_header<>;

std::string_view view_of(boost::string_view text) { return {text.data(), text.size()}; }

/// Of what was found, for its sender.
std::string_view shortened(std::string_view text) { return text.substr(0, 40); }

/// http://host:port, and what comes behind it.
bool is_absolute(std::string_view target) {
  const std::size_t colon = target.find("://");
  if (colon == std::string_view::npos || colon == 0) return false;
  const std::string_view scheme = target.substr(0, colon);
  std::string_view host = target.substr(colon + 3);
  host = host.substr(0, host.find_first_of("/?"));
  return std::all_of(scheme.begin(), scheme.end(), letters::is_letter) && !host.empty() &&
         std::all_of(host.begin(), host.end(), letters::is_of_host);
}

std::optional<Refusal> target_fault(const Head& head) {
  const std::string_view target = view_of(head.target());
  if (target.starts_with('/') || target == "*" || is_absolute(target)) return std::nullopt;
  return Refusal{400, formatted("The target of this request is '{}'; it begins with '/', or with "
                                "a scheme and '://'.",
                                shortened(target))};
}

std::optional<Refusal> field_fault(const Head& head, std::size_t field_bytes) {
  for (const auto& one : head)
    if (one.name_string().size() + one.value().size() > field_bytes)
      return Refusal{431, formatted("A field of a header holds at most {} bytes; '{}' has {}.",
                                    field_bytes, shortened(view_of(one.name_string())),
                                    one.name_string().size() + one.value().size())};
  return std::nullopt;
}

std::optional<Refusal> coding_fault(const Head& head) {
  if (head.count(field::transfer_encoding) == 0) return std::nullopt;
  if (head.version() < 11)
    return Refusal{400, "Transfer-Encoding is not of HTTP/1.0; send Content-Length."};
  if (head.count(field::content_length) > 0)
    return Refusal{400, "Content-Length and Transfer-Encoding exclude each other; send one."};
  std::size_t chunked = 0, items = 0;
  const auto range = head.equal_range(field::transfer_encoding);
  for (auto one = range.first; one != range.second; ++one)
    for_each_item(view_of(one->value()), [&](std::string_view item) {
      ++items;
      chunked += equal_ignoring_case(item, "chunked") ? 1 : 0;
    });
  if (items > chunked)
    return Refusal{501, formatted("Transfer-Encoding is '{}' here; the only coding that is read "
                                  "is chunked, alone.",
                                  shortened(view_of(head[field::transfer_encoding])))};
  const bool is_plain_word =
      head.count(field::transfer_encoding) == 1 &&
      equal_ignoring_case(view_of(head[field::transfer_encoding]), "chunked");
  if (!is_plain_word)
    return Refusal{400, formatted("Transfer-Encoding is '{}' here, {} times; chunked is said once, "
                                  "and alone.",
                                  shortened(view_of(head[field::transfer_encoding])), items)};
  return std::nullopt;
}

/// Beast takes `5, 5` for a number.
std::optional<Refusal> length_fault(const Head& head) {
  const std::size_t count = head.count(field::content_length);
  if (count > 1)
    return Refusal{400, formatted("Content-Length is there {} times; send it once.", count)};
  const std::string_view length = view_of(head[field::content_length]);
  if (length.find_first_not_of("0123456789") != std::string_view::npos)
    return Refusal{400, formatted("Content-Length is '{}' here; it is one whole number, and "
                                  "nothing else.",
                                  shortened(length))};
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> framing_fault(const Head& head, std::size_t field_bytes) {
  if (head.method() == verb::connect)
    return Refusal{501, "This server is no proxy: CONNECT is not served."};
  if (auto fault = target_fault(head)) return fault;
  if (auto fault = field_fault(head, field_bytes)) return fault;
  if (auto fault = length_fault(head)) return fault;
  if (auto fault = coding_fault(head)) return fault;
  return std::nullopt;
}

}  // namespace slackwater::api::http
