#include "api/door/desk/kept_answers.h"

#include <algorithm>

#include "fields/base/spare_memory.h"

namespace slackwater::api::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes longest{5};

void add_mark(const fs::path& file, std::string& mark) {
  std::error_code unreadable;
  const auto written = fs::last_write_time(file, unreadable).time_since_epoch().count();
  if (unreadable) return;
  mark += file.filename().string() + ' ' + std::to_string(written) + ' ' +
          std::to_string(fs::file_size(file, unreadable)) + '\n';
}

void add_folder(const fs::path& folder, std::string& mark) {
  std::error_code unreadable;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, unreadable))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) add_mark(file, mark);
}

template <typename Pending>
bool is_open(const Pending& response) {
  return response.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

}  // namespace

std::string mark_of(const fs::path& store_folder, const fs::path& data_folder) {
  std::string mark;
  for (const char* file : {"catalogue.sqlite", "catalogue.sqlite-wal"})
    add_mark(store_folder / file, mark);
  for (const char* folder : {"sites", "plans"}) add_folder(store_folder / folder, mark);
  for (const char* folder : {"sites", "tasks", "vessels"}) add_folder(data_folder / folder, mark);
  return mark;
}

KeptAnswers::KeptAnswers(fs::path store_folder, fs::path data_folder, std::function<UtcTime()> now,
                         std::size_t most)
    : store_folder_(std::move(store_folder)),
      data_folder_(std::move(data_folder)),
      now_(std::move(now)),
      most_(most) {}

void KeptAnswers::drop(std::map<std::string, Kept>::iterator kept) {
  bytes_ -= kept->second.bytes;
  kept_.erase(kept);
}

/// For one more; what weighs nothing yet is dropped for its number alone.
void KeptAnswers::make_room() {
  const auto is_older = [](const auto& a, const auto& b) {
    return a.second.number < b.second.number;
  };
  while (kept_.size() >= most_kept) drop(std::min_element(kept_.begin(), kept_.end(), is_older));
}

void KeptAnswers::weigh(const std::string& question, std::size_t number, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  const auto mine = kept_.find(question);
  if (mine == kept_.end() || mine->second.number != number) return;
  mine->second.bytes = bytes;
  bytes_ += bytes;
  while (bytes_ > most_) {
    auto oldest = kept_.end();
    for (auto it = kept_.begin(); it != kept_.end(); ++it)
      if (it->second.bytes > 0 &&
          (oldest == kept_.end() || it->second.number < oldest->second.number))
        oldest = it;
    drop(oldest);
  }
}

void KeptAnswers::forget() {
  const std::lock_guard lock(mutex_);
  kept_.clear();
  bytes_ = 0;
}

std::size_t KeptAnswers::kept_bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

http::Response KeptAnswers::answer(const std::string& question, const Make& make) {
  const std::string mark =
      mark_of(store_folder_, data_folder_) + std::to_string(now_().time_since_epoch() / longest);
  std::promise<std::shared_ptr<const http::Response>> promise;
  Pending pending;
  std::size_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    const auto found = kept_.find(question);
    // What is being worked out is waited for: a second time beside itself it would take longer.
    if (found != kept_.end() && (found->second.mark == mark || is_open(found->second.response))) {
      pending = found->second.response;
    } else {
      if (found != kept_.end()) drop(found);
      make_room();
      number = ++last_;
      kept_[question] = {promise.get_future().share(), mark, number, 0};
    }
  }
  if (number == 0) return *pending.get();
  try {
    auto made = std::make_shared<const http::Response>(make());
    promise.set_value(made);
    weigh(question, number, made->body.size());
    give_back_spare_memory();
    return *made;
  } catch (...) {
    promise.set_exception(std::current_exception());
    const std::lock_guard lock(mutex_);
    const auto mine = kept_.find(question);
    if (mine != kept_.end() && mine->second.number == number) drop(mine);
    throw;
  }
}

}  // namespace slackwater::api::desk
