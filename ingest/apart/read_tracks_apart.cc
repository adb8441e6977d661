#include "ingest/apart/read_tracks_apart.h"

#include "ingest/apart/value_apart.h"

namespace slackwater::ingest {

template <typename Archive>
void serialize(Archive& archive, TrajectoryTable::Column& column) {
  auto& [name, units, long_name, values] = column;
  archive(name, units, long_name, values);
}
template <typename Archive>
void serialize(Archive& archive, TrajectoryTable::TextColumn& column) {
  auto& [name, long_name, values] = column;
  archive(name, long_name, values);
}
template <typename Archive>
void serialize(Archive& archive, TrajectoryTable& table) {
  auto& [name, columns, texts] = table;
  archive(name, columns, texts);
}
template <typename Archive>
void serialize(Archive& archive, TrajectoryFile::Variable& variable) {
  auto& [name, standard_name, units, long_name, per, values] = variable;
  archive(name, standard_name, units, long_name, per, values);
}
template <typename Archive>
void serialize(Archive& archive, TrajectoryFile& tracks) {
  auto& [names, epoch, t_s, variables, tables, attributes] = tracks;
  archive(names, epoch, t_s, variables, tables, attributes);
}

namespace {

/// What `read_trajectories` promises, whoever took its process over.
void expect_whole_tracks(const TrajectoryFile& tracks) {
  const std::size_t rows = tracks.names.size() * tracks.t_s.size();
  bool is_whole = true;
  for (const TrajectoryFile::Variable& one : tracks.variables)
    is_whole = is_whole && one.per > 0 && one.values.size() / one.per == rows &&
               one.values.size() % one.per == 0;
  for (const TrajectoryTable& table : tracks.tables) {
    for (const auto& column : table.columns)
      is_whole = is_whole && column.values.size() == table.rows();
    for (const auto& text : table.texts) is_whole = is_whole && text.values.size() == table.rows();
  }
  if (!is_whole) refuse("its reader told of other rows than there are");
}

}  // namespace

TrajectoryFile read_tracks_apart(const std::filesystem::path& file) {
  if (!is_alone()) return read_trajectories(file);
  return value_apart<TrajectoryFile>(
      file, [&] { return read_trajectories(file); }, expect_whole_tracks);
}

}  // namespace slackwater::ingest
