#pragma once
#include <functional>
#include <string>
#include <string_view>

namespace slackwater {

// What a child tells its parent through a pipe: a letter, the length in eight bytes, the bytes. 's'
// is a share of the work, 'a' the answer, which comes last.
// Only sources of this folder include this.

/// @return whether it went out
bool send_share(int descriptor, int permille);
bool send_answer(int descriptor, std::string_view answer);

/// What the child told so far.
struct Told {
  std::string bytes;  ///< that are no whole frame yet
  std::string answer;
  bool is_answered = false;

  /// What it says behind its answer counts for nothing, nor does what is no share.
  /// @param on_share  hears shares, in [0, 1]; may be empty
  void take(std::string_view more, const std::function<void(double)>& on_share);
};

}  // namespace slackwater
