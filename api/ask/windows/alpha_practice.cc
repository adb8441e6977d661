#include "api/ask/windows/alpha_practice.h"

#include <algorithm>
#include <cmath>

#include "api/program/paths.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {

using twin::AlphaFactor;
using twin::AlphaTable;
using twin::LimitVariable;

bool AlphaPractice::has(LimitVariable variable) const {
  return (errors_ && variable == LimitVariable::significant_wave_height) ||
         std::any_of(tables_.begin(), tables_.end(),
                     [&](const AlphaTable& table) { return table.variable == variable; });
}

void AlphaPractice::add(const std::filesystem::path& file) {
  AlphaTable table = twin::read_alpha_table(Config::load(file));
  const std::string of = std::string(" for ") + twin::word_of(table.variable).key;
  if (errors_ && table.variable == LimitVariable::significant_wave_height)
    throw Error(ErrorKind::usage, "--alpha: found errors beside the table " + file.string() + of +
                                      "; give one of them");
  if (has(table.variable))
    throw Error(ErrorKind::invalid_input,
                file.string() + ": found a second table" + of + "; give one for each variable");
  tables_.push_back(std::move(table));
}

AlphaPractice AlphaPractice::of_tables(const std::vector<std::filesystem::path>& files) {
  AlphaPractice practice;
  for (const auto& file : files) practice.add(file);
  if (!practice.has(LimitVariable::significant_wave_height)) {
    practice.add(data_folder() / "alpha" / "dnv_os_h101_table_4_1.yaml");
    std::rotate(practice.tables_.begin(), practice.tables_.end() - 1, practice.tables_.end());
  }
  return practice;
}

AlphaPractice AlphaPractice::of_errors(twin::HeightErrors errors,
                                       const std::vector<std::filesystem::path>& files) {
  AlphaPractice practice;
  practice.errors_ = std::move(errors);
  for (const auto& file : files) practice.add(file);
  return practice;
}

std::optional<AlphaFactor> AlphaPractice::at(const twin::Limit& limit, double bound,
                                             double period_h) const {
  if (limit.is_least) return std::nullopt;
  if (errors_ && limit.variable == LimitVariable::significant_wave_height) {
    const double longest_h = errors_->leads_h.back();
    if (period_h > longest_h)
      return AlphaFactor{
          {},
          formatted(
              "the task ends {:.0f} h after the forecast was issued; errors are known up to {:g} h",
              period_h, longest_h)};
    return AlphaFactor{twin::alpha_by_errors(bound, errors_->at(bound, period_h)), ""};
  }
  for (const AlphaTable& table : tables_)
    if (table.variable == limit.variable) return table.at(period_h, bound);
  return std::nullopt;
}

std::string AlphaPractice::name() const {
  std::vector<std::string> names;
  if (errors_) names.push_back("worked out from forecast errors: " + errors_->name);
  for (const AlphaTable& table : tables_)
    names.push_back(tables_.size() == 1 && !errors_
                        ? table.name
                        : table.name + " (" + twin::word_of(table.variable).meaning + ")");
  return joined(names, "; ");
}

std::string AlphaPractice::source() const {
  std::vector<std::string> sources;
  if (errors_) sources.push_back(errors_->source);
  for (const AlphaTable& table : tables_) sources.push_back(table.source);
  return joined(sources, "; ");
}

twin::HeightErrors published_height_errors() {
  return twin::read_height_errors(Config::load(data_folder() / "alpha" / "height_errors.yaml"));
}

}  // namespace slackwater::api
