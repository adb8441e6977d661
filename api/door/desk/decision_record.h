#pragma once
#include <mutex>
#include <string>

#include "api/door/desk/site_answers.h"
#include "api/door/http/message.h"

namespace slackwater::api::desk {

/// Decisions that people sign at the page, filed as `slackwater decide` files them.
///
///     {"task": "blade_scan", "turbine": "A01", "start": "2025-03-14T06:30Z", "decided": "go",
///      "by": "A. Name", "note": "swell dies by six", "at": TIME,
///      "forecast": SHA256, "in_place_of": 7}
///
/// Task, start, decided ("go" or "no_go") and by have to be there. "forecast" is the one that was
/// looked at, and "in_place_of" the record that was seen to count for this start, null where none
/// was: where either is another by now, nothing is filed, and the answer is 409.
///
/// Thread-safe: of two at once the second meets the first.
class DecisionRecord {
 public:
  explicit DecisionRecord(Answers from) : from_(std::move(from)) {}

  /// @return 201 with the decision as `decisions_answer` has it; or 409, one sentence
  /// @throws Error(usage), Error(not_found) as `decision_made`, nothing filed
  [[nodiscard]] http::Response file(const std::string& site, const std::string& body);

 private:
  Answers from_;
  std::mutex mutex_;
};

}  // namespace slackwater::api::desk
