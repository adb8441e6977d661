#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace slackwater::api {

/// A program of the operator's that hears each morning's verdict.
struct Hook {
  std::vector<std::string> command;  ///< an absolute path, then its arguments; no shell
  std::chrono::milliseconds limit{30000};
};

/// What the operator of this machine says, apart from sites, missions and plans, which others hand
/// in and which can start nothing:
///
///     hook:
///       command: [/usr/local/bin/tell-the-radio, --channel, ops]
///       time_limit_s: 30                                          # at most 600
struct OperatorConfig {
  std::optional<Hook> hook;
};

/// $SLACKWATER_OPERATOR, else `operator.yaml` in the user's configuration folder, else
/// /etc/slackwater/operator.yaml; nothing said where there is none of them.
/// @throws Error(invalid_input) for a file or a hook that others can write, or that lies in a
///         folder, or is come to by a link, that is another's; for a hook that is no absolute path;
///         Error(not_found) for one that is named and not there
[[nodiscard]] OperatorConfig operator_config();
[[nodiscard]] OperatorConfig load_operator_config(const std::filesystem::path& file);

}  // namespace slackwater::api
