#include "api/door/people/kept_session.h"

namespace slackwater::people {

KeptSession::KeptSession(SessionSettings settings, TokenBook book,
                         const std::filesystem::path& store_folder, const std::string& filed_as,
                         std::function<void(const std::string&)> on_trouble)
    : keeper_(std::make_unique<ActionKeeper>(store_folder, filed_as, settings.now(),
                                             std::move(on_trouble))) {
  settings.keep = [keeper = keeper_.get(), also = std::move(settings.keep)](const Action& row) {
    keeper->keep(row);
    if (also) also(row);
  };
  session_ = std::make_shared<Session>(std::move(settings), std::move(book));
}

void KeptSession::end() {
  session_->end();
  keeper_.reset();  // a session that is over keeps nothing more
}

}  // namespace slackwater::people
