// An answer of 50 levels and 10 parameters as CoverageJSON: the part of an HTTP position query that
// writing takes. The text is parsed and compared with the answer before any time is printed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "api/door/edr/write/format_coverage_json.h"
#include "tests/bench/bench_report.h"

namespace {

using namespace slackwater;
using namespace slackwater::api::edr;

constexpr std::size_t parameters = 10;
constexpr std::size_t levels = 50;
constexpr double target_us = 40;

Answer profile() {
  Answer answer;
  answer.collection = "currents";
  answer.title = "Currents";
  answer.vertical = Vertical::depth_down;
  answer.provenance = {"site",
                       "20250309T0500Z",
                       {},
                       {},
                       "all inputs in time",
                       false,
                       {"Generated using E.U. Copernicus Marine Service Information"},
                       "0.4.0"};
  Coverage c;
  c.domain = DomainType::vertical_profile;
  c.longitude_deg = {2.4512345};
  c.latitude_deg = {57.2543210};
  c.time = {parse_utc("2025-03-10T06:00:00Z")};
  for (std::size_t z = 0; z < levels; ++z) c.vertical_m.push_back(2.0 * static_cast<double>(z));
  for (std::size_t p = 0; p < parameters; ++p) {
    answer.parameters.push_back({"eastward_sea_water_velocity_p" + std::to_string(p),
                                 "eastward_sea_water_velocity", "Eastward current",
                                 "Eulerian current towards east", "m/s", "metre per second",
                                 "quantile"});
    std::vector<double> values;
    for (std::size_t z = 0; z < levels; ++z) {
      values.push_back(0.7 * std::sin(1.0 + static_cast<double>(p * levels + z)));
    }
    c.values.push_back(std::move(values));
  }
  answer.coverages.push_back(std::move(c));
  return answer;
}

/// The largest difference between the text's numbers and the answer's.
double largest_error(const Answer& answer) {
  const auto body = nlohmann::json::parse(coverage_json(answer));
  double largest = 0;
  for (std::size_t p = 0; p < parameters; ++p) {
    const auto& values = body.at("ranges").at(answer.parameters[p].name).at("values");
    for (std::size_t z = 0; z < levels; ++z) {
      const double error = values.at(z).get<double>() - answer.coverages[0].values[p][z];
      largest = std::max(largest, std::abs(error));
    }
  }
  return largest;
}

void measure(const Answer& answer, bench::BenchReport& report) {
  constexpr int calls = 2000;
  bench::Figure figure{"profile_as_coverage_json", "us", {}, target_us, "50 levels, 10 parameters"};
  std::size_t bytes = 0;
  for (int sample = 0; sample < 15; ++sample) {
    const auto start = std::chrono::steady_clock::now();
    for (int call = 0; call < calls; ++call) bytes += coverage_json(answer).size();
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - start;
    figure.samples.push_back(spent.count() / calls);
  }
  figure.note += ", " + std::to_string(bytes / (15 * calls)) + " bytes";
  report.figure(figure);
}

}  // namespace

int main(int argc, char** argv) {
  bench::BenchReport report(bench::bench_options(argc, argv));
  try {
    const Answer answer = profile();
    const double error = largest_error(answer);
    report.answer("values of the text", error <= 0.5e-6, std::to_string(error));
    if (!report.options().check_only && report.all_right()) measure(answer, report);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return report.exit_code();
}
