#include "api/door/dds/library_faults.h"

#if defined(__SANITIZE_ADDRESS__)
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name that AddressSanitizer asks for
extern "C" const char* __asan_default_options();
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() { return "new_delete_type_mismatch=0"; }
#endif

namespace slackwater::dds {

// To be called is enough: the linker then takes the above out of its library.
void excuse_library_faults() noexcept {}

}  // namespace slackwater::dds
