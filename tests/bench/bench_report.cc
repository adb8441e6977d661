#include "tests/bench/bench_report.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "fields/base/numbers/statistics.h"

namespace slackwater::bench {
namespace {

std::string processor_name() {
  std::ifstream stream("/proc/cpuinfo");
  std::string line;
  while (std::getline(stream, line)) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

double load_average() {
  double load = 0;
  return ::getloadavg(&load, 1) == 1 ? load : 0;
}

/// The machine as a reader of the figures needs to know it: its load above all.
std::string machine_line() {
  const auto pages = static_cast<double>(::sysconf(_SC_PHYS_PAGES));
  const double gib = pages * static_cast<double>(::sysconf(_SC_PAGE_SIZE)) / (1 << 30);
  char text[256];
  std::snprintf(text, sizeof text, "%s, %u cores, %.0f GiB, load %.1f", processor_name().c_str(),
                std::thread::hardware_concurrency(), gib, load_average());
  return text;
}

}  // namespace

BenchOptions bench_options(int argc, char** argv) {
  BenchOptions options;
  for (int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    options.command += (i > 0 ? " " : "") + argument;
    if (i == 0) continue;
    if (argument == "--check-only") {
      options.check_only = true;
    } else if (argument == "--json") {
      options.json = true;
    } else {
      std::fprintf(stderr, "found %s, expected --check-only or --json\n", argument.c_str());
      std::exit(2);
    }
  }
  return options;
}

double median_of(std::vector<double> samples) {
  return samples.empty() ? 0 : median(std::move(samples));
}

BenchReport::BenchReport(BenchOptions options) : options_(std::move(options)) {
  if (options_.json) {
    std::printf(
        "%s\n",
        nlohmann::json{{"machine", machine_line()}, {"command", options_.command}}.dump().c_str());
  } else {
    std::printf("machine: %s\ncommand: %s\n", machine_line().c_str(), options_.command.c_str());
  }
  std::fflush(stdout);
}

void BenchReport::answer(const std::string& name, bool right, const std::string& found) {
  wrong_ = wrong_ || !right;
  if (options_.json) {
    std::printf(
        "%s\n",
        nlohmann::json{{"answer", name}, {"right", right}, {"found", found}}.dump().c_str());
  } else {
    std::printf("%-5s %s: %s\n", right ? "right" : "WRONG", name.c_str(), found.c_str());
  }
  std::fflush(stdout);
}

void BenchReport::figure(const Figure& figure) {
  if (options_.check_only) return;
  const double median = median_of(figure.samples);
  const auto [low, high] = std::minmax_element(figure.samples.begin(), figure.samples.end());
  const bool good = (!figure.at_most || median <= *figure.at_most) &&
                    (!figure.at_least || median >= *figure.at_least);
  slow_ = slow_ || !good;
  const bool has_target = figure.at_most || figure.at_least;
  const char* verdict = !has_target ? "-" : good ? "PASS" : "FAIL";
  if (options_.json) {
    nlohmann::json line = {
        {"figure", figure.name}, {"unit", figure.unit}, {"median", median},
        {"min", *low},           {"max", *high},        {"samples", figure.samples.size()},
        {"verdict", verdict},    {"note", figure.note}, {"load", load_average()}};
    if (figure.at_most) line["at_most"] = *figure.at_most;
    if (figure.at_least) line["at_least"] = *figure.at_least;
    std::printf("%s\n", line.dump().c_str());
  } else {
    char target[48] = "no target";
    if (has_target) {
      std::snprintf(target, sizeof target, "target %s %g %s", figure.at_most ? "<=" : ">=",
                    figure.at_most ? *figure.at_most : *figure.at_least, figure.unit.c_str());
    }
    std::printf("%-5s %-52s median %9.4g %s (min %.4g, max %.4g, n %zu)  %s%s%s\n", verdict,
                figure.name.c_str(), median, figure.unit.c_str(), *low, *high,
                figure.samples.size(), target, figure.note.empty() ? "" : "  ",
                figure.note.c_str());
  }
  std::fflush(stdout);
}

void BenchReport::skipped(const std::string& name, const std::string& why) {
  if (options_.json) {
    std::printf("%s\n", nlohmann::json{{"skipped", name}, {"why", why}}.dump().c_str());
  } else {
    std::printf("SKIP  %s: %s\n", name.c_str(), why.c_str());
  }
  std::fflush(stdout);
}

int BenchReport::exit_code() const noexcept {
  if (wrong_) return 1;
  return slow_ ? 3 : 0;
}

int run_bench(int argc, char** argv, const char* name, void (*run)(BenchReport&)) {
  BenchReport report(bench_options(argc, argv));
  try {
    run(report);
  } catch (const std::exception& problem) {
    report.answer(name, false, problem.what());
  }
  return report.exit_code();
}

}  // namespace slackwater::bench
