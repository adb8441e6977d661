#include "api/door/people/action_keeper.h"

#include "fields/base/error.h"

namespace slackwater::people {

ActionKeeper::ActionKeeper(const std::filesystem::path& store_folder, const std::string& name,
                           UtcTime begun, std::function<void(const std::string&)> on_trouble)
    : store_(store::Store::open(store_folder, store::OpenMode::create_or_write)),
      id_(store_.begin_session(name, begun)),
      on_trouble_(std::move(on_trouble)),
      thread_([this](const std::stop_token& over) { file(over); }) {}

ActionKeeper::~ActionKeeper() = default;

void ActionKeeper::keep(const store::SessionAction& action) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(action);
  changed_.notify_one();
}

void ActionKeeper::file(const std::stop_token& over) {
  bool is_able = true;
  while (true) {
    std::vector<store::SessionAction> rows;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, over, [&] { return !waiting_.empty(); });
      rows.swap(waiting_);
    }
    if (rows.empty()) return;
    if (!is_able) continue;
    try {
      store_.record_actions(id_, rows);
    } catch (const Error& e) {
      is_able = false;
      if (on_trouble_)
        on_trouble_("what people do is not filed any more: " + e.message() +
                    "; the log of the run (--out) still has all of it");
    }
  }
}

}  // namespace slackwater::people
