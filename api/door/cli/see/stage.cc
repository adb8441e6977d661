#include <CLI/CLI.hpp>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/progress.h"
#include "api/program/named_sheet.h"
#include "api/program/paths.h"
#include "api/show/render/data_card.h"
#include "api/show/render/look_file.h"
#include "api/show/render/picture_labels.h"
#include "api/show/render/png_file.h"
#include "fields/base/parallel.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "twin/render/stage/staged_look.h"

namespace slackwater::api {
namespace {

struct StageArguments {
  std::string stage;
  std::size_t looks = 0;
  std::uint64_t seed = 1;
  std::filesystem::path out;
  bool truth = false;
  int threads = 1;
};

std::string look_name(std::size_t number, const char* ending = ".png") {
  return formatted("look_{:06}{}", number, ending);
}

void run_stage(const StageArguments& arguments, const Context& context) {
  const twin::Stage stage(
      twin::read_look_stage(load_sheet("stages", "STAGE", arguments.stage, {}), data_folder()));
  std::error_code problem;
  std::filesystem::create_directories(arguments.out, problem);
  if (problem)
    throw Error(ErrorKind::unavailable, "--out: cannot make the folder " + arguments.out.string() +
                                            ": " + problem.message());
  ProgressBar progress("looks", context.json);
  PictureLabels labels;
  std::size_t planted = 0, shown = 0;
  std::mutex one_file;
  constexpr std::size_t at_once = 32;
  for (std::size_t from = 0; from < arguments.looks; from += at_once) {
    std::vector<twin::StagedLook> looks(std::min(at_once, arguments.looks - from));
    for_all(looks.size(), arguments.threads, [&](std::size_t i) {
      looks[i] = stage.look(arguments.seed, from + i, 1);
      const twin::Picture& seen = looks[i].picture;
      write_png(arguments.out / look_name(from + i), seen.wide, seen.high, 3, seen.rgb);
      if (!arguments.truth) return;
      const std::lock_guard lock(one_file);  // the netCDF library is for one thread at a time
      write_look_netcdf(looks[i], stage, arguments.out / look_name(from + i, ".nc"));
    });
    for (std::size_t i = 0; i < looks.size(); ++i) {
      labels.add(looks[i], look_name(from + i));
      planted += looks[i].defects.size();
      for (const twin::StagedDefect& defect : looks[i].defects) shown += defect.pixels > 0 ? 1 : 0;
    }
    progress.update(static_cast<double>(from + looks.size()) /
                    static_cast<double>(arguments.looks));
  }
  write_text(arguments.out / "labels.json", labels.coco().dump() + "\n");
  write_text(arguments.out / "README.md", data_card(stage.sheet(), arguments.seed, labels.coco()));
  if (context.json) {
    const nlohmann::json out = {{"stage", stage.sheet().name},
                                {"seed", arguments.seed},
                                {"looks", arguments.looks},
                                {"planted", planted},
                                {"shown", shown},
                                {"folder", arguments.out.string()}};
    std::printf("%s\n", out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return;
  }
  std::printf(
      "%s: %s in %s, with labels.json (COCO) and README.md; %s planted, %zu of them in "
      "view\n",
      stage.sheet().name.c_str(), counted(arguments.looks, "picture").c_str(),
      arguments.out.c_str(), counted(planted, "defect").c_str(), shown);
}

}  // namespace

void add_stage(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<StageArguments>();
  CLI::App* command = app.add_subcommand(
      "stage", "Labelled pictures of staged looks, to learn from and to measure detectors with");
  command
      ->add_option("stage", arguments->stage,
                   "one of " + joined(known_sheets("stages"), ", ") + ", or a file of that form")
      ->required();
  command->add_option("--looks", arguments->looks, "how many pictures")
      ->required()
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", arguments->seed, "other looks (default 1)");
  command->add_option("--out", arguments->out, "folder of the pictures")->required();
  command->add_flag("--truth", arguments->truth,
                    "beside each picture its truth as netCDF: depth, defects and more by pixel");
  command->add_option("--threads", arguments->threads, "1 to 64 (default 1)")
      ->check(CLI::Range(1, 64));
  command->callback([arguments, &context] { run_stage(*arguments, context); });
}

}  // namespace slackwater::api
