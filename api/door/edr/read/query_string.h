#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slackwater::api::edr {

constexpr std::size_t max_query_bytes = std::size_t{256} * 1024;
constexpr std::size_t max_query_parameters = 64;

/// The parameters of a query, decoded, in the order in which they came; no key stands twice.
class QueryString {
 public:
  /// Reads "coords=POINT(2%2057)&z=10" ('+' is a blank; empty pieces, as in "a=1&&b=2", are passed
  /// over; "a" alone has an empty value). Throws Error(usage) for a key that repeats, an empty key,
  /// a broken percent code, a NUL, and beyond the limits above.
  [[nodiscard]] static QueryString parse(std::string_view query);

  /// The value of a key, nothing where the key is absent. The view lives as long as this object.
  [[nodiscard]] std::optional<std::string_view> find(std::string_view key) const noexcept;
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& all() const noexcept {
    return all_;
  }

 private:
  std::vector<std::pair<std::string, std::string>> all_;
};

}  // namespace slackwater::api::edr
