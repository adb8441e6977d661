// The wake models beside computed flows: the actuator-line wake of a lone NREL 5 MW (velocity
// across the wake at hub height, 1 to 14 D), and the published powers of a row of three and of
// sixteen.
//
// That computed wake hardly recovers between 3 and 14 D, though its inflow is said to have 8 % of
// turbulence: it is another model, not the truth. Models with published constants recover, and are
// farther from it the farther downstream. "fitted" is the blended model with its two numbers taken
// from the lone wake; the farms are then a prediction.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fields/wind/farm_flow.h"
#include "tests/support/shared_data.h"

namespace slackwater::cfd_comparison_test {
namespace {

constexpr double d_m = 126.0;
constexpr double free_speed_m_s = 10.0;
const std::vector<int> distances{1, 3, 5, 7, 10, 14};

Turbine nrel_5mw() {
  return Turbine::load(tests::source_folder() / "data" / "turbines" / "nrel_5mw.yaml");
}

/// One section through the computed wake: deficit over the mean of its two edges.
struct Section {
  int diameters;
  std::vector<double> across_m;
  std::vector<double> deficit;
};

Section read_section(const std::filesystem::path& shared, int diameters) {
  const auto name = "single_t800_" + std::to_string(diameters) + "D_U.csv";
  std::ifstream stream(shared / "data" / "wake" / name);
  Section out{diameters, {}, {}};
  std::string line;
  std::getline(stream, line);  // y,U_0,U_1,U_2
  while (std::getline(stream, line)) {
    double y = 0;
    double u = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf", &y, &u) != 2) break;
    out.across_m.push_back(y);
    out.deficit.push_back(u);
  }
  if (out.deficit.size() < 100) throw std::runtime_error("cannot read " + name);
  const double edge = 0.5 * (out.deficit.front() + out.deficit.back());
  for (double& value : out.deficit) value = 1 - value / edge;
  return out;
}

std::vector<Section> read_sections(const std::filesystem::path& shared) {
  std::vector<Section> out;
  for (const int x : distances) out.push_back(read_section(shared, x));
  return out;
}

double rms_error(const Wake& wake, const Section& section) {
  double square = 0;
  for (std::size_t i = 0; i < section.deficit.size(); ++i) {
    const double error =
        wake_deficit(wake, section.diameters * d_m, std::abs(section.across_m[i])) -
        section.deficit[i];
    square += error * error;
  }
  return std::sqrt(square / static_cast<double>(section.deficit.size()));
}

Wake lone_wake(const WakeSettings& settings) {
  const double ct = nrel_5mw().thrust_coefficient(free_speed_m_s);
  return make_wake(settings, d_m, 90.0, ct, 0.08);
}

/// The two numbers of the blended wake that are nearest to the computed one from 3 D on, by search
/// on ever finer grids.
BlendedWakeShape fitted_shape(const std::vector<Section>& sections) {
  const auto misfit = [&](const BlendedWakeShape& shape) {
    const Wake wake = lone_wake({.model = WakeModel::blended, .blended_shape = shape});
    double total = 0;
    for (const Section& at : sections)
      if (at.diameters >= 3) total += std::pow(rms_error(wake, at), 2);
    return total;
  };
  BlendedWakeShape best{4.0, 0.02};
  for (double length_step = 1, growth_step = 0.005; growth_step > 1e-5;
       length_step /= 2, growth_step /= 2) {
    const BlendedWakeShape centre = best;
    double least = misfit(best);
    for (int i = -4; i <= 4; ++i)
      for (int j = -4; j <= 4; ++j) {
        const BlendedWakeShape candidate{std::max(0.01, centre.near_wake_length + i * length_step),
                                         std::max(0.0, centre.growth + j * growth_step)};
        const double value = misfit(candidate);
        if (value < least) {
          least = value;
          best = candidate;
        }
      }
  }
  return best;
}

struct NamedModel {
  std::string name;
  WakeSettings settings;
};

std::vector<NamedModel> models(const std::vector<Section>& sections) {
  return {
      {"Jensen k 0.04", {.model = WakeModel::jensen}},
      {"Gaussian", {.model = WakeModel::gaussian}},
      {"Larsen 2009", {.model = WakeModel::larsen}},
      {"Larsen EWTS II", {.model = WakeModel::larsen, .larsen_radius = LarsenRadius::ewts_1996}},
      {"blended", {.model = WakeModel::blended}},
      {"blended, fitted", {.model = WakeModel::blended, .blended_shape = fitted_shape(sections)}}};
}

/// Power of each row of turbines over that of the first, the mean of the turbines abreast.
std::vector<double> row_ratios(const WakeSettings& wake, bool published_rule, int rows, int abreast,
                               double along_diameters) {
  FarmSettings settings;
  settings.wake = wake;
  if (published_rule) {
    settings.superposition = {Superposition::Scale::free_stream, Superposition::Sum::linear};
    settings.added_turbulence = false;
  }
  std::vector<Horizontal> layout;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < abreast; ++j) layout.emplace_back(i * along_diameters * d_m, j * 7.0 * d_m);
  const FarmFlow flow(nrel_5mw(), layout, {free_speed_m_s, 0}, settings);
  std::vector<double> out(static_cast<std::size_t>(rows), 0.0);
  for (std::size_t i = 0; i < layout.size(); ++i)
    out[i / static_cast<std::size_t>(abreast)] += flow.turbines()[i].power_w;
  const double first = out[0];
  for (double& value : out) value /= first;
  return out;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square / static_cast<double>(a.size()));
}

