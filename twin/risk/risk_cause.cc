#include "twin/risk/risk_cause.h"

#include <array>
#include <string>

#include "fields/base/error.h"

namespace slackwater::twin {
namespace {

struct Word {
  std::string_view name;
  std::string_view meaning;
};
constexpr std::array<Word, risk_cause_count> words{
    {{"limit", "a limit is exceeded at work"},
     {"energy", "the reserve is touched or the battery is empty"},
     {"tether", "the tether parts or is fouled"},
     {"station", "the water or the wind is faster than the vehicle"},
     {"collision", "it strikes something or comes too near"},
     {"recovery", "it is not back when its time is over"},
     {"work", "it is back, and the work is not done or not done well"},
     {"unseen", "the inspection sees less than is asked"}}};

}  // namespace

std::string_view name_of(RiskCause cause) noexcept {
  return words[static_cast<std::size_t>(cause)].name;
}

std::string_view meaning_of(RiskCause cause) noexcept {
  return words[static_cast<std::size_t>(cause)].meaning;
}

RiskCause parse_risk_cause(std::string_view text) {
  std::string known;
  for (std::size_t i = 0; i < risk_cause_count; ++i) {
    if (words[i].name == text) return static_cast<RiskCause>(i);
    known += (known.empty() ? "" : ", ") + std::string(words[i].name);
  }
  throw Error(ErrorKind::invalid_input,
              "found " + std::string(text) + ", expected one of " + known);
}

}  // namespace slackwater::twin
