#include "twin/risk/consequence.h"

#include <algorithm>

#include "fields/base/error.h"

namespace slackwater::twin {
namespace {

constexpr std::array<std::string_view, harmed_count> names{"people", "environment", "asset",
                                                           "schedule", "cost"};

}  // namespace

std::string_view name_of(Harmed harmed) noexcept { return names[static_cast<std::size_t>(harmed)]; }

Harmed Consequence::worst() const noexcept {
  return static_cast<Harmed>(std::max_element(grade.begin(), grade.end()) - grade.begin());
}

int Consequence::worst_grade() const noexcept {
  return *std::max_element(grade.begin(), grade.end());
}

std::vector<Consequence> read_consequences(const Config& task) {
  std::vector<Consequence> out;
  for (const Config& entry : task.children("risks")) {
    Consequence one;
    const std::string cause = entry.text("cause");
    try {
      one.cause = parse_risk_cause(cause);
    } catch (const Error& error) {
      entry.refuse("cause", error.what());
    }
    const bool is_second = std::any_of(
        out.begin(), out.end(), [&](const Consequence& other) { return other.cause == one.cause; });
    if (is_second) entry.refuse("cause", "found " + cause + " twice; one entry is enough");
    for (std::size_t i = 0; i < harmed_count; ++i) one.grade[i] = entry.integer(names[i], 1, 5);
    one.source = entry.optional_text("source").value_or("");
    one.status = entry.optional_text("status").value_or("estimate");
    entry.expect_all_read();
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace slackwater::twin
