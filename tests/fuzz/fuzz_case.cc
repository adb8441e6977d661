#include "tests/fuzz/fuzz_case.h"

#include <cstdio>
#include <cstdlib>

namespace slackwater::fuzz {

void fail(std::string_view what) noexcept {
  std::fprintf(stderr, "FINDING: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

}  // namespace slackwater::fuzz
