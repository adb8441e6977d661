#pragma once
#include <string>

namespace slackwater::api::http {

/// What to tell the sender of bytes that are no request, or too much of one.
struct Refusal {
  int status = 400;
  std::string detail;
};

}  // namespace slackwater::api::http
