// Every call of a commit fails once, with a full disk and with an input/output error, alone and
// with all that follow.
#include <gtest/gtest.h>

#include <cerrno>
#include <functional>

#include "fields/base/error.h"
#include "tests/data/store/disk_model.h"
#include "tests/data/store/memory_folder.h"
#include "tests/data/store/sample_rows.h"
#include "tests/data/store/worker_process.h"
#include "tests/support/asked_number.h"

namespace slackwater::store::tests::failing_disk_test {
namespace {

struct Trouble {
  int error;
  bool sticky;
  int first;  ///< the call that fails first
};

class FailingDisk : public testing::TestWithParam<Trouble> {};

/// How many calls the step makes that may fail.
bool can_fail(const RecordedCall& call) {
  return call.call != call_log::Call::close && call.call != call_log::Call::mark;
}

void expect_intact(Store& store, int number) {
  EXPECT_TRUE(store.find_source(samples::source(number).sha256, "")) << "source " << number;
}

/// Of four kinds of trouble `make test` lets each fourth call fail, in turn; `make soak` every one.
const int fail_every = slackwater::tests::asked_number("SLACKWATER_FAIL_EVERY", 6);

/// Runs `step` on a copy of a store that holds source and forecast 1, with its Nth call failing,
/// for all N, or each so-manyth.
void fail_everywhere(const std::string& step, const Trouble& trouble,
                     const std::function<bool(Store&)>& is_there,
                     const std::function<void(Store&)>& again) {
  const MemoryFolder folder;
  const std::filesystem::path root = std::filesystem::canonical(folder.path());
  {
    Store store = Store::open(root / "template", OpenMode::create_or_write);
    samples::ingest(store, 1);
    samples::issue(store, 1);
  }
  const auto copy = [&](const std::filesystem::path& name) {
    std::filesystem::copy(root / "template", root / name, std::filesystem::copy_options::recursive);
    return root / name;
  };
  int calls = 0;
  {
    const std::filesystem::path store = copy("rehearsal");
    WorkerProcess worker(store, {"begin", step}, fault_environment(store, root / "log"));
    ASSERT_TRUE(has_line(worker.finish(), "done " + step));
    for (const RecordedCall& call : read_call_log(root / "log")) calls += can_fail(call) ? 1 : 0;
  }
  ASSERT_GT(calls, 20);
  int reported_failed = 0;
  for (int at = (trouble.first - 1) % fail_every + 1; at <= calls; at += fail_every) {
    SCOPED_TRACE("call " + std::to_string(at) + " of " + std::to_string(calls));
    const std::filesystem::path store = copy("trial");
    WorkerProcess worker(store, {"begin", step},
                         fault_environment(store, "", at, trouble.error, trouble.sticky));
    const std::vector<std::string> said = worker.finish();
    ASSERT_EQ(worker.exit_code(), 0);
    const bool done = has_line(said, "done " + step);
    if (!done) {
      ++reported_failed;
      ASSERT_FALSE(said.empty());
      EXPECT_TRUE(said.back().starts_with("failed " + step)) << said.back();
    }
    const CheckReport after = check_store(store, true);
    EXPECT_TRUE(after.sound) << (after.findings.empty() ? "" : after.findings.front().found);
    Store opened = Store::open(store, OpenMode::create_or_write);
    expect_intact(opened, 1);
    EXPECT_FALSE(opened.find_forecasts({}).empty());
    if (done) {
      EXPECT_TRUE(is_there(opened)) << "reported done and not there";
    } else {
      again(opened);
      EXPECT_TRUE(is_there(opened)) << "another try does not mend it";
    }
    EXPECT_TRUE(opened.check(true).sound);
    std::filesystem::remove_all(store);
  }
  EXPECT_GT(reported_failed * fail_every, 5) << "hardly any failure was noticed";
}

TEST_P(FailingDisk, IngestIsReportedFailedAndCanBeRepeatedOrIsThere) {
  fail_everywhere(
      "ingest:2", GetParam(),
      [](Store& store) { return store.find_source(samples::source(2).sha256, "").has_value(); },
      [](Store& store) { samples::ingest(store, 2); });
}

TEST_P(FailingDisk, ForecastIsReportedFailedAndCanBeRepeatedOrIsThere) {
  fail_everywhere(
      "forecast:2", GetParam(),
      [](Store& store) {
        ForecastQuery query;
        query.from_day = samples::forecast_row(2).day;
        return !store.find_forecasts(query).empty();
      },
      [](Store& store) { samples::issue(store, 2); });
}

INSTANTIATE_TEST_SUITE_P(, FailingDisk,
                         testing::Values(Trouble{ENOSPC, false, 1}, Trouble{ENOSPC, true, 2},
                                         Trouble{EIO, false, 3}, Trouble{EIO, true, 4}),
                         [](const testing::TestParamInfo<Trouble>& trouble) {
                           return std::string(trouble.param.error == EIO ? "Eio" : "Enospc") +
                                  (trouble.param.sticky ? "FromThereOn" : "Once");
                         });

}  // namespace
}  // namespace slackwater::store::tests::failing_disk_test
