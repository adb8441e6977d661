#include "api/door/cli/dds_options.h"

#include <CLI/CLI.hpp>

namespace slackwater::api {

std::optional<dds::DomainSettings> DdsChoice::settings() const {
  if (!domain) return std::nullopt;
  dds::DomainSettings settings;
  settings.domain = *domain;
  settings.is_loopback_only = loopback;
  settings.interface = interface;
  settings.is_udp_only = udp_only;
  return settings;
}

void add_dds_options(CLI::App& command, DdsChoice& choice, const std::string& domain_help) {
  CLI::Option* const domain = command.add_option("--dds-domain", choice.domain, domain_help);
  CLI::Option* const loopback =
      command.add_flag("--loopback", choice.loopback, "DDS on this machine alone");
  command
      .add_option("--interface", choice.interface,
                  "DDS at the network card with this address alone, as in 10.1.0.5")
      ->needs(domain)
      ->excludes(loopback);
  command.add_flag("--udp-only", choice.udp_only, "DDS without shared memory");
}

}  // namespace slackwater::api
