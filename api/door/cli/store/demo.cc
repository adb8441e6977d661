#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/windows_options.h"
#include "api/made_up/demo/demo_page.h"
#include "api/made_up/demo/demo_run.h"
#include "api/made_up/demo/demo_store.h"
#include "api/show/morning/morning_json.h"
#include "api/show/morning/morning_text.h"
#include "api/show/report/skill_json.h"
#include "api/show/report/verdict_text.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct DemoArguments {
  std::string folder = "demo-out";
  int days = 6;
  std::uint64_t seed = 2026;
  bool force = false;
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

/// What the demonstration proves, before its answer.
void print_summary(const DemoResult& result, const Means& mean, std::uint64_t seed) {
  const DemoDay& first = result.days.front();
  const DemoDay& last = result.days.back();
  std::printf("A made-up sea whose truth is known (seed %llu): %zu daily forecasts for %s.\n",
              static_cast<unsigned long long>(seed), result.days.size(), result.site.name.c_str());
  std::printf("Error of tomorrow's current against the truth, days %s to %s, m/s:\n",
              format_day(first.day).c_str(), format_day(last.day).c_str());
  std::printf(
      "  forecast %.3f   the same hour today %.3f   today's mean %.3f   the last value %.3f\n",
      mean.forecast, mean.same_hour, mean.day_mean, mean.persistence);
  if (const auto verdict = calibration::main_verdict(result.skill)) {
    std::printf("Against the product's own analyses, as `slackwater verify` sees it:\n%s %s\n",
                verdict_text(*verdict).c_str(), outcome_text(*verdict).c_str());
  }
}

Morning morning_of_demo(const DemoResult& result, const std::filesystem::path& store_folder) {
  MorningQuestion question;
  question.windows = plain_question(result.site, demo_site_id);
  question.windows.day = result.last.day;
  question.windows.water =
      water_of(std::make_shared<const Snapshot>(ingest::as_filed(result.last)), result.last_sha256);
  return morning_of(question, store_folder);
}

void run(const DemoArguments& arguments, const Context& context) {
  const std::filesystem::path folder = arguments.folder;
  const StoreInTheWay in_the_way = look_at_demo_store(folder);
  if (in_the_way.is_store && !in_the_way.not_demos.empty() && arguments.force) {
    std::fprintf(stderr, "slackwater: deleting %s: %s\n", (folder / "store").c_str(),
                 in_the_way.holds.c_str());
  }
  clear_demo_store(folder, in_the_way, arguments.force);
  DemoOptions options{folder, arguments.seed, arguments.days};
  DemoResult result = [&] {
    ProgressBar bar("demo", context.json);
    return run_demo(options, [&](double share, const std::string&) { bar.update(share); });
  }();
  const std::filesystem::path page = folder / "report.html";
  const Morning morning = morning_of_demo(result, folder / "store");
  write_report(demo_page(result, morning, made_by(context)), page);
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
                             {"morning", morning_json(morning, result.skill, "")},
                             {"forecast_rmse_m_s", mean.forecast},
                             {"skill", skill_list(result.skill)}}
                            .dump(2, ' ', false, json::error_handler_t::replace)
                            .c_str());
    return;
  }
  print_summary(result, mean, arguments.seed);
  const std::string store = (folder / "store").string();
  std::printf("Go on:     slackwater --store %s verify --site %s\n", store.c_str(), demo_site_id);
  std::printf("           slackwater --store %s profile --site %s --time %s\n", store.c_str(),
              demo_site_id, format_utc(result.last.time[12]).c_str());
  std::printf("           slackwater --store %s report --site %s --fly 5min\n", store.c_str(),
              demo_site_id);
  std::printf("\n%sThe page: %s  (open it in a browser)\n", morning_text(morning).c_str(),
              page.c_str());
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
  command->add_option("--seed", arguments->seed, "which ocean (default 2026)");
  command->add_flag("--force", arguments->force,
                    "delete the store in that folder even if it holds other work; says what goes");
  command->callback([arguments, &context] { run(*arguments, context); });
}

}  // namespace slackwater::api