std::vector<double> over_first(std::vector<double> values) {
  const double first = values[0];
  for (double& value : values) value /= first;
  return values;
}

// The index of the shared data, MW.
const std::vector<double> cfd_row_mw{3.806, 1.904, 0.560};
const std::vector<double> cfd_sixteen_mw{3.964, 2.046, 0.619, 0.190};
const std::vector<std::pair<std::string, std::vector<double>>> published_row_mw{
    {"Larsen", {3.724, 1.707, 0.858}},        {"blended", {3.803, 1.470, 0.595}},
    {"Jensen", {3.724, 1.583, 0.981}},        {"Gaussian", {3.724, 1.552, 1.130}},
    {"FLORIS-Jensen", {3.418, 1.863, 1.702}}, {"FLORIS-Gauss", {3.418, 1.638, 1.803}}};

TEST(WakesBesideCfd, HaveTheDeficitShapeOfTheLoneTurbine) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::vector<Section> sections = read_sections(shared);
  std::printf("rms error of dU/U across the wake, by x/D\n%-18s", "");
  for (const int x : distances) std::printf("%8d", x);
  std::printf("   3-14\n");
  std::vector<double> pooled;
  std::vector<double> far;  // 7 to 14 D
  for (const NamedModel& model : models(sections)) {
    const Wake wake = lone_wake(model.settings);
    std::printf("%-18s", model.name.c_str());
    double square = 0;
    double far_square = 0;
    for (const Section& at : sections) {
      const double error = rms_error(wake, at);
      std::printf("%8.4f", error);
      if (at.diameters >= 3) square += error * error / 5;
      if (at.diameters >= 7) far_square += error * error / 3;
    }
    far.push_back(std::sqrt(far_square));
    pooled.push_back(std::sqrt(square));
    std::printf("%7.4f\n", pooled.back());
  }
  const BlendedWakeShape shape = fitted_shape(sections);
  std::printf("fitted: near wake %.3f D, growth %.5f\n", shape.near_wake_length, shape.growth);
  // The deficit of the data is 0.31 at its deepest. With published constants (Jensen, Gaussian,
  // Larsen 2009, blended) the blended wake is the nearest from 7 D on, where turbines stand.
  for (const std::size_t other : {0U, 1U, 2U}) EXPECT_LT(far[4], far[other]);
  EXPECT_LT(pooled[4], 0.062);
  EXPECT_LT(pooled[5], 0.025);
}

