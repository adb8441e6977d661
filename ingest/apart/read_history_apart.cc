#include "ingest/apart/read_history_apart.h"

#include "ingest/apart/value_apart.h"

namespace slackwater {

template <typename Archive>
void serialize(Archive& archive, HistorySeries& series) {
  auto& [name, standard_name, unit, source, time, value, is_single_precision] = series;
  archive(name, standard_name, unit, source, time, value, is_single_precision);
}

namespace ingest {

template <typename Archive>
void serialize(Archive& archive, HistoryOfFile& history) {
  auto& [series, columns, offered, warnings] = history;
  archive(series, columns, offered, warnings);
}

HistoryOfFile read_history_apart(const std::filesystem::path& file,
                                 const std::vector<std::string>& wanted,
                                 const HistoryOptions& options, const Vocabulary& vocabulary) {
  const auto expect_whole = [&](const HistoryOfFile& history) {
    bool is_whole = history.series.size() == wanted.size();
    for (const auto& series : history.series)
      is_whole = is_whole && (!series || series->time.size() == series->value.size());
    if (!is_whole) refuse("its reader told of other series than were wanted");
  };
  return value_apart<HistoryOfFile>(
      file, [&] { return read_history(file, wanted, options, vocabulary); }, expect_whole);
}

}  // namespace ingest
}  // namespace slackwater
