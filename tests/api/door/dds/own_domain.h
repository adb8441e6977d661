#pragma once
#include <fastrtps/attributes/LibrarySettingsAttributes.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace slackwater::tests {

/// A DDS domain that no other test of this machine is in: the first from a place that follows from
/// the process whose lock nobody holds. Below 101, where ports of Linux's own choice do not lie.
class OwnDomain {
 public:
  OwnDomain() {
    use_transports();
    constexpr int domains = 100;
    for (int i = 0; i < domains; ++i) {
      number_ = 1 + (static_cast<int>(::getpid()) * 7 + i) % domains;
      const auto lock = std::filesystem::temp_directory_path() /
                        ("slackwater-dds-domain-" + std::to_string(number_));
      lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
      if (lock_ >= 0) ::close(lock_);
    }
    throw std::runtime_error("a hundred DDS domains are in use");
  }
  ~OwnDomain() { ::close(lock_); }
  OwnDomain(const OwnDomain&) = delete;
  OwnDomain& operator=(const OwnDomain&) = delete;
  [[nodiscard]] int number() const noexcept { return number_; }

 private:
  /// Between participants of one process Fast DDS hands samples over by itself, unless told so.
  static void use_transports() {
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  }

  int number_ = 0;
  int lock_ = -1;
};

}  // namespace slackwater::tests
