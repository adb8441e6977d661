#include "tests/data/store/disk_model.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace slackwater::store::tests {
namespace {

constexpr std::size_t sector_bytes = 512;

void put(std::string& file, std::size_t offset, std::string_view bytes) {
  if (file.size() < offset + bytes.size()) file.resize(offset + bytes.size());
  file.replace(offset, bytes.size(), bytes);
}

}  // namespace

std::vector<RecordedCall> read_call_log(const std::filesystem::path& log) {
  std::ifstream stream(log, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::vector<RecordedCall> calls;
  std::size_t at = 0;
  while (at + sizeof(call_log::Header) <= text.size()) {
    call_log::Header header{};
    std::memcpy(&header, text.data() + at, sizeof header);
    at += sizeof header;
    const auto take = [&](std::size_t bytes) {
      at += bytes;
      return text.substr(at - bytes, bytes);
    };
    RecordedCall call{header.call, header.descriptor, header.offset, {}, {}, {}};
    call.path = take(header.path_bytes);
    call.other = take(header.other_bytes);
    call.data = take(header.data_bytes);
    calls.push_back(std::move(call));
  }
  return calls;
}

DiskModel::DiskModel(const std::filesystem::path& root)
    : root_path_(root), root_(std::make_shared<Node>()) {
  root_->is_folder = true;
}

std::shared_ptr<DiskModel::Node> DiskModel::find(const std::filesystem::path& path) const {
  std::shared_ptr<Node> node = root_;
  const std::filesystem::path relative = path.lexically_relative(root_path_);
  if (relative == ".") return node;
  for (const auto& part : relative) {
    const auto next = node->live_names.find(part.string());
    if (next == node->live_names.end()) return nullptr;
    node = next->second;
  }
  return node;
}

void DiskModel::set_name(const std::string& path, std::shared_ptr<Node> node) {
  const std::filesystem::path full(path);
  const std::shared_ptr<Node> folder = find(full.parent_path());
  if (!folder) throw std::logic_error("a call in an unknown folder: " + path);
  Change change;
  change.name = full.filename().string();
  change.node = node;
  folder->pending.push_back(change);
  if (node) {
    folder->live_names[change.name] = std::move(node);
  } else {
    folder->live_names.erase(change.name);
  }
}

void DiskModel::settle(Node& node) {
  if (node.is_folder) {
    node.names = node.live_names;
  } else {
    for (const Change& change : node.pending) {
      if (change.is_truncation) {
        node.bytes.resize(static_cast<std::size_t>(change.offset));
      } else {
        put(node.bytes, static_cast<std::size_t>(change.offset), change.bytes);
      }
    }
  }
  node.pending.clear();
}

void DiskModel::apply(const RecordedCall& call) {
  switch (call.call) {
    case call_log::Call::open: {
      std::shared_ptr<Node> node = find(call.path);
      if (!node) {
        node = std::make_shared<Node>();
        set_name(call.path, node);
      }
      descriptors_[call.descriptor] = node;
      break;
    }
    case call_log::Call::close:
      descriptors_.erase(call.descriptor);
      break;
    case call_log::Call::write:
    case call_log::Call::truncate: {
      Change change;
      change.offset = call.offset;
      change.bytes = call.data;
      change.is_truncation = call.call == call_log::Call::truncate;
      descriptors_.at(call.descriptor)->pending.push_back(std::move(change));
      break;
    }
    case call_log::Call::sync:
      settle(*descriptors_.at(call.descriptor));
      break;
    case call_log::Call::rename: {
      const std::shared_ptr<Node> node = find(call.path);
      if (!node) throw std::logic_error("an unknown file is renamed: " + call.path);
      set_name(call.other, node);
      set_name(call.path, nullptr);
      break;
    }
    case call_log::Call::unlink:
      set_name(call.path, nullptr);
      break;
    case call_log::Call::make_folder: {
      auto node = std::make_shared<Node>();
      node->is_folder = true;
      set_name(call.path, std::move(node));
      break;
    }
    case call_log::Call::mark:
      break;
  }
}

void DiskModel::write(const Node& node, const std::filesystem::path& target, Survival survival,
                      Rng& rng) {
  const auto survives = [&] {
    return survival == Survival::all || (survival == Survival::some && rng.uniform() < 0.5);
  };
  if (node.is_folder) {
    auto names = node.names;
    for (const Change& change : node.pending) {
      if (!survives()) continue;
      if (change.node) {
        names[change.name] = change.node;
      } else {
        names.erase(change.name);
      }
    }
    std::filesystem::create_directories(target);
    for (const auto& [name, child] : names) write(*child, target / name, survival, rng);
    return;
  }
  std::string bytes = node.bytes;
  for (const Change& change : node.pending) {
    const auto offset = static_cast<std::size_t>(change.offset);
    if (change.is_truncation) {
      if (survives()) bytes.resize(offset);
      continue;
    }
    for (std::size_t at = 0; at < change.bytes.size(); at += sector_bytes) {
      if (!survives()) continue;
      put(bytes, offset + at, std::string_view(change.bytes).substr(at, sector_bytes));
    }
  }
  std::ofstream(target, std::ios::binary) << bytes;
}

void DiskModel::power_cut(const std::filesystem::path& target, Survival survival, Rng& rng) const {
  write(*root_, target, survival, rng);
}

}  // namespace slackwater::store::tests
