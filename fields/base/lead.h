#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "fields/base/check.h"

namespace slackwater {

/// How a quantity is led, once or several times, away from what it is by itself: to a value that
/// somebody sets, or back, each time in a straight line over a while and from where it then is.
///
///   x(t) = own x_0(t) + set,  with s = (t - from)/over held within 0 and 1, for each leading
///   own <- own + s (o - own),  set <- set + s (v - set);  o = 0 to a value v;  o = 1, v = 0 back
///
/// What is between is so that x is continuous, and x_0 may change meanwhile.
template <typename Value>
class Lead {
 public:
  /// @param to      nothing: back to what it is by itself
  /// @param from_s  not before the last one's
  /// @param over_s  above 0
  /// @throws ContractViolation
  void lead(std::optional<Value> to, double from_s, double over_s) {
    expects(over_s > 0, "a quantity is led over a while");
    expects(leadings_.empty() || from_s >= leadings_.back().from_s, "leadings come in order");
    leadings_.push_back({to, from_s, over_s});
  }

  /// Of a quantity: x = own x_0 + set.
  struct Share {
    double own = 1;
    Value set{};
  };
  /// What came before the last leading that is over at `t_s` is nothing any more. No allocation.
  [[nodiscard]] Share at(double t_s) const noexcept {
    auto first = leadings_.begin();
    for (auto one = leadings_.begin(); one != leadings_.end(); ++one)
      if (t_s >= one->from_s + one->over_s) first = one;
    Share share;
    for (auto one = first; one != leadings_.end(); ++one) {
      const double s = std::clamp((t_s - one->from_s) / one->over_s, 0.0, 1.0);
      share.own += s * ((one->to ? 0.0 : 1.0) - share.own);
      share.set = share.set + s * (one->to.value_or(Value{}) - share.set);
    }
    return share;
  }
  /// @param by_itself  counts for nothing, a number or none, once it is led away altogether
  [[nodiscard]] Value of(const Value& by_itself, double t_s) const noexcept {
    if (leadings_.empty()) return by_itself;
    const Share share = at(t_s);
    if (share.own == 0) return share.set;
    return share.own == 1 ? by_itself : share.own * by_itself + share.set;
  }
  [[nodiscard]] bool is_none() const noexcept { return leadings_.empty(); }

 private:
  struct Leading {
    std::optional<Value> to;
    double from_s = 0;
    double over_s = 1;
  };
  std::vector<Leading> leadings_;
};

}  // namespace slackwater
