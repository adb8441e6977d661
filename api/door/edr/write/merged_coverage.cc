#include "api/door/edr/write/merged_coverage.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "api/door/edr/sample/answer_shape.h"
#include "api/door/edr/write/union_axis.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"

namespace slackwater::api::edr {
namespace {

using ingest::CoverageLayout;
using ingest::CoverageVariable;
using ingest::SampledFile;

/// UCUM, which answers speak, in the words of UDUNITS, which CF wants.
std::string udunits_of(const std::string& ucum) {
  static const std::map<std::string, std::string> words{
      {"m/s", "m s-1"},  {"m2/s", "m2 s-1"},        {"kg/m3", "kg m-3"},
      {"deg", "degree"}, {"Cel", "degree_Celsius"}, {"m/s2", "m s-2"}};
  const auto found = words.find(ucum);
  return found == words.end() ? ucum : found->second;
}

bool is_the_value(const Parameter& parameter) {
  return parameter.method.empty() || parameter.method == "central" || parameter.method == "product";
}

/// As in the forecast file, a quantile or a member does not bear the standard name: what looks for
/// it finds the central forecast alone.
std::string standard_name_of(const Parameter& parameter) {
  return is_the_value(parameter) ? parameter.standard_name : std::string();
}

std::string long_name_of(const Parameter& parameter) {
  const std::string name = parameter.label.empty() ? parameter.name : parameter.label;
  return is_the_value(parameter) ? name : name + " (" + parameter.method + ")";
}

class Merger {
 public:
  explicit Merger(const Answer& answer) : answer_(answer) {}

  SampledFile merge() {
    file_.is_depth = answer_.vertical != Vertical::height_up;
    for (const Parameter& parameter : answer_.parameters) {
      file_.variables.push_back({parameter.name,
                                 standard_name_of(parameter),
                                 long_name_of(parameter),
                                 udunits_of(parameter.unit),
                                 {}});
    }
    if (answer_.coverages.front().domain == DomainType::trajectory) {
      trajectories();
    } else {
      arrays();
    }
    return std::move(file_);
  }

 private:
  std::string name_of(std::size_t i) const {
    const std::string& id = answer_.coverages[i].id;
    return id.empty() ? std::to_string(i + 1) : id;
  }

  void trajectories() {
    file_.layout = CoverageLayout::trajectories;
    for (std::size_t c = 0; c < answer_.coverages.size(); ++c) {
      const Coverage& line = answer_.coverages[c];
      file_.names.push_back(name_of(c));
      file_.lengths.push_back(line.longitude_deg.size());
      for (std::size_t i = 0; i < line.longitude_deg.size(); ++i) {
        file_.longitude_deg.push_back(line.longitude_deg[i]);
        file_.latitude_deg.push_back(line.latitude_deg[i]);
        file_.time.push_back(at_vertex(line.time, i));
        if (has_vertical(answer_)) {
          expects(!line.vertical_m.empty(), "all lines of an answer have levels, or none");
          file_.vertical_m.push_back(at_vertex(line.vertical_m, i));
        }
      }
      for (std::size_t p = 0; p < line.values.size(); ++p) {
        auto& values = file_.variables[p].values;
        values.insert(values.end(), line.values[p].begin(), line.values[p].end());
      }
    }
  }

  void arrays() {
    const bool is_grid = answer_.coverages.front().domain == DomainType::grid;
    file_.layout = is_grid ? CoverageLayout::grid : CoverageLayout::stations;
    for (std::size_t c = 0; c < answer_.coverages.size(); ++c) {
      const Coverage& part = answer_.coverages[c];
      time_.add(part.time);
      level_.add(part.vertical_m);
      if (is_grid) {
        x_.add(part.longitude_deg);
        y_.add(part.latitude_deg);
      } else {
        add_station(part, name_of(c));
      }
    }
    time_.settle();
    level_.settle();
    x_.settle();
    y_.settle();
    const std::size_t places = is_grid ? x_.size() * y_.size() : stations_.size();
    make_room(places);
    for (std::size_t c = 0; c < answer_.coverages.size(); ++c) {
      is_grid ? put_grid(answer_.coverages[c]) : put_station(answer_.coverages[c]);
    }
    file_.time = time_.all;
    file_.vertical_m = level_.all;
    if (is_grid) {
      file_.longitude_deg = x_.all;
      file_.latitude_deg = y_.all;
    }
  }

  static std::pair<double, double> place_of(const Coverage& part) {
    return {part.longitude_deg.front(), part.latitude_deg.front()};
  }

  void add_station(const Coverage& part, const std::string& name) {
    if (!stations_.emplace(place_of(part), stations_.size()).second) return;
    file_.longitude_deg.push_back(part.longitude_deg.front());
    file_.latitude_deg.push_back(part.latitude_deg.front());
    file_.names.push_back(name);
  }

  /// Checks the size of the union, and fills it with what is missing.
  void make_room(std::size_t places) {
    constexpr std::size_t most_per_point = 16;
    constexpr std::size_t always_fits = std::size_t{1} << 20U;
    std::size_t points = 0;
    for (const Coverage& part : answer_.coverages) points += shape_of(part).size();
    const double size = static_cast<double>(places) * static_cast<double>(time_.size()) *
                        static_cast<double>(level_.size());
    if (size > static_cast<double>(always_fits) &&
        size > static_cast<double>(most_per_point) * static_cast<double>(points)) {
      throw Error(ErrorKind::usage,
                  "f: found 'NetCDF' for " + std::to_string(answer_.coverages.size()) +
                      " domains whose places, times and levels differ; expected domains that share "
                      "axes; ask for one at a time, or for f=CoverageJSON or f=CSV");
    }
    const std::size_t all = places * time_.size() * level_.size();
    for (CoverageVariable& variable : file_.variables) {
      variable.values.assign(all, constants::nan);
    }
  }

  /// Copies values of a part to where they stand in the file.
  void put(std::size_t to, const Coverage& part, std::size_t from) {
    for (std::size_t p = 0; p < part.values.size(); ++p) {
      file_.variables[p].values[to] = part.values[p][from];
    }
  }

  void put_station(const Coverage& part) {
    const std::size_t station = stations_.at(place_of(part));
    std::size_t from = 0;
    for (const std::size_t t : time_.places(part.time)) {
      for (const std::size_t z : level_.places(part.vertical_m)) {
        put((station * time_.size() + t) * level_.size() + z, part, from++);
      }
    }
  }

  void put_grid(const Coverage& part) {
    const AxisLengths whole{time_.size(), level_.size(), y_.size(), x_.size()};
    const auto levels = level_.places(part.vertical_m);
    const auto rows = y_.places(part.latitude_deg);
    const auto columns = x_.places(part.longitude_deg);
    std::size_t from = 0;
    for (const std::size_t t : time_.places(part.time)) {
      for (const std::size_t z : levels) {
        for (const std::size_t y : rows) {
          for (const std::size_t x : columns) put(whole.index(t, z, y, x), part, from++);
        }
      }
    }
  }

  const Answer& answer_;
  SampledFile file_;
  UnionAxis<UtcTime> time_;
  UnionAxis<double> level_;
  UnionAxis<double> x_;
  UnionAxis<double> y_;
  std::map<std::pair<double, double>, std::size_t> stations_;
};

}  // namespace

SampledFile merged_coverage(const Answer& answer) {
  expect_whole(answer);
  expects(!answer.coverages.empty(), "merged_coverage: an answer with a coverage");
  return Merger(answer).merge();
}

}  // namespace slackwater::api::edr
