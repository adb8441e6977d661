#include "tests/fuzz/fuzz_case.h"

#include <cstdio>
#include <cstdlib>

namespace slackwater::fuzz {

void fail(std::string_view what) noexcept {
  std::fprintf(stderr, "FINDING: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

}  // namespace slackwater::fuzz

/// HDF5 1.10 forgets blocks when it refuses a damaged file (found by netcdf_fuzz). Leaks of our own are findings.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier): the name LSan asks for
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\nleak:libnetcdf\n"; }
