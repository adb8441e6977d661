#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/pipeline/fetch/fetch_site.h"
#include "api/pipeline/fetch/stored_already.h"
#include "api/program/paths.h"
#include "fields/base/text.h"
#include "fields/site/site.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using std::chrono::days;

struct FetchArguments {
  std::string site;
  std::string day;
  std::string history = "3d";
  std::string horizon = "72h";
  std::string patience = "20min";
  std::filesystem::path into = "downloads";
  bool is_dry = false;
};

/// Set by SIGINT and SIGTERM: what came stays, and the next fetch goes on from there.
std::atomic<bool> fetch_stop_asked = false;
void ask_fetch_to_stop(int) { fetch_stop_asked = true; }

Duration duration_option(const char* option, const std::string& text) {
  return option_value(option, text, [](const std::string& given) { return parse_duration(given); });
}

std::vector<WantedFile> wanted_by(const FetchArguments& arguments, const Context& context,
                                  const ingest::ProductCatalogue& products, const Site& site) {
  const UtcTime now = context.now();
  WantedTimes times;
  times.issued = now;
  times.day = arguments.day.empty() ? day_of(now) - days(1)
                                    : option_value("--day", arguments.day, parse_day);
  times.horizon = horizon_from(arguments.horizon);
  times.history = history_from(arguments.history);
  std::vector<WantedFile> wanted = wanted_files(products, site, times);
  if (std::filesystem::exists(context.store_folder / "catalogue.sqlite")) {
    store::Store store = context.open(store::OpenMode::read_only);
    leave_out_stored(store, site, times.day, wanted);
  }
  return wanted;
}

std::string time_text(const std::optional<UtcTime>& time) { return time ? format_utc(*time) : ""; }

json outcome_json(const FetchOutcome& out) {
  const auto or_null = [](const std::string& text) {
    return text.empty() ? json(nullptr) : json(text);
  };
  return {{"kind", out.wanted.kind},
          {"product", or_null(out.wanted.product_id)},
          {"dataset", or_null(out.wanted.dataset_id)},
          {"from", or_null(time_text(out.wanted.from))},
          {"to", or_null(time_text(out.wanted.to))},
          {"state", name_of(out.state)},
          {"file", or_null(out.file.string())},
          {"by", or_null(out.by)},
          {"tries", out.tries},
          {"why", or_null(out.why)},
          {"next_out", or_null(time_text(out.next_out))}};
}

void print_outcomes(const std::vector<FetchOutcome>& outcomes) {
  for (const FetchOutcome& out : outcomes) {
    std::string line =
        formatted("{:<14} {:<8} {}", out.wanted.kind, name_of(out.state), out.wanted.product_id);
    if (out.wanted.from)
      line += " " + time_text(out.wanted.from) + " to " + time_text(out.wanted.to);
    if (!out.by.empty()) line += formatted(", by {}", out.by);
    if (out.tries > 1) line += formatted(" at try {}", out.tries);
    if (!out.why.empty()) line += ": " + out.why;
    if (out.state == FetchState::late && out.next_out)
      line += "; the next issue is expected at " + time_text(out.next_out);
    std::printf("%s\n", line.c_str());
  }
}

/// Those that did not come, in one sentence.
void expect_all_came(const std::vector<FetchOutcome>& outcomes) {
  std::vector<std::string> failed;
  std::size_t wanted = 0;
  for (const FetchOutcome& out : outcomes) {
    wanted += out.wanted.file.empty() ? 0 : 1;
    const bool is_missing =
        out.state == FetchState::failed || (out.state == FetchState::late && out.file.empty());
    if (is_missing) failed.push_back(out.wanted.kind + " (" + out.why + ")");
  }
  if (failed.empty()) return;
  throw Error(ErrorKind::unavailable,
              formatted("{} of {} did not come: {}; run it again, what came is kept", failed.size(),
                        counted(wanted, "file"), joined(failed, "; ")));
}

void run_fetch(const FetchArguments& arguments, const Context& context) {
  const Site site = find_site(arguments.site, site_folders(context.store_folder));
  const auto products =
      ingest::ProductCatalogue::load(data_folder() / "products", own_product_folders());
  const std::vector<Fetcher> fetchers = known_fetchers(data_folder(), own_config_folder());
  FetchChoice choice;
  choice.folder = arguments.into;
  choice.is_dry = arguments.is_dry;
  choice.is_stop_asked = &fetch_stop_asked;
  choice.patience = std::chrono::duration_cast<std::chrono::seconds>(
      duration_option("--patience", arguments.patience));
  if (!context.json)
    choice.on_step = [](const std::string& step) {
      std::fprintf(stderr, "slackwater: %s\n", step.c_str());
    };
  std::signal(SIGINT, ask_fetch_to_stop);
  std::signal(SIGTERM, ask_fetch_to_stop);
  const std::vector<FetchOutcome> outcomes =
      fetch_site(wanted_by(arguments, context, products, site), fetchers, products, site,
                 context.now(), choice);
  if (context.json) {
    json files = json::array();
    for (const FetchOutcome& out : outcomes) files.push_back(outcome_json(out));
    std::printf("%s\n",
                json{{"site", site.id}, {"folder", arguments.into.string()}, {"files", files}}
                    .dump(2, ' ', false, json::error_handler_t::replace)
                    .c_str());
    context.answered = true;
  } else {
    print_outcomes(outcomes);
  }
  if (!arguments.is_dry) expect_all_came(outcomes);
}

}  // namespace

void add_fetch(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<FetchArguments>();
  CLI::App* command =
      app.add_subcommand("fetch", "Fetches the files that a forecast at a site wants");
  command->add_option("--site", arguments->site, "whose forecast")->required();
  command->add_option("--day", arguments->day, "day D, YYYY-MM-DD (default: yesterday)");
  command->add_option("--at", context.at, "as of this time, UTC (default: the clock)");
  command->add_option("--history", arguments->history,
                      "how long before day D, e.g. 60d (default 3d); what is stored is left out");
  command->add_option("--horizon", arguments->horizon,
                      "how far beyond the end of day D (default 72h)");
  command->add_option("--into", arguments->into, "folder of the files (default downloads)");
  command->add_option("--patience", arguments->patience,
                      "for how long it tries in all (default 20min)");
  command->add_flag("--dry-run", arguments->is_dry,
                    "says what would be fetched, and fetches nothing");
  command->callback([arguments, &context] { run_fetch(*arguments, context); });
}

}  // namespace slackwater::api
