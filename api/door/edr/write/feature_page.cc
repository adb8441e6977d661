#include "api/door/edr/write/feature_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fields/base/encode/percent.h"

namespace slackwater::api::edr {
namespace {

using nlohmann::json;

/// The list as it was asked, with one parameter more where `value` is not empty.
std::string address(const std::string& href, const FeatureFilter& filter, std::string_view key,
                    const std::string& value) {
  std::string query;
  for (const auto& [name, asked] : filter.asked()) {
    query += (query.empty() ? "?" : "&") + percent_encoded(name) + "=" + percent_encoded(asked);
  }
  if (!value.empty()) query += (query.empty() ? "?" : "&") + std::string(key) + "=" + value;
  return href + query;
}

}  // namespace

json feature_page(const std::string& href, const FeatureFilter& filter, json all_taken) {
  const std::size_t matched = all_taken.size();
  const std::size_t first = std::min(filter.offset(), matched);
  const std::size_t last = std::min(first + filter.limit(), matched);
  json features = json::array();
  for (std::size_t i = first; i < last; ++i) features.push_back(std::move(all_taken[i]));
  const auto link = [&](const char* rel, const char* type, std::string_view key,
                        const std::string& value) {
    return json{{"href", address(href, filter, key, value)}, {"rel", rel}, {"type", type}};
  };
  const std::string offset = filter.offset() == 0 ? "" : std::to_string(filter.offset());
  json links = json::array({link("self", "application/geo+json", "offset", offset),
                            link("alternate", "application/json", "f", "json"),
                            link("alternate", "text/html", "f", "html")});
  if (last < matched)
    links.push_back(link("next", "application/geo+json", "offset", std::to_string(last)));
  return {{"type", "FeatureCollection"},
          {"numberMatched", matched},
          {"numberReturned", features.size()},
          {"links", std::move(links)},
          {"features", std::move(features)}};
}

}  // namespace slackwater::api::edr
