#pragma once
#include <string>

namespace slackwater::dds {

/// @param address  IPv4
/// @throws Error(invalid_input) where no network card of this machine has it, with those that have
///         one
void expect_network_card(const std::string& address);

}  // namespace slackwater::dds
