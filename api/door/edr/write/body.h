#pragma once
#include <string>
#include <utility>
#include <vector>

#include "api/door/edr/sample/answer.h"
#include "api/door/edr/write/content.h"

namespace slackwater::api::edr {

/// An answer in one of its formats, ready to be sent.
struct Body {
  std::string media_type;
  std::string bytes;
  /// Beside Content-Type: provenance, where the format itself has no place for it.
  std::vector<std::pair<std::string, std::string>> headers;
};

/// The formats of answers, the default first.
[[nodiscard]] const std::vector<Format>& answer_formats();

/// Writes an answer in one of `answer_formats`; throws what its format throws.
[[nodiscard]] Body write_answer(const Answer& answer, Format format);

}  // namespace slackwater::api::edr
