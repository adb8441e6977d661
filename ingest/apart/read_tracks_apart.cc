#include "ingest/apart/read_tracks_apart.h"

#include "ingest/apart/packed.h"
#include "ingest/apart/read_apart.h"

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

TrajectoryFile read_tracks_apart(const std::filesystem::path& file) {
  if (!is_alone()) return read_trajectories(file);
  return unpacked<TrajectoryFile>(read_apart(file, allowance_for(file), [&](const TellShare&) {
    return packed(read_trajectories(file));
  }));
}

}  // namespace slackwater::ingest
