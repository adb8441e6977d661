// The morning report of eight tasks from a stored forecast, page and all, nothing flown: the whole
// command. Its answer is that of `windows`.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/bench/bench_report.h"
#include "tests/bench/synthetic_store.h"
#include "tests/bench/timed_child.h"

namespace slackwater::bench {
namespace {

using nlohmann::json;

constexpr int repeats = 7;
constexpr double target_s = 5.0;

/// Both say the same of each task: verdict and best chance.
bool agree(const json& report, const json& windows) {
  const json& ours = report.at("tasks");
  const json& theirs = windows.at("tasks");
  if (ours.size() != theirs.size() || ours.empty()) return false;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    double best = 0;
    for (const json& start : theirs[i].at("starts"))
      best = std::max(best, start.at("probability").get<double>());
    if (ours[i].at("verdict") != theirs[i].at("verdict") ||
        std::abs(ours[i].at("best").at("probability").get<double>() - best) > 1e-6)
      return false;
  }
  return true;
}

void run(BenchReport& report) {
  const SyntheticStore synthetic;
  const std::filesystem::path store = synthetic.copy_of_store("timed");
  slackwater_or_throw(synthetic.forecast_arguments(store, synthetic.file("forecast.nc")));
  const auto command = [&](const char* name) {
    return std::vector<std::string>{
        "--store", store.string(), name, "--site", synthetic.site_file().string(), "--json"};
  };
  const json windows = json::parse(slackwater_or_throw(command("windows")).out, nullptr, false);
  std::vector<double> wall_s;
  const int runs = report.options().check_only ? 1 : repeats;
  for (int i = 0; i < runs; ++i) {
    const ChildCost cost = slackwater_or_throw(command("report"));
    wall_s.push_back(cost.wall_s);
    const json made = json::parse(cost.out, nullptr, false);
    const bool right = !made.is_discarded() && !windows.is_discarded() && agree(made, windows) &&
                       std::filesystem::file_size(made.at("page").get<std::string>()) > 100000;
    if (i == 0 || !right)
      report.answer("report", right,
                    right ? made.at("headline").get<std::string>() : "not what windows says");
    if (!right) return;
  }
  report.figure({"slackwater report, eight tasks, nothing flown", "s", wall_s, target_s, ""});
}

}  // namespace
}  // namespace slackwater::bench

int main(int argc, char** argv) {
  return slackwater::bench::run_bench(argc, argv, "report", slackwater::bench::run);
}
