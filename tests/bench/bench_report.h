#pragma once
#include <optional>
#include <string>
#include <vector>

namespace slackwater::bench {

/// How a benchmark program was asked to run.
struct BenchOptions {
  bool check_only = false;  ///< `--check-only`: verify the answers once, quickly, print no times
  bool json = false;        ///< `--json`: one JSON document per line instead of text
  std::string command;      ///< the command line, to print beside the figures
};

/// Reads the command line; unknown arguments end the program with a sentence and exit code 2.
[[nodiscard]] BenchOptions bench_options(int argc, char** argv);

/// One measured figure against its target, if it has one.
struct Figure {
  std::string name;
  std::string unit;
  std::vector<double> samples;
  std::optional<double> at_most;  ///< the median passes up to this
  std::string note;
  std::optional<double> at_least = std::nullopt;  ///< ... or from this on, for a ratio
};

[[nodiscard]] double median_of(std::vector<double> samples);

/// Prints the verdicts of one benchmark program and remembers whether all of them were good.
class BenchReport {
 public:
  explicit BenchReport(BenchOptions options);

  [[nodiscard]] const BenchOptions& options() const noexcept { return options_; }
  /// States whether an answer is right. Call it before any time of that answer is printed.
  void answer(const std::string& name, bool right, const std::string& found);
  void figure(const Figure& figure);
  /// Something that could not be run here, e.g. for want of data.
  void skipped(const std::string& name, const std::string& why);
  /// 0: all answers right and all targets met. 1: a wrong answer. 3: right, but too slow.
  [[nodiscard]] int exit_code() const noexcept;
  [[nodiscard]] bool all_right() const noexcept { return !wrong_; }

 private:
  BenchOptions options_;
  bool wrong_ = false;
  bool slow_ = false;
};

/// The `main` of a benchmark. What `run` throws is a wrong answer of that name.
[[nodiscard]] int run_bench(int argc, char** argv, const char* name, void (*run)(BenchReport&));

}  // namespace slackwater::bench
