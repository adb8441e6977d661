#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/progress.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/program/paths.h"
#include "fields/base/text.h"
#include "fields/site/site.h"
#include "ingest/copernicus/product_catalogue.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct IngestArguments {
  std::vector<std::filesystem::path> paths;
  std::string as;
  std::string issued;
  std::vector<double> box;
  std::string site;
  std::filesystem::path product;
};

/// Cells this far around a site are kept: more than two cells of the coarsest wind product.
constexpr double site_margin_deg = 0.6;

ingest::IngestOptions options_of(const IngestArguments& arguments, const Context& context) {
  ingest::IngestOptions options;
  if (!arguments.as.empty()) {
    options.as = data_status_from(arguments.as);
    if (!options.as ||
        (*options.as != DataStatus::analysis && *options.as != DataStatus::forecast)) {
      throw Error(ErrorKind::usage,
                  "found --as " + arguments.as + ", expected analysis or forecast");
    }
  }
  if (!arguments.issued.empty())
    options.issued = option_value("--issued", arguments.issued, parse_utc);
  if (options.as == DataStatus::forecast && !options.issued) {
    throw Error(ErrorKind::usage,
                "--as forecast needs --issued TIME, the provider's reference time");
  }
  if (options.as == DataStatus::analysis && options.issued) {
    throw Error(ErrorKind::usage,
                "--as analysis and --issued contradict each other; give one of them");
  }
  if (!arguments.box.empty() && !arguments.site.empty()) {
    throw Error(ErrorKind::usage, "give --bbox or --site, not both");
  }
  if (!arguments.box.empty()) {
    options.cut = option_value("--bbox", "", [&](const std::string&) {
      return BoundingBox::from_degrees(arguments.box[0], arguments.box[1], arguments.box[2],
                                       arguments.box[3]);
    });
  }
  if (!arguments.site.empty()) {
    options.cut =
        find_site(arguments.site, site_folders(context.store_folder)).box(site_margin_deg);
  }
  return options;
}

json to_json(const IngestReport& report) {
  return {{"file", report.file.string()},
          {"stored", report.stored},
          {"repaired", report.repaired},
          {"sha256", report.sha256},
          {"product", report.product_id},
          {"status", report.status},
          {"granules", report.granules},
          {"times", report.counts.times},
          {"times_by_status", report.counts.by_status},
          {"members", report.counts.members},
          {"standard_names", report.standard_names},
          {"warnings", report.warnings}};
}

void print(const IngestReport& report) {
  if (!report.stored) {
    std::printf("%s: already in the store\n", report.file.c_str());
    return;
  }
  const std::string names = joined(report.standard_names, ", ");
  std::printf("%s: %s, %s: %s\n", report.file.c_str(), report.product_id.c_str(),
              text_of(report.counts, report.status).c_str(), names.c_str());
  if (report.repaired)
    std::printf("  repaired: its content in the store was damaged or lost, and is whole again\n");
  for (const std::string& warning : report.warnings)
    std::printf("  warning: %s\n", warning.c_str());
}

/// Opens the store when all files are read, and closes it: what their readers left in SQLite's log
/// is then in the catalogue. Where that fails the log stays, and harms nothing.
class LogBroughtIn {
 public:
  explicit LogBroughtIn(const Context& context) : context_(context) {}
  ~LogBroughtIn() {
    try {
      static_cast<void>(context_.open(store::OpenMode::create_or_write));
    } catch (const std::exception&) {
      return;  // the next command does it
    }
  }
  LogBroughtIn(const LogBroughtIn&) = delete;
  LogBroughtIn& operator=(const LogBroughtIn&) = delete;

 private:
  const Context& context_;
};

/// All files are tried, each in a process of its own, so that one that crashes the library that
/// reads it does not keep the others out; the first trouble decides the exit code, each one is
/// told.
void ingest_all(const IngestArguments& arguments, const Context& context) {
  ingest::IngestOptions options = options_of(arguments, context);
  const std::vector<std::filesystem::path> files = product_files(arguments.paths);
  const auto products =
      ingest::ProductCatalogue::load(data_folder() / "products", own_product_folders());
  if (!arguments.product.empty())
    options.product = std::make_shared<const ingest::Product>(products.describe(arguments.product));
  // Made, or refused, before any file is read; closed again, because each reader is a copy of this
  // process.
  static_cast<void>(context.open(store::OpenMode::create_or_write));
  const LogBroughtIn when_all_is_read(context);
  json done = json::array();
  json failed = json::array();
  std::optional<Error> first_problem;
  ProgressBar bar("ingest", context.json);
  for (std::size_t i = 0; i < files.size(); ++i) {
    try {
      const IngestReport report = ingest_file_apart(
          context.store_folder, products, files[i], options, context.now(), [&](double share) {
            bar.update((static_cast<double>(i) + share) / static_cast<double>(files.size()));
          });
      if (context.json) {
        done.push_back(to_json(report));
      } else {
        print(report);
        std::fflush(stdout);
      }
    } catch (Error& problem) {
      // A full disk or a locked store will not mend itself for the next file.
      if (problem.kind() == ErrorKind::unavailable || files.size() == 1) throw;
      if (context.json) {
        failed.push_back({{"file", files[i].string()},
                          {"kind", std::string(name_of(problem.kind()))},
                          {"message", problem.message()}});
      } else {
        std::fprintf(stderr, "slackwater: %s\n", problem.message().c_str());
      }
      if (!first_problem) first_problem = problem;
    }
  }
  if (context.json) {
    std::printf("%s\n", json{{"files", done}, {"failed", failed}}
                            .dump(2, ' ', false, json::error_handler_t::replace)
                            .c_str());
    context.answered = true;
  }
  if (first_problem) {
    throw Error(first_problem->kind(),
                "not every file was ingested; first: " + first_problem->message());
  }
}

}  // namespace

void add_ingest(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<IngestArguments>();
  CLI::App* command =
      app.add_subcommand("ingest", "Read product files (NetCDF, GRIB, in-situ) into the store");
  command->add_option("paths", arguments->paths, "files, or folders of files")->required();
  command->add_option("--as", arguments->as,
                      "analysis | forecast: what the files are, whatever they say");
  command->add_option("--issued", arguments->issued,
                      "reference time of a forecast, e.g. 2025-03-10T00:00:00Z");
  command->add_option("--product", arguments->product,
                      "FILE.yaml that says what the files are: name, credit, and what they forget "
                      "to say (api/docs/adding_a_product.md)");
  command->add_option("--bbox", arguments->box, "keep only W,S,E,N (degrees), with one cell around")
      ->delimiter(',')
      ->expected(4);
  command->add_option("--site", arguments->site, "keep only what surrounds this site");
  command->add_option("--at", context.at,
                      "the present moment, for tests and replays (default: the clock)");
  command->footer(
      "Ingesting a file twice does nothing. A file is in the store wholly or not at all.\n"
      "Files over 512 MB need --bbox or --site.");
  command->callback([arguments, &context] { ingest_all(*arguments, context); });
}

}  // namespace slackwater::api
