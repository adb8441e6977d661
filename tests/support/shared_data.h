#pragma once
#include <filesystem>
#include <optional>

namespace slackwater::tests {

/// The folder of real data: $SLACKWATER_SHARED, else ../shared beside the checkout; nothing where
/// it is absent.
[[nodiscard]] std::optional<std::filesystem::path> shared_folder();

/// The root of the checkout.
[[nodiscard]] std::filesystem::path source_folder();

}  // namespace slackwater::tests

/// Skips the test, with a clear message, where the real data are absent.
#define SLACKWATER_NEEDS_SHARED(folder)                                                       \
  const auto folder##_found = ::slackwater::tests::shared_folder();                           \
  if (!folder##_found) GTEST_SKIP() << "no real data: set SLACKWATER_SHARED to their folder"; \
  const std::filesystem::path folder = *folder##_found
