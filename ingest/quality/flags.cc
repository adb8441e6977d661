#include "ingest/quality/flags.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fields/base/text.h"

namespace slackwater::ingest {
namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == ';' || c == '\0') {
      if (!word.empty()) words.push_back(std::move(word));
      word.clear();
    } else {
      word += c;
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

using Table = std::map<long, SampleStatus>;

const Table& oceansites_table() {
  using enum SampleStatus;
  static const Table table{{0, not_checked}, {1, ok},          {2, ok}, {3, suspect}, {4, suspect},
                           {5, ok},          {6, not_checked}, {7, ok}, {8, ok},      {9, missing}};
  return table;
}

const Table& seadatanet_table() {
  using enum SampleStatus;
  static const Table table{{0, not_checked}, {1, ok}, {2, ok},      {3, suspect}, {4, suspect},
                           {5, ok},          {6, ok}, {7, suspect}, {8, ok},      {9, missing}};
  return table;
}

/// IOOS QARTOD flags (Manual for the Use of Real-Time Oceanographic Data Quality Control Flags,
/// table 1).
const Table& qartod_table() {
  using enum SampleStatus;
  static const Table table{{1, ok}, {2, not_checked}, {3, suspect}, {4, suspect}, {9, missing}};
  return table;
}

const Table* named_table(std::string_view conventions) {
  const std::string name = lower_case(conventions);
  if (holds(name, "seadatanet") || holds(name, "bodc")) return &seadatanet_table();
  if (holds(name, "qartod")) return &qartod_table();
  for (const auto* known : {"oceansites", "copernicus", "imos", "argo", "myocean"}) {
    if (holds(name, known)) return &oceansites_table();
  }
  return nullptr;
}

}  // namespace

SampleStatus status_of_meaning(std::string_view meaning) noexcept {
  using enum SampleStatus;
  const auto says = [&](std::string_view part) {
    return std::search(meaning.begin(), meaning.end(), part.begin(), part.end(),
                       [](char a, char b) {
                         return std::tolower(static_cast<unsigned char>(a)) == b;
                       }) != meaning.end();
  };
  if (says("no_qc") || says("no_quality") || says("not_evaluated") || says("not_checked") ||
      says("unchecked") || says("not_used") || says("unknown")) {
    return not_checked;
  }
  if (says("missing")) return missing;
  if (says("bad") || says("fail") || says("suspect") || says("questionable") || says("excess") ||
      says("erroneous")) {
    return suspect;
  }
  if (says("good") || says("pass") || says("changed") || says("nominal") || says("interpolated") ||
      says("below_detection")) {
    return ok;
  }
  return not_checked;
}

std::optional<FlagScheme> FlagScheme::from_attributes(std::span<const double> flag_values,
                                                      std::string_view flag_meanings,
                                                      std::string_view conventions) {
  FlagScheme scheme;
  const std::vector<std::string> meanings = words_of(flag_meanings);
  if (!meanings.empty() && meanings.size() == flag_values.size()) {
    for (std::size_t i = 0; i < meanings.size(); ++i) {
      if (!std::isfinite(flag_values[i]) || std::abs(flag_values[i]) > 1e9) continue;
      scheme.status_of_flag_[std::lround(flag_values[i])] = status_of_meaning(meanings[i]);
    }
    return scheme;
  }
  const Table* table = named_table(conventions);
  if (table == nullptr) return std::nullopt;
  scheme.status_of_flag_ = *table;
  return scheme;
}

SampleStatus FlagScheme::status_of(long flag) const noexcept {
  const auto found = status_of_flag_.find(flag);
  return found == status_of_flag_.end() ? SampleStatus::not_checked : found->second;
}

}  // namespace slackwater::ingest
