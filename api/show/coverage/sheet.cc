#include "api/show/coverage/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "api/show/coverage/raster.h"
#include "fields/base/angle.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater::api {
namespace {

// Pixels of a picture that a telephone shows at its own size.
constexpr double picture_wide = 366;
constexpr double left = 54, right = 18, top = 40, bottom = 62;
constexpr double most_wide = picture_wide - left - right;
constexpr double most_high = 400;
constexpr double least_side = 90;

/// Where the sheet lies in the picture.
struct Frame {
  double wide = 0;  ///< px
  double high = 0;
  double from = 0;  ///< px, of its left edge
  double x_per_m = 0;
  double y_per_m = 0;

  explicit Frame(const CoverageSheet& sheet) {
    const double per_m = std::min(most_wide / sheet.width_m, most_high / sheet.height_m);
    wide = std::max(least_side, sheet.width_m * per_m);
    high = std::max(least_side, sheet.height_m * per_m);
    from = left + (most_wide - wide) / 2;
    x_per_m = wide / sheet.width_m;
    y_per_m = high / sheet.height_m;
  }
  [[nodiscard]] double x(double along_m) const { return from + along_m * x_per_m; }
  [[nodiscard]] double y(double down_m) const { return top + down_m * y_per_m; }
};

std::string text_svg(double x, double y, const std::string& text, const char* how = "") {
  return formatted("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>", x, y, how, escaped_html(text));
}

std::string line_svg(const char* kind, double x1, double y1, double x2, double y2) {
  return formatted("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", kind, x1, y1, x2, y2);
}

std::string cells_svg(const CoverageRaster& raster, const Frame& frame) {
  std::array<std::string, patch_states> paths;
  const double dx = frame.wide / static_cast<double>(raster.columns);
  const double dy = frame.high / static_cast<double>(raster.rows);
  for (const CoverageRaster::Block& b : raster.blocks())
    paths[static_cast<std::size_t>(b.state)] += formatted(
        "M{:.1f} {:.1f}h{:.1f}v{:.1f}h-{:.1f}z", frame.from + static_cast<double>(b.column) * dx,
        top + static_cast<double>(b.row) * dy, static_cast<double>(b.wide) * dx,
        static_cast<double>(b.high) * dy, static_cast<double>(b.wide) * dx);
  std::string svg = "<g shape-rendering=\"crispEdges\">";
  for (std::size_t s = 0; s < patch_states; ++s)
    if (!paths[s].empty()) svg += formatted("<path class=\"state{}\" d=\"{}\"/>", s, paths[s]);
  return svg + "</g>";
}

/// Depths where the sheet has them, heights where some of it is above the sea; else metres down.
std::string side_svg(const CoverageSheet& sheet, const Frame& frame) {
  const double top_m = sheet.has_depth() ? sheet.top_depth_m : 0;
  const bool tells_height = sheet.has_depth() && top_m < 0;
  const double step_m = round_length(sheet.height_m * 60 / frame.high);
  std::string svg;
  for (double at_m = std::ceil(top_m / step_m - 1e-9) * step_m;
       at_m <= top_m + sheet.height_m * (1 + 1e-9); at_m += step_m) {
    const double y = frame.y(at_m - top_m);
    const double shown = tells_height ? -at_m : at_m;
    svg += line_svg("tick", frame.from - 5, y, frame.from, y) +
           text_svg(frame.from - 8, y + 4, formatted("{:g}", shown == 0 ? 0.0 : shown),
                    "text-anchor=\"end\"");
  }
  const std::string words = tells_height        ? "height (m)"
                            : sheet.has_depth() ? "depth (m)"
                                                : sheet.down + " (m)";
  const double x = frame.from - 40, y = top + frame.high / 2;
  svg += formatted(
      "<text class=\"axis\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
      "text-anchor=\"middle\">{}</text>",
      x, y, escaped_html(words));
  // The sea's level, where it crosses the sheet.
  if (sheet.has_depth() && top_m < 0 && top_m + sheet.height_m > 0) {
    const double sea = frame.y(-top_m);
    svg += line_svg("halo", frame.from, sea, frame.from + frame.wide, sea) +
           line_svg("sea", frame.from, sea, frame.from + frame.wide, sea) +
           text_svg(frame.from + frame.wide - 4, sea - 4, "sea level",
                    "class=\"number\" text-anchor=\"end\"");
  }
  return svg;
}

/// N, E, S and W where they are on a sheet that goes all round.
std::string compass_svg(const CoverageSheet& sheet, const Frame& frame) {
  constexpr const char* names[] = {"N", "E", "S", "W"};
  std::string svg;
  const auto put = [&](double along_m, const char* name) {
    const double x = frame.x(along_m);
    svg += line_svg("tick", x, top - 6, x, top) +
           line_svg("meridian", x, top, x, top + frame.high) +
           text_svg(x, top - 10, name, "class=\"compass\" text-anchor=\"middle\"");
  };
  for (int k = 0; k < 4; ++k) {
    const double turn = compass_deg(90.0 * k - sheet.first_bearing_deg);
    put(turn / 360 * sheet.width_m, names[k]);
    if (turn == 0) put(sheet.width_m, names[k]);
  }
  return svg;
}

std::string north_svg(double turn_deg, const Frame& frame) {
  const double x = frame.from + frame.wide - 12, y = 20;
  return formatted(
             "<g transform=\"translate({:.1f} {:.1f}) rotate({:.1f})\"><path class=\"arrow\" "
             "d=\"M0 12V-8\"/><path class=\"mark full\" d=\"M0-13l4 8h-8z\"/></g>",
             x, y, turn_deg) +
         text_svg(x - 14, y + 4, "N", "class=\"compass\" text-anchor=\"end\"");
}

std::string scale_svg(const CoverageSheet& sheet, const Frame& frame) {
  const double bar_m = round_length(sheet.width_m / 3);
  const double y = top + frame.high + 16, x = frame.from, to = frame.x(bar_m);
  std::string words = formatted("{:g} m", bar_m);
  const double stretch = sheet_stretch(sheet);
  const auto times = [](double ratio) {
    return ratio < 9.5 ? formatted("{:.1f}", ratio) : formatted("{:.0f}", ratio);
  };
  if (stretch > 1.01) words += " along; down drawn " + times(stretch) + " times as long";
  if (stretch < 0.99) words += " along, drawn " + times(1 / stretch) + " times as long as down";
  return formatted("<path class=\"bar\" d=\"M{:.1f} {:.1f}v8v-4H{:.1f}v-4v8\"/>", x, y, to) +
         text_svg(to + 8, y + 8, words) +
         text_svg(left + most_wide / 2, y + 34, sheet.along,
                  "class=\"axis\" text-anchor=\"middle\"");
}

}  // namespace

