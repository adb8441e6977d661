#pragma once
#include <optional>
#include <string>

#include "api/ask/windows/fly_windows.h"
#include "api/ask/windows/windows_words.h"
#include "api/door/cli/command.h"

namespace slackwater::api {

/// What `windows` and `report` take: the words of the question, and what becomes of the answer.
struct WindowsArguments : WindowsWords {
  bool verdict_exit = false;
  std::string fly, fly_every = "1h";
};

void add_windows_options(CLI::App& command, WindowsArguments& arguments);

/// @throws Error(usage) for what cannot be read
[[nodiscard]] WindowsQuestion windows_question(const WindowsArguments& arguments,
                                               const Context& context);
/// Nothing where no flights were asked for. @throws Error(usage)
[[nodiscard]] std::optional<FlyWindows> flights_wanted(const WindowsArguments& arguments);

/// 10 for go, 11 for marginal, 12 for no-go.
[[nodiscard]] int exit_code_of(twin::Verdict verdict) noexcept;

}  // namespace slackwater::api
