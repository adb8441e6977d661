#pragma once
#include "fields/base/error.h"
#include "ingest/apart/packed.h"
#include "ingest/apart/read_apart.h"

namespace slackwater::ingest {

// Only sources of this folder include this.

/// What `read` makes of a file, in a confined process of its own.
/// @param expect_whole  throws where the value is not what `read` promises: its process may have
///                      been taken over
template <typename T, typename Read, typename Expect>
[[nodiscard]] T value_apart(const std::filesystem::path& file, const Read& read,
                            const Expect& expect_whole) {
  const std::string bytes =
      read_apart(file, allowance_for(file), [&](const TellShare&) { return packed<T>(read()); });
  return with_context(context_of_told(file), [&] {
    T value = unpacked<T>(bytes);
    expect_whole(value);
    return value;
  });
}

}  // namespace slackwater::ingest
