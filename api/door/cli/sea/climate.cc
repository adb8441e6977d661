#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/door/cli/sea/history_options.h"
#include "api/program/paths.h"
#include "api/show/history/climate_answer.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

struct ClimateArguments {
  HistoryArguments history;
  bool roses = false;
  bool scatter = false;
  bool extremes = false;
  std::vector<std::string> of;
  std::size_t sectors = 12;
  std::vector<std::string> classes;
  std::vector<std::string> calms;
  std::vector<std::string> thresholds;
  std::vector<double> return_years;
  std::string separation;
  double storms_per_year = 5;
  std::size_t resamples = 1000;
  std::uint64_t seed = 1;
};

/// What is said of each once.
std::vector<ClimateNumbers> numbers_of(const char* option, const std::vector<std::string>& texts,
                                       ClimateNumbers (*parse)(const std::string&)) {
  std::vector<ClimateNumbers> all;
  for (const std::string& text : texts) {
    ClimateNumbers one = option_value(option, text, parse);
    for (const ClimateNumbers& other : all)
      if (other.of == one.of)
        throw Error(ErrorKind::usage, formatted("found {} of {} twice, expected it once", option,
                                                kind_of(one.of).word));
    all.push_back(std::move(one));
  }
  return all;
}

void expect_no_period(const char* option, const std::vector<ClimateNumbers>& all) {
  for (const ClimateNumbers& one : all)
    if (one.of == ClimateOf::period)
      throw Error(ErrorKind::usage,
                  formatted("found {} of period, expected wind, waves or current", option));
}

/// Numbers that nothing asks for would be taken as heard.
void expect_used(const char* option, const std::vector<ClimateNumbers>& all,
                 const ClimateQuestion& question, bool is_of_use) {
  for (const ClimateNumbers& one : all) {
    // Periods are those of waves, in scatter tables alone.
    const bool is_period = one.of == ClimateOf::period;
    const ClimateOf of = is_period ? ClimateOf::waves : one.of;
    const bool is_asked =
        std::find(question.of.begin(), question.of.end(), of) != question.of.end();
    if (!is_asked || !(is_period ? question.scatter : is_of_use))
      throw Error(ErrorKind::usage,
                  formatted("found {} of {}, which nothing that is asked for uses; "
                            "leave it away, or ask for more",
                            option, kind_of(one.of).word));
  }
}

/// And those of what the series do not have.
void expect_there(const char* option, const std::vector<ClimateNumbers>& all,
                  const ClimateAnswer& answer) {
  for (const ClimateNumbers& one : all) {
    const ClimateOf of = one.of == ClimateOf::period ? ClimateOf::waves : one.of;
    if (std::none_of(answer.parts.begin(), answer.parts.end(),
                     [&](const ClimatePart& part) { return part.of == of; }))
      throw Error(ErrorKind::usage, formatted("found {} of {}, and no {} in the series", option,
                                              kind_of(one.of).word, kind_of(of).word));
  }
}

/// @param options  those of extremes alone
void expect_extremes(const CLI::App& command, const std::vector<const char*>& options) {
  for (const char* option : options)
    if (command.count(option) > 0)
      throw Error(ErrorKind::usage, formatted("found {} without --extremes", option));
}

