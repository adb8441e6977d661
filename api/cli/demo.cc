#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/cli/command.h"
#include "api/cli/progress.h"
#include "api/demo/demo_page.h"
#include "api/demo/demo_run.h"
#include "api/program/version.h"
#include "api/report/skill_json.h"
#include "api/report/skill_table.h"
#include "api/report/verdict_text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct DemoArguments {
  std::string folder = "demo-out";
  int days = 6;
  std::uint64_t seed = 2025;
};

struct Means {
  double forecast = 0, persistence = 0, day_mean = 0, same_hour = 0;
};

Means means_of(const std::vector<DemoDay>& days) {
  Means m;
  for (const DemoDay& d : days) {
    m.forecast += d.forecast_rmse_m_s * d.forecast_rmse_m_s;
    m.persistence += d.persistence_rmse_m_s * d.persistence_rmse_m_s;
    m.day_mean += d.day_mean_rmse_m_s * d.day_mean_rmse_m_s;
    m.same_hour += d.same_hour_rmse_m_s * d.same_hour_rmse_m_s;
  }
  const auto n = static_cast<double>(days.size());
  return {std::sqrt(m.forecast / n), std::sqrt(m.persistence / n), std::sqrt(m.day_mean / n),
          std::sqrt(m.same_hour / n)};
}

void run(const DemoArguments& arguments, const Context& context) {
  const std::filesystem::path folder = arguments.folder;
  if (std::filesystem::exists(folder / "store")) std::filesystem::remove_all(folder / "store");
  DemoOptions options{folder, arguments.seed, arguments.days};
  DemoResult result = [&] {
    ProgressBar bar("demo", context.json);
    return run_demo(options, [&](double share, const std::string&) { bar.update(share); });
  }();
  const std::filesystem::path page = folder / "report.html";
  write_report(demo_page(result, format_utc(context.now()) + " by slackwater " + code_version()),
               page);
  const Means mean = means_of(result.days);
  if (context.json) {
    json days = json::array();
    for (const DemoDay& d : result.days) {
      days.push_back({{"day", format_day(d.day)},
                      {"forecast_rmse_m_s", d.forecast_rmse_m_s},
                      {"persistence_rmse_m_s", d.persistence_rmse_m_s},
                      {"day_mean_rmse_m_s", d.day_mean_rmse_m_s},
                      {"same_hour_rmse_m_s", d.same_hour_rmse_m_s},
                      {"coverage_80", d.coverage_80}});
    }
    std::printf("%s\n", json{{"seed", arguments.seed},
                             {"page", page.string()},
                             {"store", (folder / "store").string()},
                             {"days", days},
                             {"forecast_rmse_m_s", mean.forecast},
                             {"skill", json::parse(skill_json(result.skill))}}
                            .dump(2)
                            .c_str());
    return;
  }
  std::printf(
      "A synthetic coastal ocean with known truth (seed %llu): %zu daily jobs at %s, %.0f m of "
      "water.\n\n",
      static_cast<unsigned long long>(arguments.seed), result.days.size(), result.site.name.c_str(),
      result.last.columns.front().water_depth_m);
  std::printf(
      "Against the truth, lead 0-24 h, all levels, root mean square vector error in m/s:\n");
  std::printf("  %-12s %9s %12s %9s %10s %8s\n", "day D", "forecast", "persistence", "day mean",
              "same hour", "in 80%");
  for (const DemoDay& d : result.days) {
    std::printf("  %-12s %9.3f %12.3f %9.3f %10.3f %7.0f%%\n", format_day(d.day).c_str(),
                d.forecast_rmse_m_s, d.persistence_rmse_m_s, d.day_mean_rmse_m_s,
                d.same_hour_rmse_m_s, 100 * d.coverage_80);
  }
  std::printf("  %-12s %9.3f %12.3f %9.3f %10.3f\n", "all", mean.forecast, mean.persistence,
              mean.day_mean, mean.same_hour);
  std::printf("\nAgainst the analysed products, as `slackwater verify` sees it:\n%s%s",
              verdict_lines(result.skill).c_str(), skill_table(result.skill).c_str());
  std::printf(
      "\nOpen %s in a browser. The store is %s; try\n  slackwater --store %s profile --site %s "
      "--time %s\n",
      page.c_str(), (folder / "store").c_str(), (folder / "store").c_str(),
      (folder / "synthetic.yaml").c_str(), format_utc(result.last.time[12]).c_str());
}

}  // namespace

void add_demo(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<DemoArguments>();
  CLI::App* command = app.add_subcommand(
      "demo", "Everything above on a synthetic ocean with known truth; no account, no network");
  command->add_option("--out", arguments->folder,
                      "folder for product files, store and page (default demo-out)");
  command->add_option("--days", arguments->days, "consecutive daily jobs (default 6)")
      ->check(CLI::Range(1, 400));
  command->add_option("--seed", arguments->seed, "which ocean (default 2025)");
  command->callback([arguments, &context] { run(*arguments, context); });
}

}  // namespace slackwater::api
