#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace slackwater::api::edr {

/// The axis that several domains share when they are put into one array: all their entries,
/// ascending, each once. `add` those of each, then `settle`.
template <typename Value>
class UnionAxis {
 public:
  void add(const std::vector<Value>& values) {
    all.insert(all.end(), values.begin(), values.end());
  }
  void settle() {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  /// Where the entries of a part stand; {0} for an axis that the part does not have.
  std::vector<std::size_t> places(const std::vector<Value>& part) const {
    if (part.empty()) return {0};
    std::vector<std::size_t> found;
    found.reserve(part.size());
    for (const Value& value : part) {
      found.push_back(
          static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), value) - all.begin()));
    }
    return found;
  }
  std::size_t size() const { return std::max<std::size_t>(1, all.size()); }

  std::vector<Value> all;
};

}  // namespace slackwater::api::edr
