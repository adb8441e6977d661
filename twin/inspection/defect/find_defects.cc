#include "twin/inspection/defect/find_defects.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/text.h"
#include "twin/sensor/noise.h"

namespace slackwater::twin {
namespace {

const DetectionMethod* method_for(const std::vector<DetectionMethod>& methods, DefectKind kind,
                                  SurfaceKind surface, InstrumentKind instrument) {
  for (const DetectionMethod& method : methods)
    if (method.can_find(kind, surface, instrument)) return &method;
  return nullptr;
}

double detail_of(const BestLook& look) {
  return look.is_seen() ? static_cast<double>(look.detail_m)
                        : std::numeric_limits<double>::infinity();
}

Triple<double> reported_m(const Patch& patch, const BestLook& look) {
  return {patch.centre_m.x + static_cast<double>(look.off_north_m),
          patch.centre_m.y + static_cast<double>(look.off_east_m),
          patch.centre_m.z + static_cast<double>(look.off_down_m)};
}

/// What a finding has from the look that shows it.
Finding shown(const SurfaceLooks& by, const Surface& surface, std::size_t patch,
              const DetectionMethod& method) {
  const BestLook& look = by.looks[patch];
  Finding finding;
  finding.surface = by.surface;
  finding.patch = patch;
  finding.true_position_m = surface.patches[patch].centre_m;
  finding.position_m = reported_m(surface.patches[patch], look);
  finding.instrument = by.name;
  finding.method = method.name;
  finding.t_s = static_cast<double>(look.t_s);
  finding.detail_m = static_cast<double>(look.detail_m);
  return finding;
}

class Search {
 public:
  Search(std::span<const Surface> surfaces, std::span<const SurfaceLooks> looks,
         const std::vector<DetectionMethod>& methods, const DefectFacts& facts, std::uint64_t seed)
      : surfaces_(surfaces), looks_(looks), methods_(methods), facts_(facts), seed_(seed) {
    for (std::size_t i = 0; i < looks.size(); ++i) {
      expects(looks[i].surface < surfaces.size() && looks[i].instrument != nullptr,
              "looks are of an instrument, at a surface of the run");
      expects(looks[i].looks.size() == surfaces[looks[i].surface].patches.size(),
              "one best look for each patch");
      for (std::size_t k = 0; k < i; ++k)
        expects(looks[k].surface != looks[i].surface || looks[k].name != looks[i].name,
                "an instrument's looks at a surface stand once");
    }
  }

  void look_for(const Defect& defect, Findings& findings) const {
    const Surface& surface = surfaces_[defect.surface];
    const std::size_t before = findings.found.size();
    Miss miss{defect, MissReason::nothing_finds_it, {}};
    double best_pod = 0;
    bool would_be_found = false;
    for (const SurfaceLooks& by : looks_) {
      if (by.surface != defect.surface) continue;
      const DetectionMethod* method =
          method_for(methods_, defect.kind, surface.kind, by.instrument->kind);
      if (method == nullptr) continue;
      if (miss.reason == MissReason::nothing_finds_it) miss.reason = MissReason::not_seen;
      const BestLook& look = by.looks[defect.patch];
      if (!look.is_seen()) continue;
      const double detail_m = detail_of(look);
      const double pod = probability_of_detection(*method, defect, detail_m);
      const double u = latent(defect, by);
      if (pod >= u && pod > 0) {
        findings.found.push_back(found(defect, by, *method, pod));
        continue;
      }
      miss.reason = MissReason::overlooked;
      miss.detail_m = std::min(miss.detail_m, detail_m);
      best_pod = std::max(best_pod, pod);
      would_be_found |= probability_of_detection(*method, defect, 0) >= u;
    }
    if (findings.found.size() > before) return;
    if (would_be_found) miss.reason = MissReason::seen_too_poorly;
    miss.words = words_for(miss, best_pod);
    findings.missed.push_back(std::move(miss));
  }

  void add_false_alarms(const SurfaceLooks& by, Findings& findings) const {
    const Surface& surface = surfaces_[by.surface];
    for (const DetectionMethod& method : methods_) {
      if (!method.is_used(surface.kind, by.instrument->kind)) continue;
      const std::vector<DefectKind> kinds = kinds_on(method, surface.kind);
      if (kinds.empty()) continue;
      for (std::size_t p = 0; p < by.looks.size(); ++p) {
        if (!is_read(by, p)) continue;
        const double expected = 0.01 * method.false_alarms_per_100_m2 * surface.patches[p].area_m2;
        NoiseStream chance(seed_, formatted("inspection/false/{}/{}/{}/{}", by.name, method.name,
                                            surface.name, p));
        for (std::size_t left = poisson(expected, chance.uniform()); left > 0; --left)
          findings.found.push_back(false_alarm(by, p, method, kinds, chance));
      }
    }
  }

  [[nodiscard]] double read_m2() const {
    double area_m2 = 0;
    for (std::size_t s = 0; s < surfaces_.size(); ++s)
      for (std::size_t p = 0; p < surfaces_[s].patches.size(); ++p)
        if (is_read_by_any(s, p)) area_m2 += surfaces_[s].patches[p].area_m2;
    return area_m2;
  }

