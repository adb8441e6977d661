#include "data/bag/mcap_bag.h"

#include <algorithm>
#include <compare>
#include <queue>
#include <utility>

#include "data/bag/input_file.h"
#include "data/bag/mcap_index.h"
#include "data/bag/mcap_record.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

struct Entry {
  std::int64_t time_ns = 0;
  std::size_t channel = 0;
  ByteView payload;
};

/// A stretch whose messages are in memory, in the order of time.
struct Held {
  std::size_t stretch = 0;
  Bytes records;
  std::vector<Entry> entries;
  std::size_t next = 0;

  [[nodiscard]] std::size_t bytes() const {
    return records.capacity() + entries.capacity() * sizeof(Entry);
  }
};

/// When a stretch is wanted: at its first message, and after it was let go at the first that was
/// not yet handed out.
struct Turn {
  std::int64_t time_ns = 0;
  std::size_t stretch = 0;  ///< of two at one time the earlier in the file
  std::size_t entry = 0;

  auto operator<=>(const Turn&) const = default;
};

class McapBag : public Bag {
 public:
  McapBag(const std::filesystem::path& path, std::size_t held_bytes)
      : file_(path), index_(index_of(file_)), most_bytes_(held_bytes) {
    for (std::size_t i = 0; i < index_.stretches.size(); ++i)
      awaited_.push({index_.stretches[i].first_ns, i, 0});
  }

  const std::vector<Channel>& channels() const noexcept override {
    return index_.channels.channels();
  }
  const std::vector<std::string>& warnings() const noexcept override { return index_.warnings; }

  std::optional<Recorded> next() override {
    try {
      return advanced();
    } catch (Error&) {
      held_.clear();
      awaited_ = {};
      throw;
    }
  }

 private:
  std::optional<Recorded> advanced() {
    let_go_of_what_is_done();
    for (;;) {
      const auto first =
          std::min_element(held_.begin(), held_.end(),
                           [](const Held& a, const Held& b) { return turn_of(a) < turn_of(b); });
      if (awaited_.empty() && first == held_.end()) return std::nullopt;
      if (!awaited_.empty() && (first == held_.end() || awaited_.top() < turn_of(*first))) {
        const Turn turn = awaited_.top();
        awaited_.pop();
        hold(turn);
        continue;
      }
      const Entry& entry = first->entries[first->next++];
      return Recorded{entry.channel, entry.time_ns, entry.payload};
    }
  }

  static Turn turn_of(const Held& held) {
    return {held.entries[held.next].time_ns, held.stretch, held.next};
  }

  void let_go_of_what_is_done() {
    for (Held& held : held_) {
      if (held.next < held.entries.size()) continue;
      spare_ = std::move(held);
      if (&held != &held_.back()) held = std::move(held_.back());
      held_.pop_back();
      return;  // no more than one message was handed out since the last time
    }
  }

  void hold(const Turn& turn) {
    const McapStretch& stretch = index_.stretches[turn.stretch];
    Held held = std::exchange(spare_, {});
    held.stretch = turn.stretch;
    held.next = turn.entry;
    held.entries.clear();
    with_context(file_.path().string() + ", at byte " + std::to_string(stretch.offset),
                 [&] { read_entries(stretch, held); });
    if (held.next >= held.entries.size()) return;
    held_.push_back(std::move(held));
    keep_within_bounds();
  }

  void read_entries(const McapStretch& stretch, Held& held) {
    read_stretch(file_, stretch, file_bytes_, held.records);
    for (ByteView rest = held.records; !rest.empty();) {
      const McapRecord record = take_record(rest);
      if (record.op != McapOp::message) continue;
      McapFields fields(record.content);
      const auto id = fields.number<std::uint16_t>();
      const std::size_t* channel = index_.channels.find(id);
      if (channel == nullptr) {
        throw Error(ErrorKind::invalid_input,
                    "a message of channel " + std::to_string(id) + ", which is not defined");
      }
      static_cast<void>(fields.number<std::uint32_t>());
      const std::int64_t time_ns = fields.time_ns();
      fields.time_ns();
      if (time_ns < stretch.first_ns) {
        throw Error(ErrorKind::invalid_input,
                    "a message is earlier than the summary says of its chunk");
      }
      held.entries.push_back({time_ns, *channel, fields.raw(fields.left())});
    }
    std::stable_sort(held.entries.begin(), held.entries.end(),
                     [](const Entry& a, const Entry& b) { return a.time_ns < b.time_ns; });
  }

  void keep_within_bounds() {
    std::size_t bytes = 0;
    for (const Held& held : held_) bytes += held.bytes();
    while (bytes > most_bytes_ && held_.size() > 1) {
      const auto last =
          std::max_element(held_.begin(), held_.end(),
                           [](const Held& a, const Held& b) { return turn_of(a) < turn_of(b); });
      bytes -= last->bytes();
      awaited_.push(turn_of(*last));
      *last = std::move(held_.back());
      held_.pop_back();
    }
  }

  InputFile file_;
  McapIndex index_;
  std::size_t most_bytes_;
  std::priority_queue<Turn, std::vector<Turn>, std::greater<>> awaited_;
  std::vector<Held> held_;
  Held spare_;  ///< whose memory is used again
  Bytes file_bytes_;
};

}  // namespace

std::unique_ptr<Bag> open_mcap(const std::filesystem::path& file, std::size_t held_bytes) {
  return with_context("reading " + file.string(),
                      [&] { return std::make_unique<McapBag>(file, held_bytes); });
}

}  // namespace slackwater::bag
