#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/progress.h"
#include "api/perception/read_picture.h"
#include "api/perception/score_detector.h"
#include "api/program/named_sheet.h"
#include "api/show/perception/detection_sheet.h"
#include "api/show/perception/detector_told.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct DetectArguments {
  std::vector<std::string> files;
  std::string by;
  std::filesystem::path score;
  std::filesystem::path labels;
  std::filesystem::path out;
  std::filesystem::path pod;
};

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

/// As the tools of COCO read results: all that the precision was asked of.
json results_json(const DetectorScore& score, const LabelledPictures& set) {
  json results = json::array();
  for (std::size_t i = 0; i < score.pictures.size(); ++i) {
    const ScoredPicture& picture = score.pictures[i];
    for (const auto* finds : {&picture.found, &picture.unsure})
      for (const Detection& one : *finds) {
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

/// A sheet for each curve, KIND_by_DETECTOR.yaml.
void write_sheets(const std::vector<MeasuredPod>& pods, const std::string& detector,
                  const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem)
    throw Error(ErrorKind::unavailable,
                "--pod: cannot make the folder " + folder.string() + ": " + problem.message());
  const std::string stem = std::filesystem::path(detector).stem().string();
  for (const MeasuredPod& pod : pods)
    if (pod.fit)
      write_text(folder / formatted("{}_by_{}.yaml", twin::name_of(pod.kind), stem),
                 detection_sheet(pod, stem));
}

void score_on(const DetectArguments& arguments, Detector& detector, const Context& context) {
  const LabelledPictures set = read_labelled_pictures(arguments.score, arguments.labels);
  ProgressBar progress("pictures", context.json);
  const DetectorScore score = score_detector(detector, set, [&](std::size_t done) {
    progress.update(static_cast<double>(done) / static_cast<double>(set.pictures.size()));
  });
  std::vector<MeasuredPod> pods;
  if (!arguments.pod.empty()) pods = measure_pod(score, set);
  const std::vector<BandScore> bands = score_by_band(score, set);
  if (!arguments.out.empty()) write_text(arguments.out, dumped(results_json(score, set)) + "\n");
  if (!arguments.pod.empty()) write_sheets(pods, arguments.by, arguments.pod);
  if (!context.json) {
    std::printf("%s%s", words_of(score).c_str(), words_of(bands).c_str());
    if (!pods.empty()) std::printf("%s", words_of(pods).c_str());
    return;
  }
  json out = {{"pictures", score.pictures.size()},
              {"kinds", json::array()},
              {"not_looked_for", score.only_labels},
              {"not_scored", score.only_finds}};
  for (const KindScore& kind : score.kinds) out["kinds"].push_back(json_of(kind));
  if (!bands.empty()) out["thirds"] = json::array();
  for (const BandScore& band : bands) out["thirds"].push_back(json_of(band));
  if (!pods.empty()) out["pod"] = json::array();
  for (const MeasuredPod& pod : pods) out["pod"].push_back(json_of(pod));
  std::printf("%s\n", dumped(out).c_str());
}

}  // namespace

void add_detect(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<DetectArguments>();
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
  command->add_option("--pod", arguments->pod,
                      "with --score of a stage's looks: the probability of detection by size, a "
                      "file for data/detection for each kind in this FOLDER");
  command->callback([arguments, &context] {
    if (arguments->files.empty() == arguments->score.empty())
      throw Error(ErrorKind::usage,
                  std::string(arguments->files.empty() ? "found neither pictures nor"
                                                       : "found both pictures and") +
                      " --score FOLDER, expected one of them: pictures to look at, or "
                      "a folder with labels to be held against");
    if (arguments->score.empty() &&
        !(arguments->out.empty() && arguments->labels.empty() && arguments->pod.empty()))
      throw Error(ErrorKind::usage,
                  "found --out, --labels or --pod without --score FOLDER, to which they belong: "
                  "add it, "
                  "or take --json for what is found in single pictures");
    expect_output("--out", arguments->out, {".json"});
    const auto detector = load_detector(arguments->by);
    if (arguments->score.empty()) {
      detect_in(arguments->files, *detector, context);
    } else {
      score_on(*arguments, *detector, context);
    }
  });
}

}  // namespace slackwater::api
