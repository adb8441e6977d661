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

AlphaPractice AlphaPractice::of_tables(const std::vector<std::filesystem::path>& files) {
  AlphaPractice practice;
  const std::filesystem::path ours = data_folder() / "alpha" / "dnv_os_h101_table_4_1.yaml";
  for (const auto& file : files.empty() ? std::vector{ours} : files) {
    AlphaTable table = twin::read_alpha_table(Config::load(file));
    for (const AlphaTable& other : practice.tables_)
      if (other.variable == table.variable)
        throw Error(ErrorKind::invalid_input, file.string() + ": found a second table for " +
                                                  twin::word_of(table.variable).key +
                                                  "; give one for each variable");
    practice.tables_.push_back(std::move(table));
  }
  return practice;
}

AlphaPractice AlphaPractice::of_errors(twin::HeightErrors errors) {
  AlphaPractice practice;
  practice.errors_ = std::move(errors);
  return practice;
}

std::optional<AlphaFactor> AlphaPractice::at(const twin::Limit& limit, double period_h) const {
  if (limit.is_least) return std::nullopt;
  if (errors_) {
    if (limit.variable != LimitVariable::significant_wave_height) return std::nullopt;
    const double longest_h = errors_->leads_h.back();
    if (period_h > longest_h)
      return AlphaFactor{
          {},
          formatted(
              "the task ends {:.0f} h after the forecast was issued; errors are known up to {:g} h",
              period_h, longest_h)};
    return AlphaFactor{twin::alpha_by_errors(limit.bound, errors_->at(limit.bound, period_h)), ""};
  }
  for (const AlphaTable& table : tables_)
    if (table.variable == limit.variable) return table.at(period_h, limit.bound);
  return std::nullopt;
}

std::string AlphaPractice::name() const {
  if (errors_) return "worked out from forecast errors: " + errors_->name;
  std::vector<std::string> names;
  for (const AlphaTable& table : tables_) names.push_back(table.name);
  return joined(names, "; ");
}

std::string AlphaPractice::source() const {
  if (errors_) return errors_->source;
  std::vector<std::string> sources;
  for (const AlphaTable& table : tables_) sources.push_back(table.source);
  return joined(sources, "; ");
}

twin::HeightErrors published_height_errors() {
  return twin::read_height_errors(Config::load(data_folder() / "alpha" / "height_errors.yaml"));
}

}  // namespace slackwater::api
