#include "data/bag/rosbag_folder.h"

#include <algorithm>
#include <queue>

#include "data/bag/channel_table.h"
#include "data/bag/input_file.h"
#include "data/bag/mcap_bag.h"
#include "data/bag/rosbag_file.h"
#include "fields/base/config.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
  throw Error(ErrorKind::invalid_input, path.string() + " " + what);
}

std::vector<fs::path> files_in_metadata(const fs::path& folder) {
  const Config file = Config::load(folder / "metadata.yaml");
  const Config metadata = file.child("rosbag2_bagfile_information");
  const std::string mode = metadata.optional_text("compression_mode").value_or("");
  if (!mode.empty() && mode != "none" && mode != "NONE") {
    refuse(folder, "is compressed by rosbag2 (compression_mode '" + mode.substr(0, 40) +
                       "'), which is not read; unpack it with `ros2 bag convert`");
  }
  std::vector<fs::path> files;
  for (const std::string& name : metadata.texts("relative_file_paths")) {
    // Up to version 3 these began with the folder's name.
    files.push_back(folder / fs::path(name).filename());
    if (!fs::is_regular_file(files.back())) {
      throw Error(ErrorKind::not_found, folder.string() + ": its metadata.yaml names " +
                                            files.back().filename().string() +
                                            ", which is not there; copy the whole folder");
    }
  }
  return files;
}

std::vector<fs::path> files_by_name(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto ending = entry.path().extension();
    if (entry.is_regular_file() && (ending == ".db3" || ending == ".mcap"))
      files.push_back(entry.path());
  }
  // _2 before _10.
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    const std::string left = a.filename().string();
    const std::string right = b.filename().string();
    return std::pair(left.size(), left) < std::pair(right.size(), right);
  });
  return files;
}

/// When the next message of a file comes.
struct FileTurn {
  std::int64_t time_ns = 0;
  std::size_t file = 0;  ///< of two at one time the earlier file
  bool operator>(const FileTurn& other) const {
    return std::pair(time_ns, file) > std::pair(other.time_ns, other.file);
  }
};

class SeveralFiles : public Bag {
 public:
  explicit SeveralFiles(std::vector<fs::path> paths) {
    for (fs::path& path : paths) {
      const auto bag = open_file(path);
      File& file = files_.emplace_back();
      file.path = std::move(path);
      for (const Channel& channel : bag->channels()) file.channels.push_back(table_.add(channel));
      warnings_.insert(warnings_.end(), bag->warnings().begin(), bag->warnings().end());
      if (const auto first = bag->next()) turns_.push({first->log_time_ns, files_.size() - 1});
    }
  }

  const std::vector<Channel>& channels() const noexcept override { return table_.channels(); }
  const std::vector<std::string>& warnings() const noexcept override { return warnings_; }

  std::optional<Recorded> next() override {
    if (handed_out_) go_on(*handed_out_);
    handed_out_.reset();
    if (turns_.empty()) return std::nullopt;
    const FileTurn turn = turns_.top();
    turns_.pop();
    File& file = files_[turn.file];
    if (file.bag == nullptr) {
      file.bag = open_file(file.path);
      file.next = file.bag->next();
    }
    if (!file.next || file.next->channel >= file.channels.size())
      refuse(file.path, "changed while it was read");
    handed_out_ = turn.file;
    Recorded message = *file.next;
    message.channel = file.channels[message.channel];
    return message;
  }

 private:
  struct File {
    fs::path path;
    std::vector<std::size_t> channels;  ///< of all files, for each of its own
    std::unique_ptr<Bag> bag;           ///< once its time has come
    std::optional<Recorded> next;
  };

  void go_on(std::size_t index) {
    File& file = files_[index];
    file.next = file.bag->next();
    if (file.next) {
      turns_.push({file.next->log_time_ns, index});
    } else {
      file.bag.reset();
    }
  }

  ChannelTable table_;
  std::vector<File> files_;
  std::vector<std::string> warnings_;
  std::priority_queue<FileTurn, std::vector<FileTurn>, std::greater<>> turns_;
  std::optional<std::size_t> handed_out_;
};

bool begins_with(const Bytes& bytes, std::string_view text) {
  return bytes.size() >= text.size() &&
         std::equal(text.begin(), text.end(), bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

}  // namespace

std::vector<fs::path> files_of_folder(const fs::path& folder) {
  // A power cut while recording may leave it empty.
  std::error_code none;
  const auto metadata_bytes = fs::file_size(folder / "metadata.yaml", none);
  const bool has_metadata = !none && metadata_bytes > 0;
  auto files = has_metadata ? files_in_metadata(folder) : files_by_name(folder);
  if (files.empty()) {
    refuse(folder, has_metadata ? "names no file in its metadata.yaml"
                                : "holds neither metadata.yaml nor a .db3 or .mcap file; give a "
                                  "rosbag2 folder or an MCAP file");
  }
  return files;
}

std::unique_ptr<Bag> open_files(std::vector<fs::path> files) {
  if (files.size() == 1) return open_file(files.front());
  return std::make_unique<SeveralFiles>(std::move(files));
}

std::unique_ptr<Bag> open_file(const fs::path& file) {
  const InputFile input(file);
  Bytes start;
  input.read(0, std::min<std::uint64_t>(input.size(), 16), start);
  if (begins_with(start, "\x89MCAP")) return open_mcap(file);
  if (begins_with(start, "SQLite format 3")) return open_rosbag_file(file);
  if (begins_with(start, "\x28\xb5\x2f\xfd"))
    refuse(file, "is packed with zstd as a whole; unpack it with `zstd -d` first");
  refuse(file, "is neither an MCAP file nor a SQLite file of rosbag2");
}

std::unique_ptr<Bag> open_bag(const fs::path& path) {
  std::error_code none;
  const fs::file_status status = fs::status(path, none);
  if (fs::is_directory(status)) return open_files(files_of_folder(path));
  if (fs::is_regular_file(status)) return open_file(path);
  throw Error(ErrorKind::not_found, "there is no recording at " + path.string() +
                                        "; give a rosbag2 folder or an MCAP file");
}

}  // namespace slackwater::bag
