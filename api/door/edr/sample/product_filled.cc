#include "api/door/edr/sample/product_filled.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "fields/record/cadence.h"

namespace slackwater::api::edr {
namespace {

/// How many times, levels and places values are of.
struct Block {
  std::size_t times = 0;
  std::size_t levels = 0;
  std::size_t places = 0;
};

/// One place out of a block of many.
std::vector<double> of_place(const std::vector<double>& values, const Block& block,
                             std::size_t place) {
  std::vector<double> out;
  out.reserve(block.times * block.levels);
  for (std::size_t i = 0; i < block.times * block.levels; ++i)
    out.push_back(values[i * block.places + place]);
  return out;
}

/// Its places spread over the cells of a grid.
std::vector<double> on_cells(const std::vector<double>& values, const Block& block,
                             const Places& places) {
  const std::size_t cells = places.longitude_deg.size() * places.latitude_deg.size();
  std::vector<double> out(block.times * block.levels * cells, std::nan(""));
  for (std::size_t i = 0; i < block.times * block.levels; ++i)
    for (std::size_t p = 0; p < block.places; ++p)
      out[i * cells + places.cell[p]] = values[i * block.places + p];
  return out;
}

/// How many levels from the first on have a value anywhere; one at least.
std::size_t levels_with_values(const ProductValues& values, const Block& block) {
  std::size_t count = 1;
  const std::vector<double>& first = values.value.front();
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::size_t level = i / block.places % block.levels;
    if (level >= count && !std::isnan(first[i])) count = level + 1;
  }
  return count;
}

/// Without the levels behind the first `count`.
void cut_levels(ProductValues& values, Block& block, std::size_t count) {
  for (std::vector<double>& all : values.value) {
    std::vector<double> kept;
    kept.reserve(block.times * count * block.places);
    for (std::size_t t = 0; t < block.times; ++t) {
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(t * block.levels * block.places);
      kept.insert(kept.end(), begin, begin + static_cast<std::ptrdiff_t>(count * block.places));
    }
    all = std::move(kept);
  }
  values.absent.resize(count);
  block.levels = count;
}

std::size_t absent(const ProductValues& values, SampleStatus status) {
  std::size_t count = 0;
  for (const auto& level : values.absent) count += level[static_cast<std::size_t>(status)];
  return count;
}

/// What is not given of an instrument, and why.
void add_quality_note(const ProductValues& values, std::vector<std::string>& notes) {
  std::string left_out;
  const auto add = [&](SampleStatus status, const char* words) {
    if (const std::size_t count = absent(values, status); count > 0)
      left_out += (left_out.empty() ? "" : ", ") + std::to_string(count) + words;
  };
  add(SampleStatus::not_checked, " that nobody checked");
  add(SampleStatus::suspect, " that were rejected");
  add(SampleStatus::missing, " missing");
  notes.push_back("values of good quality alone; not given: " +
                  (left_out.empty() ? std::string("none") : left_out));
}

void add_notes(const StoredProduct& product, const ProductValues& values, std::size_t damaged,
               std::vector<std::string>& notes) {
  if (product.is_measured()) add_quality_note(values, notes);
  for (std::size_t i = 0; i < sample_status_count; ++i) {
    const auto status = static_cast<SampleStatus>(i);
    const std::size_t count = absent(values, status);
    if (count == 0 || product.is_measured()) continue;
    notes.push_back(std::to_string(count) + " places and times without a value: " +
                    std::string(name_of(status)) + "; " + held_text(product));
  }
  if (values.averaged > Duration(0)) {
    notes.push_back(
        formatted("values are means over {:g} h about their times", hours_of(values.averaged)));
  }
  if (values.most_members > 0)
    notes.push_back("means of " + std::to_string(values.most_members) + " members of an ensemble");
  if (values.contains_stokes) notes.emplace_back("the currents hold Stokes drift");
  if (damaged > 0)
    notes.push_back("left out: " + counted(damaged, "stored file") + " of the product, damaged");
}

}  // namespace

Answer filled(const Asked& asked, const ProductView& view, const Places& places,
              std::vector<UtcTime> times, std::vector<double> levels,
              std::vector<std::string> notes) {
  const StoredProduct& product = *asked.product;
  const bool has_own = places.has_own_levels;
  ProductValues values =
      view.values(places.point, times, levels,
                  has_own ? ProductView::Levels::one_for_each : ProductView::Levels::all_at_each);
  Block block{times.size(), has_own ? 1 : std::max<std::size_t>(1, levels.size()),
              places.point.size()};
  if (!places.is_grid &&
      absent(values, SampleStatus::land) == block.times * block.levels * block.places) {
    throw outside(product, formatted("coords at {:.5f} {:.5f} on land, as the product has it: ask "
                                     "at a place in the water, or an area that reaches it",
                                     places.longitude_deg.front(), places.latitude_deg.front()));
  }
  if (!asked.z && block.levels > 1) {
    const std::size_t count = levels_with_values(values, block);
    cut_levels(values, block, count);
    levels.resize(count);
  }
  Answer answer;
  answer.collection = product.id;
  answer.title = title_of(product);
  answer.vertical = vertical_of(product);
  for (const std::size_t i : asked.parameters) answer.parameters.push_back(asked.all[i]);
  answer.notes = std::move(notes);
  add_notes(product, values, view.damaged(), answer.notes);
  if (!std::all_of(levels.begin(), levels.end(),
                   [&](double level) { return is_held(level, view.levels_m()); })) {
    answer.notes.push_back("levels that the product does not reach have no value: it holds " +
                           levels_text(product, view.levels_m()));
  }
  answer.provenance.attributions = product.attributions;
  answer.provenance.product = ProductSource{product.product_id,
                                            product.dataset_id,
                                            {values.runs.begin(), values.runs.end()},
                                            {values.sources.begin(), values.sources.end()}};
  const std::vector<std::vector<double>> all =
      values_of(product, asked.parameters, std::move(values.value));
  const auto coverage_at = [&](DomainType domain, std::vector<double> x, std::vector<double> y) {
    Coverage coverage;
    coverage.domain = domain;
    coverage.longitude_deg = std::move(x);
    coverage.latitude_deg = std::move(y);
    coverage.vertical_m = levels;
    coverage.time = times;
    return coverage;
  };
  if (places.is_grid) {
    Coverage coverage = coverage_at(DomainType::grid, places.longitude_deg, places.latitude_deg);
    for (const auto& each : all) coverage.values.push_back(on_cells(each, block, places));
    answer.coverages.push_back(std::move(coverage));
    return answer;
  }
  for (std::size_t p = 0; p < places.point.size(); ++p) {
    Coverage coverage = coverage_at(domain_at_point(times.size(), has_own ? 1 : levels.size()),
                                    {places.longitude_deg[p]}, {places.latitude_deg[p]});
    if (has_own) coverage.vertical_m = {levels[p]};
    for (const auto& each : all) coverage.values.push_back(of_place(each, block, p));
    answer.coverages.push_back(std::move(coverage));
  }
  return answer;
}

}  // namespace slackwater::api::edr
