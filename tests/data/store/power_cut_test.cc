// A recorded run is cut short after every single call, and everything that was not synced by then
// is lost, kept or torn.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "fields/base/error.h"
#include "tests/data/store/disk_model.h"
#include "tests/data/store/memory_folder.h"
#include "tests/data/store/sample_rows.h"
#include "tests/data/store/worker_process.h"
#include "tests/support/asked_number.h"

namespace slackwater::store::tests::power_cut_test {
namespace {

using Survival = DiskModel::Survival;

struct Recording {
  MemoryFolder folder;
  std::filesystem::path root = std::filesystem::canonical(folder.path()) / "disk";
  std::vector<RecordedCall> calls;

  explicit Recording(const std::vector<std::string>& steps) {
    std::filesystem::create_directory(root);
    WorkerProcess worker(root / "store", steps, fault_environment(root, folder / "log"));
    for (const std::string& line : worker.finish()) {
      EXPECT_FALSE(line.starts_with("failed")) << line;
    }
    EXPECT_EQ(worker.exit_code(), 0);
    calls = read_call_log(folder / "log");
    EXPECT_GT(calls.size(), 50U) << "the interposed libc recorded nothing";
  }
};

/// What is wrong with a store in which these steps were reported done; "" if nothing.
std::string fault_of(const std::filesystem::path& store, const std::set<std::string>& done) {
  try {
    const CheckReport report = check_store(store, true);
    if (!report.sound) return report.findings.front().found;
    Store opened = Store::open(store, OpenMode::create_or_write);
    for (const std::string& step : done) {
      const int number =
          step.find(':') == std::string::npos ? 0 : std::stoi(step.substr(step.find(':') + 1));
      if (step.starts_with("ingest") && !opened.find_source(samples::source(number).sha256, "")) {
        return "lost: " + step;
      }
      ForecastQuery query;
      query.from_day = query.to_day = samples::forecast_row(number).day;
      if (step.starts_with("forecast") && opened.find_forecasts(query).empty()) {
        return "lost: " + step;
      }
    }
    // Work goes on: the next commit succeeds.
    samples::ingest(opened, 900);
    return check_store(store, false).sound ? "" : "unsound after the next commit";
  } catch (const Error& error) {
    // Before anything was reported done there may be no store at all.
    if (error.kind() == ErrorKind::not_found && done.empty()) return "";
    return error.message();
  }
}

/// Cuts the power after each call; with `every` 3, each call in one of the three ways of survival.
/// The faults found, each with where.
std::vector<std::string> cut_everywhere(const Recording& recording,
                                        const std::function<bool(const RecordedCall&)>& is_ignored,
                                        int every = 1, std::size_t stop_after = 1) {
  std::vector<std::string> faults;
  DiskModel disk(recording.root);
  std::set<std::string> done;
  for (std::size_t i = 0; i < recording.calls.size() && faults.size() < stop_after; ++i) {
    const RecordedCall& call = recording.calls[i];
    if (call.call == call_log::Call::mark) {
      if (call.data == "pruning\n") done.clear();
      if (call.data.starts_with("done ")) done.insert(call.data.substr(5, call.data.size() - 6));
    }
    if (!is_ignored(call)) disk.apply(call);
    if (call.call == call_log::Call::open || call.call == call_log::Call::close) continue;
    for (const Survival survival : {Survival::none, Survival::all, Survival::some}) {
      if ((static_cast<int>(i) + static_cast<int>(survival)) % every != 0) continue;
      // Syncs make certain what was already there: nothing new where nothing is lost.
      if (survival == Survival::all && call.call == call_log::Call::sync) continue;
      const MemoryFolder after;
      Rng rng(20240229 + i, "power cut");
      disk.power_cut(after.path(), survival, rng);
      if (const std::string fault = fault_of(after / "store", done); !fault.empty()) {
        faults.push_back("call " + std::to_string(i) + ", survival " +
                         std::to_string(static_cast<int>(survival)) + ": " + fault);
      }
    }
  }
  return faults;
}

const auto nothing = [](const RecordedCall&) { return false; };
/// `make soak` cuts after every call in every way.
const int cut_every = slackwater::tests::asked_number("SLACKWATER_CUT_EVERY", 5);

TEST(PowerCut, LosesNothingThatWasReportedDoneWhereverItFalls) {
  const Recording recording({"open", "ingest:1", "forecast:1", "close", "ingest:2", "forecast:2"});
  for (const std::string& fault : cut_everywhere(recording, nothing, cut_every, 5))
    ADD_FAILURE() << fault;
}

TEST(PowerCut, DuringAPruneLeavesNoHoles) {
  const Recording recording({"ingest:1", "forecast:1", "ingest:2", "prune", "ingest:3"});
  for (const std::string& fault : cut_everywhere(recording, nothing, cut_every, 5))
    ADD_FAILURE() << fault;
}

/// The two tests below plant a violation, to see the model close on it: were a sync missing, the
/// test above would fail.
TEST(PowerCut, WouldShowAMissingSyncOfAContentFile) {
  const Recording recording({"ingest:1"});
  std::set<int> staged;
  const auto content_sync = [&](const RecordedCall& call) {
    if (call.call == call_log::Call::open) {
      if (call.path.ends_with(".nc")) {
        staged.insert(call.descriptor);
      } else {
        staged.erase(call.descriptor);
      }
    }
    return call.call == call_log::Call::sync && staged.contains(call.descriptor);
  };
  EXPECT_FALSE(cut_everywhere(recording, content_sync).empty());
}

TEST(PowerCut, WouldShowAMissingSyncOfAFolder) {
  const Recording recording({"ingest:1"});
  std::set<int> folders;
  const auto folder_sync = [&](const RecordedCall& call) {
    if (call.call == call_log::Call::open) {
      if (call.path.find("/files/") != std::string::npos) {
        folders.insert(call.descriptor);
      } else {
        folders.erase(call.descriptor);
      }
    }
    return call.call == call_log::Call::sync && folders.contains(call.descriptor);
  };
  EXPECT_FALSE(cut_everywhere(recording, folder_sync).empty());
}

/// The order that makes it so, read from the record of one ingest.
TEST(PowerCut, ContentIsSyncedThenNamedThenItsFolderSyncedThenTheCatalogue) {
  const Recording recording({"open", "begin", "ingest:1"});
  std::map<int, std::string> open;
  std::map<std::string, std::size_t> last_write;  // by path at the time
  std::map<std::string, std::size_t> last_sync;
  std::map<std::string, std::size_t> named;  // content path -> when it was renamed there
  std::size_t catalogue_sync = 0;
  std::size_t done = 0;
  std::size_t now = 0;
  for (const RecordedCall& call : recording.calls) {
    ++now;
    if (call.call == call_log::Call::open) open[call.descriptor] = call.path;
    if (call.call == call_log::Call::write) last_write[open[call.descriptor]] = now;
    if (call.call == call_log::Call::mark && call.data == "done ingest:1\n") done = now;
    if (call.call == call_log::Call::rename && call.other.find("/files/") != std::string::npos) {
      EXPECT_GT(last_sync[call.path], last_write[call.path]) << call.path;
      named[call.other] = now;
    }
    if (call.call == call_log::Call::sync) {
      last_sync[open[call.descriptor]] = now;
      if (!named.empty() && open[call.descriptor].ends_with("-wal") && catalogue_sync == 0) {
        catalogue_sync = now;
        for (const auto& [path, when] : named) {
          EXPECT_GT(last_sync[std::filesystem::path(path).parent_path().string()], when) << path;
        }
      }
    }
  }
  EXPECT_EQ(named.size(), 2U);
  EXPECT_GT(catalogue_sync, 0U);
  EXPECT_GT(done, catalogue_sync);
}

}  // namespace
}  // namespace slackwater::store::tests::power_cut_test