TEST(WakesBesideCfd, PredictTheRowOfThree) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::vector<double> cfd = over_first(cfd_row_mw);
  std::printf("row of three at 7 D, P_i/P_1; CFD 1 %.3f %.3f\n", cfd[1], cfd[2]);
  double best_published = 1;
  for (const auto& [name, power_mw] : published_row_mw) {
    const std::vector<double> ratio = over_first(power_mw);
    const double error = rms_difference(ratio, cfd);
    std::printf("  published %-14s 1 %.3f %.3f   rmse %.4f (%.3f MW of 3.806)\n", name.c_str(),
                ratio[1], ratio[2], error, 3.806 * error);
    best_published = std::min(best_published, error);
  }
  const std::vector<NamedModel> candidates = models(read_sections(shared));
  std::array<std::vector<double>, 2> errors;
  for (const bool published_rule : {true, false}) {
    std::printf(published_rule ? " sum of deficits of the free wind, no added turbulence\n"
                               : " sum of deficits of the local wind, Crespo-Hernandez\n");
    for (const NamedModel& model : candidates) {
      const std::vector<double> ratio = row_ratios(model.settings, published_rule, 3, 1, 7);
      errors[published_rule ? 0 : 1].push_back(rms_difference(ratio, cfd));
      std::printf("  %-24s 1 %.3f %.3f   rmse %.4f (%.3f MW of 3.806)\n", model.name.c_str(),
                  ratio[1], ratio[2], rms_difference(ratio, cfd),
                  3.806 * rms_difference(ratio, cfd));
    }
  }
  // With its two numbers from the lone wake the blended model predicts the row better than any of
  // the published results, 0.054 of P_1 at best.
  EXPECT_LT(errors[0][5], best_published);
  EXPECT_LT(errors[0][5], 0.04);
  // Published constants, in our own words: no better than this, see the head of this file.
  EXPECT_LT(errors[0][4], 0.125);
  EXPECT_LT(errors[0][4], errors[0][1]);
  EXPECT_LT(errors[0][3], 0.075);
}

TEST(WakesBesideCfd, PredictTheSixteen) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::vector<double> cfd = over_first(cfd_sixteen_mw);
  const double cfd_total = 27.27 / 3.964;
  std::printf("4 x 4, 7 D across, 9 D along; CFD rows 1 %.3f %.3f %.3f, total/P_1 %.3f\n", cfd[1],
              cfd[2], cfd[3], cfd_total);
  for (const auto& [name, total_mw, first_mw] :
       {std::tuple{"Larsen", 27.65, 3.724}, std::tuple{"blended", 21.80, 3.803},
        std::tuple{"Jensen", 31.31, 3.724}, std::tuple{"Gaussian", 35.37, 3.724}}) {
    std::printf("  published %-14s total/P_1 %.3f (%+.1f %%)\n", name, total_mw / first_mw,
                100 * (total_mw / first_mw / cfd_total - 1));
  }
  const std::vector<NamedModel> candidates = models(read_sections(shared));
  std::array<std::vector<double>, 2> errors;
  std::array<std::vector<double>, 2> totals;
  for (const bool published_rule : {true, false}) {
    std::printf(published_rule ? " sum of deficits of the free wind, no added turbulence\n"
                               : " sum of deficits of the local wind, Crespo-Hernandez\n");
    for (const NamedModel& model : candidates) {
      const std::vector<double> ratio = row_ratios(model.settings, published_rule, 4, 4, 9);
      const double total = 4 * (ratio[0] + ratio[1] + ratio[2] + ratio[3]);
      const double off = total / cfd_total - 1;
      errors[published_rule ? 0 : 1].push_back(rms_difference(ratio, cfd));
      totals[published_rule ? 0 : 1].push_back(off);
      std::printf("  %-24s 1 %.3f %.3f %.3f   rmse %.4f, total/P_1 %.3f (%+.1f %%)\n",
                  model.name.c_str(), ratio[1], ratio[2], ratio[3], rms_difference(ratio, cfd),
                  total, 100 * off);
    }
  }
  EXPECT_LT(errors[0][5], 0.05);
  EXPECT_LT(std::abs(totals[0][5]), 0.06);
  // Recovering wakes leave more than that CFD; the order of the models is the published one.
  EXPECT_LT(errors[0][4], errors[0][1]);
  EXPECT_LT(errors[0][4], 0.22);
}

}  // namespace
}  // namespace slackwater::cfd_comparison_test
