#pragma once

namespace slackwater {

/// Standard deviation of the error of a forecast significant wave height, where the forecast itself
/// has no spread: a published record of forecasts against observations, bilinear in height and
/// lead,
///
///   Hs   12 h  24 h  36 h  48 h  72 h     (m)
///   1 m  0.34  0.36  0.37  0.39  0.43
///   2 m  0.42  0.45  0.50  0.54  0.66
///   4 m  0.66  0.76  0.85  0.94  1.08
///   6 m  0.83  0.94  1.05  1.16  1.37
///
/// below 1 m in proportion to the height, above 6 m as at 6 m, before 12 h as at 12 h, after 72 h
/// as at 72 h. It was collected for the North Sea and the Norwegian Sea; its bias (0.2 m too high
/// for low seas) is left out.
///
/// @param height_m  Hs >= 0
/// @param lead_h    hours since the forecast was made
/// Source: Wilcken (2012), table 10: the record behind the alpha factors of DNV-OS-H101, table 4-1.
[[nodiscard]] double wave_height_sigma_m(double height_m, double lead_h) noexcept;

}  // namespace slackwater
