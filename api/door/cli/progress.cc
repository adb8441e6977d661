#include "api/door/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "api/door/cli/plain_output.h"

namespace slackwater::api {

ProgressBar::ProgressBar(std::string title, bool quiet)
    : title_(std::move(title)),
      on_(!quiet && ::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fprintf(bare_stderr(), "\r\033[K");
}

void ProgressBar::update(double share) {
  if (!on_) return;
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const int percent = static_cast<int>(100 * std::clamp(share, 0.0, 1.0));
  if (elapsed < 1.0 || percent == last_percent_) return;
  last_percent_ = percent;
  drawn_ = true;
  constexpr int width = 30;
  const int full = percent * width / 100;
  const double left = share > 0.01 ? elapsed * (1 - share) / share : 0;
  std::fprintf(bare_stderr(), "\r\033[K%s [%.*s%*s] %3d %%  %.0f s left", title_.c_str(), full,
               "##############################", width - full, "", percent, left);
  std::fflush(bare_stderr());
}

}  // namespace slackwater::api
