#include <CLI/CLI.hpp>

#include "api/cli/command.h"

namespace slackwater::api {
void add_demo(CLI::App& app, Context&) { app.add_subcommand("demo", "x"); }
}  // namespace slackwater::api
