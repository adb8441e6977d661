// Does to a store what its arguments say, and says on standard output what is done:
//   slackwater_store_worker STORE STEP...
//     begin        arms the fault injection
//     open         opens the store for writing (so does the first step that needs it)
//     ingest:N     commits source N        -> "done ingest:N"
//     forecast:N   commits forecast N, made from all granules of source N if that is stored
//     prune        removes everything that `prune` can; says "pruning" before
//     close        closes the store
//     loop:N       ingest and forecast N, N+1, ... until killed
// A step that fails says "failed STEP: message" and the next one follows.
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <string>

#include "fields/base/error.h"
#include "tests/data/store/sample_rows.h"

namespace {

using slackwater::store::OpenMode;
using slackwater::store::Store;
namespace samples = slackwater::store::samples;

void say(const std::string& text) {
  const std::string line = text + "\n";
  if (::write(STDOUT_FILENO, line.data(), line.size()) < 0) _exit(3);
}

class Worker {
 public:
  explicit Worker(std::string folder) : folder_(std::move(folder)) {}

  void run(const std::string& step) {
    const std::size_t colon = step.find(':');
    const std::string verb = step.substr(0, colon);
    const int number = colon == std::string::npos ? 0 : std::stoi(step.substr(colon + 1));
    if (verb == "begin") return say("begin");
    if (verb == "close") {
      store_.reset();
    } else if (verb == "open") {
      store();
    } else if (verb == "ingest") {
      samples::ingest(store(), number);
    } else if (verb == "forecast") {
      forecast(number);
    } else if (verb == "prune") {
      store();
      say("pruning");
      store().prune({slackwater::parse_utc("2100-01-01T00:00:00Z"), true, true});
    } else if (verb == "loop") {
      for (int n = number;; ++n) {
        run("ingest:" + std::to_string(n));
        run("forecast:" + std::to_string(n));
      }
    } else {
      say("unknown step");
      _exit(2);
    }
    say("done " + step);
  }

 private:
  Store& store() {
    if (!store_) store_.emplace(Store::open(folder_, OpenMode::create_or_write));
    return *store_;
  }
  void forecast(int number) {
    std::vector<std::int64_t> inputs;
    for (const auto& granule : store().find_granules({})) {
      if (granule.source_sha256 == samples::source(number).sha256) inputs.push_back(granule.id);
    }
    samples::issue(store(), number, inputs);
  }

  std::string folder_;
  std::optional<Store> store_;
};

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 2;
  Worker worker(arguments[1]);
  for (int i = 2; i < count; ++i) {
    try {
      worker.run(arguments[i]);
    } catch (const std::exception& error) {
      say("failed " + std::string(arguments[i]) + ": " + error.what());
    }
  }
  return 0;
}
