#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/progress.h"
#include "api/perception/read_picture.h"
#include "api/perception/score_detector.h"
#include "api/program/named_sheet.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::string dumped(const json& value) {
  return value.dump(2, ' ', false, json::error_handler_t::replace);
}

json detection_json(const Detection& found) {
  const PixelBox& box = found.box;
  return {{"of", found.of},
          {"confidence", found.confidence},
          {"bbox", {box.left, box.top, box.right - box.left, box.bottom - box.top}}};
}

void detect_in(const std::vector<std::string>& files, Detector& detector, const Context& context) {
  json out = {{"pictures", json::array()}};
  ProgressBar progress("pictures", context.json);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const twin::Picture picture = read_picture(files[i]);
    const std::vector<Detection> found = detector.find(picture);
    progress.update(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    json of_file = {{"file", files[i]},
                    {"width", picture.wide},
                    {"height", picture.high},
                    {"found", json::array()}};
    for (const Detection& one : found) of_file["found"].push_back(detection_json(one));
    out["pictures"].push_back(std::move(of_file));
    if (context.json) continue;
    std::printf("%s: %s\n", files[i].c_str(),
                found.empty() ? "nothing found" : counted(found.size(), "find").c_str());
    for (const Detection& one : found)
      std::printf("  %-12s confidence %.2f  at %.0f, %.0f  %.0f x %.0f px\n", one.of.c_str(),
                  one.confidence, one.box.left, one.box.top, one.box.right - one.box.left,
                  one.box.bottom - one.box.top);
  }
  if (context.json) std::printf("%s\n", dumped(out).c_str());
}

json share_json(const std::optional<double>& share) { return share ? json(*share) : json(); }

json kind_json(const KindScore& kind) {
  json ap;
  if (kind.average_precision)
    ap = {{"value", kind.average_precision->share},
          {"interval_95", {kind.average_precision->low, kind.average_precision->high}}};
  return {{"of", kind.of},
          {"labels", kind.labels},
          {"found", kind.found},
          {"ap50", ap},
          {"recall", share_json(kind.recall)},
          {"precision", share_json(kind.precision)},
          {"false_alarms_per_100_empty_pictures", share_json(kind.false_alarms_per_100)}};
}

/// As the tools of COCO read results.
json results_json(const DetectorScore& score, const LabelledPictures& set) {
  json results = json::array();
  for (std::size_t i = 0; i < score.pictures.size(); ++i) {
    for (const Detection& one : score.pictures[i].found) {
      const auto category = set.categories.find(one.of);
      if (category == set.categories.end()) continue;
      json result = detection_json(one);
      results.push_back({{"image_id", set.pictures[i].id},
                         {"category_id", category->second},
                         {"bbox", result["bbox"]},
                         {"score", one.confidence}});
    }
  }
  return results;
}

void print_score(const DetectorScore& score) {
  const auto percent = [](const std::optional<double>& share) {
    return share ? formatted("{:.0f} %", 100 * *share) : std::string("-");
  };
  std::printf("%s\n", counted(score.pictures.size(), "picture").c_str());
  std::printf("%-14s %7s %7s  %-22s %7s %10s  %s\n", "kind", "labels", "finds",
              "AP50 (95 of 100 sets)", "recall", "precision",
              "false alarms in 100 pictures without a label");
  for (const KindScore& kind : score.kinds) {
    const std::string ap =
        kind.average_precision
            ? formatted("{:.3f} ({:.3f} to {:.3f})", kind.average_precision->share,
                        kind.average_precision->low, kind.average_precision->high)
            : "-";
    std::printf("%-14s %7zu %7zu  %-22s %7s %10s  %s\n", kind.of.c_str(), kind.labels, kind.found,
                ap.c_str(), percent(kind.recall).c_str(), percent(kind.precision).c_str(),
                kind.false_alarms_per_100 ? formatted("{:.1f}", *kind.false_alarms_per_100).c_str()
                                          : "- (all pictures have labels)");
  }
  if (!score.only_labels.empty())
    std::printf("Not looked for: %s: the detector does not know them.\n",
                joined(score.only_labels, ", ").c_str());
  if (!score.only_finds.empty())
    std::printf("Not scored: %s: no label is of them.\n", joined(score.only_finds, ", ").c_str());
}

void score_on(const std::filesystem::path& folder, const std::filesystem::path& labels,
              Detector& detector, const std::filesystem::path& out, const Context& context) {
  const LabelledPictures set = read_labelled_pictures(folder, labels);
  ProgressBar progress("pictures", context.json);
  const DetectorScore score = score_detector(detector, set, [&](std::size_t done) {
    progress.update(static_cast<double>(done) / static_cast<double>(set.pictures.size()));
  });
  if (!out.empty()) write_text(out, dumped(results_json(score, set)) + "\n");
  if (!context.json) return print_score(score);
  json kinds = json::array();
  for (const KindScore& kind : score.kinds) kinds.push_back(kind_json(kind));
  std::printf("%s\n", dumped({{"pictures", score.pictures.size()},
                              {"kinds", kinds},
                              {"not_looked_for", score.only_labels},
                              {"not_scored", score.only_finds}})
                          .c_str());
}

}  // namespace

void add_detect(CLI::App& app, Context& context) {
  struct Arguments {
    std::vector<std::string> files;
    std::string by;
    std::filesystem::path score;
    std::filesystem::path labels;
    std::filesystem::path out;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "detect", "What a detector finds in pictures, and how well it does on labelled ones");
  command->add_option("picture", arguments->files, "PNG or JPEG files");
  command
      ->add_option("--by", arguments->by,
                   "the detector: one of " + joined(known_sheets("detectors"), ", ") +
                       ", or a file of that form")
      ->required();
  command->add_option("--score", arguments->score,
                      "a folder of pictures with labels as COCO has them: how much is found");
  command->add_option("--labels", arguments->labels,
                      "the labels, where the folder has several JSON files");
  command->add_option("--out", arguments->out,
                      "with --score: the finds as FILE.json of COCO results");
  command->callback([arguments, &context] {
    if (arguments->files.empty() == arguments->score.empty())
      throw Error(ErrorKind::usage,
                  std::string(arguments->files.empty() ? "found neither pictures nor"
                                                       : "found both pictures and") +
                      " --score FOLDER, expected one of them: pictures to look at, or "
                      "a folder with labels to be held against");
    if (arguments->score.empty() && !(arguments->out.empty() && arguments->labels.empty()))
      throw Error(ErrorKind::usage,
                  "found --out or --labels without --score FOLDER, to which they belong: add it, "
                  "or take --json for what is found in single pictures");
    expect_output("--out", arguments->out, {".json"});
    const auto detector = load_detector(arguments->by);
    if (arguments->score.empty()) {
      detect_in(arguments->files, *detector, context);
    } else {
      score_on(arguments->score, arguments->labels, *detector, arguments->out, context);
    }
  });
}

}  // namespace slackwater::api
