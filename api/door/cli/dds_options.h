#pragma once
#include <optional>
#include <string>

#include "api/door/dds/participant.h"

namespace CLI {
class App;
}

namespace slackwater::api {

/// Where on DDS a command is, as it was asked for.
struct DdsChoice {
  std::optional<int> domain;  ///< empty: nothing is on DDS
  bool loopback = false;
  std::string interface;
  bool udp_only = false;

  /// Empty: nothing is on DDS.
  [[nodiscard]] std::optional<dds::DomainSettings> settings() const;
};

/// `--dds-domain` with its help, `--loopback`, `--interface`, `--udp-only`.
void add_dds_options(CLI::App& command, DdsChoice& choice, const std::string& domain_help);

}  // namespace slackwater::api
