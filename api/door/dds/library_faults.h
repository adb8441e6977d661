#pragma once

namespace slackwater::dds {

/// Has AddressSanitizer, in programs that are built with it, pass over what Fast DDS 2.9.1 is known
/// for: it deletes readers and writers through bases whose size is another. Faults of our own are
/// told as ever, but for deletes of a wrong size.
void excuse_library_faults() noexcept;

}  // namespace slackwater::dds
