#include "api/door/people/action.h"

namespace slackwater::people {

const Action& ActionRecord::add(Action action) {
  action.number = all_.size() + 1;
  all_.push_back(std::move(action));
  if (keep_) keep_(all_.back());
  return all_.back();
}

}  // namespace slackwater::people
