#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "data/store/store.h"
#include "fields/base/error.h"
#include "fields/base/time.h"

namespace CLI {
class App;
}

namespace slackwater::api {

/// What every subcommand has: the store, `--json`, and the present moment.
struct Context {
  std::filesystem::path store_folder;
  bool json = false;
  std::string at;  ///< `--at`, else the clock
  mutable bool answered =
      false;  ///< the JSON document is printed: trouble after it goes to stderr alone
  mutable int exit_code = 0;  ///< of a command that went well and was asked for its verdict

  [[nodiscard]] UtcTime now() const;
  /// The value of an option that is a UTC time; "now" is the clock's, to the second.
  [[nodiscard]] UtcTime time_of(std::string_view option, const std::string& text) const;
  [[nodiscard]] store::Store open(store::OpenMode mode) const;
};

/// "2025-03-10T05:00:12Z by slackwater 0.1.0": what stands at the foot of a page.
[[nodiscard]] std::string made_by(const Context& context);

/// Exit code of an error kind (api/docs/commands.md): 1 internal, 2 usage, 3 invalid input, 4 not
/// found, 5 unavailable, 6 not converged.
[[nodiscard]] int exit_code(ErrorKind kind) noexcept;

/// The value of an option, read by `parse`; what it cannot read is Error(usage) that names the
/// option.
template <typename Parse>
[[nodiscard]] auto option_value(std::string_view option, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const Error& problem) {
    throw Error(ErrorKind::usage, std::string(option) + ": " + problem.message());
  }
}

/// `--horizon`: 1 hour to 15 days.
[[nodiscard]] Duration horizon_from(const std::string& text);
/// `--history`: 3 days, which the tide needs, to the 730 that archives of forecasts hold.
[[nodiscard]] Duration history_from(const std::string& text);

/// Parses and runs a command line; prints results on stdout, trouble on stderr. @return the exit
/// code.
int run_command_line(int argc, const char* const* argv);

// One file each in api/door/cli; each adds its subcommand to the app.
void add_ingest(CLI::App& app, Context& context);
void add_fetch(CLI::App& app, Context& context);
void add_forecast(CLI::App& app, Context& context);
void add_hindcast(CLI::App& app, Context& context);
void add_profile(CLI::App& app, Context& context);
void add_sample(CLI::App& app, Context& context);
void add_verify(CLI::App& app, Context& context);
void add_store(CLI::App& app, Context& context);
void add_site(CLI::App& app, Context& context);
void add_ais(CLI::App& app, Context& context);
void add_demo(CLI::App& app, Context& context);
void add_live(CLI::App& app, Context& context);
void add_serve(CLI::App& app, Context& context);
void add_simulate(CLI::App& app, Context& context);
void add_replay(CLI::App& app, Context& context);
void add_rehearse(CLI::App& app, Context& context);
void add_score(CLI::App& app, Context& context);
void add_render(CLI::App& app, Context& context);
void add_vehicle(CLI::App& app, Context& context);
void add_stage(CLI::App& app, Context& context);
void add_windows(CLI::App& app, Context& context);
void add_workability(CLI::App& app, Context& context);
void add_climate(CLI::App& app, Context& context);
void add_plan(CLI::App& app, Context& context);
void add_report(CLI::App& app, Context& context);
void add_detect(CLI::App& app, Context& context);
void add_decide(CLI::App& app, Context& context);
void add_decisions(CLI::App& app, Context& context);
void add_sessions(CLI::App& app, Context& context);
void add_watch(CLI::App& app, Context& context);

}  // namespace slackwater::api
