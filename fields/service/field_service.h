#pragma once
#include <memory>

#include "fields/service/field.h"
#include "fields/service/published.h"

namespace slackwater {

/// The forecast in force at one site, for many readers: ask once for the field, sample it as long
/// as the answer should be of one piece. A new run is published by swapping one pointer; nobody
/// waits, and a request keeps the field it began with.
class FieldService {
 public:
  FieldService() = default;
  explicit FieldService(std::shared_ptr<const Field> field) : published_(std::move(field)) {}

  /// Null before the first forecast. Wait-free.
  [[nodiscard]] std::shared_ptr<const Field> field() const noexcept { return published_.load(); }
  void publish(std::shared_ptr<const Field> field) { published_.store(std::move(field)); }

 private:
  Published<Field> published_;
};

}  // namespace slackwater
