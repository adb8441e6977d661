#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "ingest/ais/track.h"

namespace slackwater::api {

/// Who was heard last, where, and when.
struct LastHeard {
  std::uint32_t mmsi = 0;
  ingest::AisClass speaker = ingest::AisClass::a;
  ingest::AisIdentity identity;  ///< what it had said of itself by then
  ingest::AisPosition position;
};

/// What a receiver hears, report by report, so that it can be asked what was known at any time: of
/// what came later nothing is told, neither places nor names. A report that is added again changes
/// nothing. Bounded in memory: of too many the older half is forgotten.
class HeardVessels {
 public:
  /// A position weighs about 100 bytes.
  explicit HeardVessels(std::size_t most_positions = 1'000'000) : most_positions_(most_positions) {}

  /// Base stations and aircraft are no vessels; that they were heard counts.
  void add(const ingest::AisReport& report);

  /// The newest position of each vessel among the reports received by then; by MMSI. Those of type
  /// 27, to a tenth of a minute, count only for who tells no finer one.
  [[nodiscard]] std::vector<LastHeard> known_at(UtcTime at) const;
  /// When anything was received last by then.
  [[nodiscard]] std::optional<UtcTime> last_received(UtcTime at) const;
  /// The first and the last report of all.
  [[nodiscard]] std::optional<UtcTime> first() const;
  [[nodiscard]] std::optional<UtcTime> last() const;

 private:
  struct Heard {
    ingest::AisPosition position;
    UtcTime received{};
    ingest::AisClass speaker = ingest::AisClass::a;
  };
  struct Known {
    UtcTime since{};
    ingest::AisIdentity identity;
  };
  struct Vessel {
    std::vector<Heard> fine, coarse;  ///< by the time of the position
    std::vector<Known> known;         ///< by time
  };
  [[nodiscard]] static const Heard* newest(const std::vector<Heard>& heard, UtcTime at);
  static bool insert(std::vector<Heard>& into, const Heard& heard);
  void note_time(UtcTime received);
  void learn(Vessel& vessel, const ingest::AisReport& report);
  void forget_older_half();

  std::size_t most_positions_;
  std::size_t weight_ = 0;
  std::map<std::uint32_t, Vessel> vessels_;
  std::vector<UtcTime> minutes_;  ///< the last receipt within each minute, ascending
  std::optional<UtcTime> first_;
};

}  // namespace slackwater::api
