// The sea at a million places: surface and orbital velocity of 200 sinusoids at one point each, on
// every instruction set of this machine. Before any time: the sums against the textbook formulae
// with std::cos and std::cosh, the same bits on all paths, no allocation.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "fields/wave/sea_sampling.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/counted_allocations.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr double target_ns = 1000;  ///< for AVX2 and better
constexpr std::size_t batch = 1000;
constexpr int batches = 200;

/// A wind sea and a swell off a wind farm, in a tidal current.
SeaRealisation two_systems() {
  const PartitionedSea sea{{{1.8, 6.5, 250.0, std::nullopt, 10.0}, {1.1, 11.0, 310.0, 1.5, 30.0}}};
  return realise(sea, {30.0, Horizontal{0.6, -0.3}}, 7, parse_utc("2025-03-10T00:00:00Z"));
}

std::vector<WavePlace> places_in_the_farm() {
  Rng rng(11, "bench/wave_places");
  std::vector<WavePlace> places(batch);
  for (WavePlace& at : places) {
    at = {rng.uniform(-3000, 3000), rng.uniform(-3000, 3000), rng.uniform(-30, -3),
          rng.uniform(0, 86400)};
  }
  return places;
}

/// The textbook, in double: eta by cos, then Wheeler's level, then velocity by cosh and sinh.
WaveMotion textbook(const SeaRealisation& sea, const WavePlace& at) {
  WaveMotion sum;
  const auto phase = [&](const WaveComponent& wave) {
    return wave.wavenumber_rad_m.real() * at.east_m + wave.wavenumber_rad_m.imag() * at.north_m -
           wave.absolute_rad_s * at.t_s + wave.phase_rad;
  };
  for (const WaveComponent& wave : sea.waves()) {
    sum.elevation_m += wave.amplitude_m * std::cos(phase(wave));
  }
  const double h = sea.water().depth_m;
  const double z = h * (at.up_m - sum.elevation_m) / (h + sum.elevation_m);
  for (const WaveComponent& wave : sea.waves()) {
    const double k = std::abs(wave.wavenumber_rad_m);
    const double speed = wave.amplitude_m * wave.intrinsic_rad_s / std::sinh(k * h);
    const Horizontal along =
        speed * std::cosh(k * (z + h)) * std::cos(phase(wave)) * wave.wavenumber_rad_m / k;
    sum.velocity_m_s[0] += along.real();
    sum.velocity_m_s[1] += along.imag();
    sum.velocity_m_s[2] += speed * std::sinh(k * (z + h)) * std::sin(phase(wave));
  }
  return sum;
}

double farthest(const WaveMotion& a, const WaveMotion& b) {
  double worst = std::abs(a.elevation_m - b.elevation_m);
  for (int i = 0; i < 3; ++i) {
    worst = std::max(worst, std::abs(a.velocity_m_s[i] - b.velocity_m_s[i]));
  }
  return worst;
}

bool same_bits(const WaveMotion& a, const WaveMotion& b) {
  return a.elevation_m == b.elevation_m && a.status == b.status &&
         std::memcmp(a.velocity_m_s, b.velocity_m_s, sizeof a.velocity_m_s) == 0;
}

void bench_path(BenchReport& report, KernelPath path, const SeaRealisation& sea,
                const std::vector<WavePlace>& places, const std::vector<WaveMotion>& baseline) {
  std::vector<WaveMotion> out(places.size());
  const std::size_t allocated_before = allocations();
  sample_motion_on(path, sea, places, out);
  const std::size_t allocated = allocations() - allocated_before;
  double worst = 0;
  std::size_t different = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool wet = out[i].status == SampleStatus::ok;
    worst = std::max(worst, wet ? farthest(out[i], textbook(sea, places[i])) : 1e9);
    different += same_bits(out[i], baseline[i]) ? 0U : 1U;
  }
  const std::string name = "waves on " + std::string(name_of(path));
  char text[200];
  std::snprintf(text, sizeof text,
                "%zu points of %zu waves, worst error %.1e m, %zu differ from the baseline in a "
                "bit, %zu allocations",
                places.size(), sea.waves().size(), worst, different, allocated);
  // Phases of up to 1e5 rad are rounded to 1e-11 rad on both sides.
  const bool right = worst < 1e-9 && different == 0 && allocated == 0;
  report.answer(name, right, text);
  if (!right || report.options().check_only) return;
  std::vector<double> ns;
  for (int i = 0; i < batches; ++i) {
    const auto from = std::chrono::steady_clock::now();
    sample_motion_on(path, sea, places, out);
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - from;
    ns.push_back(took.count() / static_cast<double>(places.size()));
  }
  std::optional<double> target;
  if (path != KernelPath::baseline) target = target_ns;
  report.figure({"elevation + velocity, 200 waves, " + std::string(name_of(path)), "ns/point", ns,
                 target, ""});
}

/// What a user would write: the same sums with the C library.
void bench_textbook(BenchReport& report, const SeaRealisation& sea,
                    const std::vector<WavePlace>& places) {
  std::vector<double> ns;
  double checksum = 0;
  for (int i = 0; i < 5; ++i) {
    const auto from = std::chrono::steady_clock::now();
    for (const WavePlace& at : places) checksum += textbook(sea, at).velocity_m_s[2];
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - from;
    ns.push_back(took.count() / static_cast<double>(places.size()));
  }
  char note[60];
  std::snprintf(note, sizeof note, "checksum %.6g", checksum);
  report.figure({"  the same by std::cos and std::cosh", "ns/point", ns, std::nullopt, note});
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  try {
    const SeaRealisation sea = two_systems();
    const std::vector<WavePlace> places = places_in_the_farm();
    std::vector<WaveMotion> baseline(places.size());
    sample_motion_on(KernelPath::baseline, sea, places, baseline);
    for (const KernelPath path : supported_kernel_paths()) {
      bench_path(report, path, sea, places, baseline);
    }
    if (!report.options().check_only) bench_textbook(report, sea, places);
  } catch (const std::exception& problem) {
    report.answer("waves", false, problem.what());
  }
  return report.exit_code();
}
