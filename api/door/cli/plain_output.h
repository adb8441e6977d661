#pragma once
#include <cstdio>

namespace slackwater::api {

/// From now on all that this process prints to stdout and stderr is plain text (`PlainText`): names
/// in files of strangers cannot colour, move or turn what a terminal shows, wherever they are
/// printed. Call it once, before anything is printed.
void print_plain_text();

/// stderr without that, for what we draw on a terminal ourselves.
[[nodiscard]] std::FILE* bare_stderr();

}  // namespace slackwater::api
