#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/published/profile_level.h"

// The profiles of the published evaluation (calibration/docs/published_evaluation.md): one CSV a
// date, its figures in a table beside them.

namespace slackwater::tests {

struct PublishedProfile {
  std::string date;
  std::vector<calibration::ProfileLevel> levels;  ///< by depth
};

/// What the published model reached on one date.
struct PublishedAccuracy {
  double eps_m_s = 0;
  double eps_constant_m_s = 0;
  double reduction_percent = 0;
};

/// The rows below the header, as numbers and words; the end of a line may be CR LF.
inline std::vector<std::vector<std::string>> csv_rows(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file.string());
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(in, line);  // header
  while (std::getline(in, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(cell);
    rows.push_back(cells);
  }
  return rows;
}

/// Every profile of the folder (brest_DATE.csv: depth_m, vx_north_ms, vy_east_ms), by date, native
/// levels down to `deepest_m`.
inline std::vector<PublishedProfile> published_profiles(const std::filesystem::path& folder,
                                                        double deepest_m) {
  std::vector<PublishedProfile> profiles;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    const std::string stem = entry.path().stem().string();
    PublishedProfile profile{stem.substr(stem.find('_') + 1), {}};
    for (const auto& row : csv_rows(entry.path())) {
      const double depth_m = std::stod(row.at(0));
      if (depth_m <= deepest_m)
        profile.levels.push_back({depth_m, {std::stod(row.at(2)), std::stod(row.at(1))}});
    }
    profiles.push_back(profile);
  }
  std::sort(profiles.begin(), profiles.end(),
            [](const PublishedProfile& a, const PublishedProfile& b) { return a.date < b.date; });
  return profiles;
}

/// By date, from published_field_accuracy.csv; dates without a profile here are harmless.
inline std::map<std::string, PublishedAccuracy> published_accuracy(
    const std::filesystem::path& file) {
  std::map<std::string, PublishedAccuracy> table;
  for (const auto& row : csv_rows(file))
    table[row.at(0)] = {std::stod(row.at(4)), std::stod(row.at(5)), std::stod(row.at(6))};
  return table;
}

}  // namespace slackwater::tests