 private:
  /// Its one uniform number for an instrument.
  [[nodiscard]] double latent(const Defect& defect, const SurfaceLooks& by) const {
    NoiseStream chance(seed_, formatted("inspection/find/{}/{}", by.name, defect.number));
    return chance.uniform();
  }

  [[nodiscard]] Finding found(const Defect& defect, const SurfaceLooks& by,
                              const DetectionMethod& method, double pod) const {
    Finding finding = shown(by, surfaces_[defect.surface], defect.patch, method);
    finding.defect = defect.number;
    finding.kind = defect.kind;
    finding.probability = pod;
    finding.true_size_m = defect.size_m;
    finding.true_severity = defect.severity;
    NoiseStream size(seed_, formatted("inspection/size/{}/{}", by.name, defect.number));
    finding.size_m =
        std::max(0.0, defect.size_m * (1 + method.size_bias + method.size_sd * size.normal()));
    if (const auto quantity = quantity_of(defect.kind, by.instrument->kind))
      read_off(*quantity, defect, by, finding);
    return finding;
  }

  void read_off(Quantity quantity, const Defect& defect, const SurfaceLooks& by,
                Finding& finding) const {
    const std::string place = formatted("{}", defect.number);
    const double range_m = static_cast<double>(by.looks[defect.patch].range_m);
    Reading reading{quantity, 0, value_of(quantity, defect.severity, facts_)};
    reading.value =
        measured(quantity, reading.truth, *by.instrument, range_m, {seed_, by.name, place});
    finding.severity = severity_of(quantity, reading.value, facts_);
    finding.reading = reading;
  }

  /// As large as what is barely made out up to ten times that, evenly over the logarithm; nothing
  /// is known of it.
  [[nodiscard]] Finding false_alarm(const SurfaceLooks& by, std::size_t patch,
                                    const DetectionMethod& method,
                                    const std::vector<DefectKind>& kinds,
                                    NoiseStream& chance) const {
    Finding finding = shown(by, surfaces_[by.surface], patch, method);
    const auto kind =
        static_cast<std::size_t>(chance.uniform() * static_cast<double>(kinds.size()));
    finding.kind = kinds[kind];
    finding.size_m =
        std::max(finding.detail_m, method.at_detail_m) * std::pow(10.0, chance.uniform());
    return finding;
  }

  [[nodiscard]] static std::vector<DefectKind> kinds_on(const DetectionMethod& method,
                                                        SurfaceKind surface) {
    std::vector<DefectKind> kinds;
    std::copy_if(method.finds.begin(), method.finds.end(), std::back_inserter(kinds),
                 [&](DefectKind kind) { return may_sit_on(kind, surface); });
    return kinds;
  }

  /// The number that a uniform one stands for: by the distribution's inverse.
  [[nodiscard]] static std::size_t poisson(double expected, double u) {
    double chance = std::exp(-expected), up_to = chance;
    std::size_t n = 0;
    while (u >= up_to && n < 1000) {
      ++n;
      chance *= expected / static_cast<double>(n);
      up_to += chance;
    }
    return n;
  }

  [[nodiscard]] static bool is_read(const SurfaceLooks& by, std::size_t patch) {
    return by.looks[patch].is_seen() && detail_of(by.looks[patch]) <= by.most_detail_m;
  }

  [[nodiscard]] bool is_read_by_any(std::size_t surface, std::size_t patch) const {
    return std::any_of(looks_.begin(), looks_.end(), [&](const SurfaceLooks& by) {
      return by.surface == surface && is_read(by, patch) &&
             std::any_of(methods_.begin(), methods_.end(), [&](const DetectionMethod& method) {
               return method.is_used(surfaces_[surface].kind, by.instrument->kind);
             });
    });
  }

  [[nodiscard]] std::string words_for(const Miss& miss, double pod) const {
    switch (miss.reason) {
      case MissReason::nothing_finds_it:
        return formatted("no instrument that looked at {} finds {}",
                         surfaces_[miss.defect.surface].name, name_of(miss.defect.kind));
      case MissReason::not_seen:
        return "not seen";
      case MissReason::seen_too_poorly:
        return formatted(
            "seen too poorly: least detail {:.3g} mm, found in {:.0f} of 100 such looks",
            1e3 * miss.detail_m, 100 * pod);
      case MissReason::overlooked:
        return formatted(
            "overlooked by chance: least detail {:.3g} mm, found in {:.0f} of 100 such "
            "looks",
            1e3 * miss.detail_m, 100 * pod);
    }
    return {};
  }

  std::span<const Surface> surfaces_;
  std::span<const SurfaceLooks> looks_;
  const std::vector<DetectionMethod>& methods_;
  const DefectFacts& facts_;
  std::uint64_t seed_;
};

}  // namespace

Findings find_defects(std::span<const Defect> defects, std::span<const Surface> surfaces,
                      std::span<const SurfaceLooks> looks,
                      const std::vector<DetectionMethod>& methods, const DefectFacts& facts,
                      std::uint64_t seed) {
  expect_one_method_each(methods);
  const Search search(surfaces, looks, methods, facts, seed);
  Findings findings;
  for (const Defect& defect : defects) search.look_for(defect, findings);
  for (const SurfaceLooks& by : looks) search.add_false_alarms(by, findings);
  findings.read_m2 = search.read_m2();
  return findings;
}

}  // namespace slackwater::twin
