#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "fields/base/time.h"
#include "fields/grid/status.h"

namespace slackwater::ingest {

/// The spike test of Argo and QARTOD on a time series, made fair to fast tides:
///
///   |V2 - (V1 + V3)/2| - |V3 - V1|/2 > threshold       (one value stands out of its neighbours)
///   |V2 - (V1 + V3)/2| > 8 s,  s = 1.4826 median |V2 - (V1 + V3)/2| over the series
///
/// Both must hold. The first alone would reject the turn of a strong tidal stream sampled every few
/// hours; the second alone, the noise of a quiet one. V1 and V3 are the nearest samples with values
/// before and after; they count only within three median sampling steps, so that nothing is judged
/// across a gap, and the ends of a series and series of fewer than eight such triples are not
/// judged. For a vector |.| is its length, so that turning the axes turns nothing. Only samples
/// that nobody has checked are marked; those that a provider passed serve as neighbours. Returns
/// how many samples it marked as suspect.
///
/// Sources: Argo Quality Control Manual for CTD data 3.x, test 9 (form); IOOS QARTOD manuals, spike
/// test; the scale is the median absolute deviation (Leys et al. 2013).
std::size_t test_spikes(double threshold, std::span<const UtcTime> times,
                        std::span<const float> values, std::span<SampleStatus> status);
std::size_t test_vector_spikes(double threshold, std::span<const UtcTime> times,
                               std::span<const float> east, std::span<const float> north,
                               std::span<SampleStatus> east_status,
                               std::span<SampleStatus> north_status);

/// The threshold of a quantity in its canonical unit, by CF standard name: 1 m/s for currents, 20
/// m/s for wind, 3 m for wave heights, 6 K for temperature (Argo, above 500 dbar). Nothing for
/// periods and directions, which jump when wind sea overtakes swell. The others are ours: twice the
/// largest departure of a 5 m/s tidal stream sampled hourly, and what gust fronts and storm growth
/// do not reach within ten minutes and back.
[[nodiscard]] std::optional<double> spike_threshold_of(std::string_view standard_name) noexcept;

}  // namespace slackwater::ingest
