#include "ingest/apart/read_history_apart.h"

#include "ingest/apart/packed.h"
#include "ingest/apart/read_apart.h"

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
  const std::string bytes = read_apart(file, allowance_for(file), [&](const TellShare&) {
    return packed(read_history(file, wanted, options, vocabulary));
  });
  return unpacked<HistoryOfFile>(bytes);
}

}  // namespace ingest
}  // namespace slackwater