ClimateQuestion question_of(const ClimateArguments& arguments, const CLI::App& command) {
  ClimateQuestion question;
  const bool is_chosen = arguments.roses || arguments.scatter || arguments.extremes;
  question.roses = !is_chosen || arguments.roses;
  question.scatter = !is_chosen || arguments.scatter;
  question.extremes = !is_chosen || arguments.extremes;
  if (!arguments.of.empty()) {
    question.of.clear();
    for (const std::string& text : arguments.of) {
      const ClimateOf of = option_value("--of", text, parse_climate_of);
      if (std::find(question.of.begin(), question.of.end(), of) == question.of.end())
        question.of.push_back(of);
    }
  }
  question.sectors = arguments.sectors;
  question.classes = numbers_of("--classes", arguments.classes, parse_climate_numbers);
  for (const ClimateNumbers& one : question.classes)
    if (one.values.front() == 0)
      throw Error(ErrorKind::usage,
                  "found --classes of " + kind_of(one.of).word +
                      " from 0 on; leave the 0 away, the first class begins there");
  question.calms = numbers_of("--calm", arguments.calms, parse_climate_number);
  question.thresholds = numbers_of("--threshold", arguments.thresholds, parse_climate_number);
  expect_no_period("--calm", question.calms);
  expect_no_period("--threshold", question.thresholds);
  if (!question.extremes)
    expect_extremes(command, {"--return-period", "--threshold", "--storms-per-year", "--separation",
                              "--resamples", "--seed"});
  if (!question.roses && !question.scatter && command.count("--sectors") > 0)
    throw Error(ErrorKind::usage, "found --sectors without --roses or --scatter");
  for (const ClimateNumbers& one : question.classes)
    expect_used("--classes", {one}, question,
                question.roses || (question.scatter && one.of == ClimateOf::waves));
  expect_used("--calm", question.calms, question, question.roses);
  expect_used("--threshold", question.thresholds, question, true);
  if (!arguments.return_years.empty()) {
    for (const double years : arguments.return_years)
      if (!(years >= least_return_years && years <= most_return_years))
        throw Error(ErrorKind::usage,
                    formatted("found --return-period {:g}, expected {:g} to {:g} years", years,
                              least_return_years, most_return_years));
    question.storms.return_years = return_periods(arguments.return_years);
  }
  if (!arguments.separation.empty()) {
    question.separation = option_value("--separation", arguments.separation, parse_duration);
    if (question.separation <= Duration(0))
      throw Error(ErrorKind::usage,
                  "found --separation " + arguments.separation + ", expected more than 0");
  }
  question.storms.storms_per_year = arguments.storms_per_year;
  question.storms.resamples = arguments.resamples;
  question.storms.seed = arguments.seed;
  return question;
}

void run_climate(const ClimateArguments& arguments, const CLI::App& command,
                 const Context& context) {
  const ingest::Vocabulary vocabulary =
      ingest::Vocabulary::load(data_folder() / "products" / "variables.yaml");
  const HistorySource source = source_of(arguments.history, context);
  const ClimateQuestion question = question_of(arguments, command);
  const History history = load_history(source, wanted_by(question), vocabulary);
  const ClimateAnswer answer = answer_of(history, question, vocabulary);
  expect_there("--classes", question.classes, answer);
  expect_there("--calm", question.calms, answer);
  expect_there("--threshold", question.thresholds, answer);
  print_history_answer(climate_json(history, question, answer),
                       climate_text(history, question, answer), context);
}

}  // namespace

void add_climate(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<ClimateArguments>();
  CLI::App* command = app.add_subcommand(
      "climate", "Roses, scatter tables and extremes of a history of wind, waves and currents");
  add_history_series(*command, arguments->history);
  command->add_flag("--roses", arguments->roses, "share of time by direction and class");
  command->add_flag("--scatter", arguments->scatter,
                    "wave heights by peak period and by direction, per mille");
  command->add_flag("--extremes", arguments->extremes,
                    "return values with intervals; of the three all where none is named");
  command->add_option("--of", arguments->of, "wind, waves, current (default: what there is)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--sectors", arguments->sectors, "of roses (default 12)")
      ->check(CLI::Range(1, 360));
  command
      ->add_option("--classes", arguments->classes,
                   "'NAME=EDGES UNIT' of wind, waves, current or period, e.g. 'wind=5,10,15 kt'")
      ->allow_extra_args(false);
  command
      ->add_option("--calm", arguments->calms,
                   "'NAME=VALUE UNIT', what is less is a calm (wind 0.5 m/s, waves 0.1 m, current "
                   "0.05 m/s)")
      ->allow_extra_args(false);
  command
      ->add_option("--return-period", arguments->return_years,
                   "years, e.g. 1,10,50,100 (the default)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--threshold", arguments->thresholds,
                   "'NAME=VALUE UNIT', over which peaks are storms (default: by their number)")
      ->allow_extra_args(false);
  command
      ->add_option("--storms-per-year", arguments->storms_per_year,
                   "that the threshold is chosen by (default 5)")
      ->check(CLI::Range(0.1, 100.0));
  command->add_option("--separation", arguments->separation,
                      "below the threshold between two storms (default 48h)");
  command->add_option("--resamples", arguments->resamples, "of the bootstrap (default 1000)")
      ->check(CLI::Range(100, 100000));
  command->add_option("--seed", arguments->seed, "of the bootstrap (default 1)");
  add_history_options(*command, arguments->history);
  command->callback([arguments, command, &context] { run_climate(*arguments, *command, context); });
}

}  // namespace slackwater::api
