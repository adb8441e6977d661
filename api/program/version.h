#pragma once
#include <string>

namespace slackwater::api {

/// Version of the program, with the commit it was built from where that was known.
[[nodiscard]] std::string code_version();

}  // namespace slackwater::api
