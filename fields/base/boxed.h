#pragma once
#include <memory>
#include <utility>

namespace slackwater {

/// A value that lies on the heap and is copied with its owner: for the one large alternative of
/// a variant, which would make all of them large.
template <typename T>
class Boxed {
 public:
  Boxed() : value_(std::make_unique<T>()) {}
  Boxed(T value) : value_(std::make_unique<T>(std::move(value))) {}  // NOLINT: as if it were one
  Boxed(const Boxed& other) : Boxed(*other) {}
  Boxed(Boxed&& other) noexcept = default;
  Boxed& operator=(Boxed other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }
  ~Boxed() = default;

  /// Not of one that was moved from.
  [[nodiscard]] const T& operator*() const noexcept { return *value_; }
  [[nodiscard]] const T* operator->() const noexcept { return value_.get(); }
  operator const T&() const noexcept { return *value_; }  // NOLINT: as if it were one

 private:
  std::unique_ptr<T> value_;
};

}  // namespace slackwater