double round_length(double length) noexcept {
  const double power = std::pow(10, std::floor(std::log10(length)));
  for (const double lead : {5.0, 2.0})
    if (lead * power <= length * (1 + 1e-12)) return lead * power;
  return power;
}

double sheet_stretch(const CoverageSheet& sheet) noexcept {
  const Frame frame(sheet);
  return frame.y_per_m / frame.x_per_m;
}

std::optional<double> north_on_sheet_deg(const InspectionCoverage& coverage) {
  double area = 0, up = 0;
  std::array<double, 4> mean{};  // along, down, east, north
  const auto values_of = [](const CoveragePatch& p) {
    return std::array<double, 4>{p.along_m, p.down_m, p.centre_m.x(), p.centre_m.y()};
  };
  for (const CoveragePatch& patch : coverage.patches) {
    area += patch.area_m2;
    up += patch.area_m2 * patch.normal.z();
    for (std::size_t k = 0; k < 4; ++k) mean[k] += patch.area_m2 * values_of(patch)[k];
  }
  if (!(area > 0) || up < 0.8 * area) return std::nullopt;
  for (double& value : mean) value /= area;
  // Least squares of east and north over the sheet.
  double aa = 0, ad = 0, dd = 0, ea = 0, ed = 0, na = 0, nd = 0;
  for (const CoveragePatch& patch : coverage.patches) {
    auto v = values_of(patch);
    for (std::size_t k = 0; k < 4; ++k) v[k] -= mean[k];
    aa += v[0] * v[0], ad += v[0] * v[1], dd += v[1] * v[1];
    ea += v[2] * v[0], ed += v[2] * v[1], na += v[3] * v[0], nd += v[3] * v[1];
  }
  const double square = aa * dd - ad * ad;
  if (!(square > 1e-12 * aa * dd)) return std::nullopt;
  const double east_along = (ea * dd - ed * ad) / square, east_down = (ed * aa - ea * ad) / square;
  const double north_along = (na * dd - nd * ad) / square;
  const double north_down = (nd * aa - na * ad) / square;
  const double turn = east_along * north_down - east_down * north_along;
  if (std::abs(turn) < 0.3) return std::nullopt;
  // The way along the sheet that leads north and not east.
  const double along = -east_down / turn, down = east_along / turn;
  return Angle::from_radians(std::atan2(along, -down)).degrees();
}

std::string sheet_svg(const InspectionCoverage& coverage, const std::vector<CoverageMark>& marks) {
  const CoverageSheet& sheet = coverage.sheet;
  const Frame frame(sheet);
  const auto shares = coverage.shares();
  std::string label = "Sheet of " + coverage.name() + ": ";
  for (std::size_t s = 0; s < patch_states; ++s)
    label += formatted("{:.0f} % {}, ", 100 * shares[s], coverage.words[s]);
  label += formatted("{} marks", marks.size());
  std::string svg = formatted("<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {:g} {:.0f}\">",
                              escaped_html(label), picture_wide, top + frame.high + bottom);
  svg += cells_svg(raster_of(coverage, sheet_columns, sheet_rows), frame);
  svg += formatted(
      "<rect class=\"edge\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
      "height=\"{:.1f}\"/>",
      frame.from, top, frame.wide, frame.high);
  if (sheet.is_all_round) svg += compass_svg(sheet, frame);
  if (const auto north = north_on_sheet_deg(coverage)) svg += north_svg(*north, frame);
  svg += side_svg(sheet, frame) + scale_svg(sheet, frame);
  for (const CoverageMark& mark : marks)
    svg += mark_svg(mark, frame.x(mark.along_m), frame.y(mark.down_m));
  return svg + "</svg>";
}

}  // namespace slackwater::api
