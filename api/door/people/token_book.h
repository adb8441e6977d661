#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/people/role.h"
#include "fields/base/config.h"
#include "fields/base/time.h"

namespace slackwater::people {

/// What one token opens.
struct Grant {
  std::string name;  ///< of the one person who has it; empty: people say their own
  Role role = Role::looks_on;
  std::string token;
  UtcTime until;
  int seats = 1;  ///< that may be taken with it at once
};

/// The tokens of a session. They are shown to nobody but whoever began it.
class TokenBook {
 public:
  /// Fresh tokens: one supervisor, four operators, sixty spectators.
  [[nodiscard]] static TokenBook drawn(UtcTime until);
  /// `people:` of an operator's file, which holds nothing else.
  /// @throws Error(invalid_input), Error(not_found)
  [[nodiscard]] static TokenBook read(const std::filesystem::path& file);
  /// `people:` of a file that holds more.
  [[nodiscard]] static TokenBook read(const Config& config);

  [[nodiscard]] const std::vector<Grant>& grants() const noexcept { return grants_; }
  /// Its place in `grants`. The time it takes does not tell how near a wrong token is.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view token) const noexcept;

 private:
  std::vector<Grant> grants_;
};

/// 128 random bits in hexadecimal.
[[nodiscard]] std::string new_token();

}  // namespace slackwater::people
