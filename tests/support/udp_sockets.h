#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace slackwater::tests {

/// Where a UDP socket of IPv4 is bound.
struct UdpSocket {
  std::string address;  ///< "127.0.0.1"
  std::uint16_t port = 0;
};

/// Those of a process ("self", or its number), as the kernel lists them.
[[nodiscard]] inline std::vector<UdpSocket> udp_sockets_of(const std::string& process) {
  std::set<std::string> inodes;
  for (const auto& file : std::filesystem::directory_iterator("/proc/" + process + "/fd")) {
    std::error_code closed_since;
    const std::string to = std::filesystem::read_symlink(file, closed_since);
    if (to.starts_with("socket:[")) inodes.insert(to.substr(8, to.size() - 9));
  }
  std::vector<UdpSocket> sockets;
  std::ifstream table("/proc/" + process + "/net/udp");
  for (std::string line; std::getline(table, line);) {
    std::istringstream row(line);
    std::string slot, local, inode;
    row >> slot >> local;
    for (int i = 0; i < 8; ++i) row >> inode;
    if (!inodes.contains(inode)) continue;
    const auto octet = [&](unsigned i) {  // the lowest first
      return std::to_string(std::stoul(local.substr(6 - 2 * i, 2), nullptr, 16));
    };
    sockets.push_back({octet(0) + "." + octet(1) + "." + octet(2) + "." + octet(3),
                       static_cast<std::uint16_t>(std::stoul(local.substr(9), nullptr, 16))});
  }
  return sockets;
}

}  // namespace slackwater::tests
