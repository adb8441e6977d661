#include "api/pipeline/fetch/fetcher.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

struct TroubleWords {
  const char* name;
  const char* words;
};
/// In the order of `Trouble`.
constexpr std::array all_troubles{
    TroubleWords{"slow_down", "the service asks to be asked less often"},
    TroubleWords{"outage", "the service does not answer"},
    TroubleWords{"updating", "not out yet"},
    TroubleWords{"credentials", "its user name or password is missing or not accepted"},
    TroubleWords{"refused", "the service has no such data"},
    TroubleWords{"no_room", "no room on the disk"},
    TroubleWords{"memory", "it wanted more memory than it may have"},
    TroubleWords{"too_slow", "it took longer than it may"},
    TroubleWords{"not_installed", "the program is not installed"},
    TroubleWords{"damaged", "what came is not what was asked for"},
    TroubleWords{"unknown", "it failed"},
    TroubleWords{"stopped", "stopped"},
};

const std::array<std::string, 6> all_kinds{"currents",   "level", "waves",
                                           "bathymetry", "wind",  "wind forecast"};

Trouble trouble_named(const Config& message) {
  const std::string name = message.text("means");
  std::vector<std::string> known;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(Trouble::not_installed); ++i) {
    if (name == all_troubles[i].name) return static_cast<Trouble>(i);
    known.emplace_back(all_troubles[i].name);
  }
  message.refuse("means", "found " + name + ", expected one of " + joined(known, ", "));
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::chrono::milliseconds seconds(const Config& config, const char* key,
                                  std::chrono::milliseconds otherwise) {
  const auto found = config.optional_number(key, {0, 86400});
  return found ? std::chrono::milliseconds(std::llround(*found * 1000)) : otherwise;
}

/// What stands for a word in braces; none: the argument is left out.
using Words = std::map<std::string, std::vector<std::string>>;

Words words_for(const Fetcher& fetcher, const WantedFile& wanted,
                const std::filesystem::path& target, const std::string& address) {
  Words words;
  const auto put = [&](const char* word, const std::string& value) {
    words[word];
    if (!value.empty()) words[word].push_back(value);
  };
  const auto degrees = [](double value) { return formatted("{:.3f}", value); };
  put("dataset", wanted.dataset_id);
  put("product", wanted.product_id);
  put("part", wanted.part.value_or(""));
  words["variable"] = wanted.variables;
  put("west", degrees(wanted.box.west_deg));
  put("east", degrees(wanted.box.east_deg));
  put("south", degrees(wanted.box.south_deg));
  put("north", degrees(wanted.box.north_deg));
  put("shallowest", wanted.deepest_m ? "0" : "");
  put("deepest", wanted.deepest_m ? formatted("{:.0f}", *wanted.deepest_m) : "");
  put("from", wanted.from ? compact_time(*wanted.from) : "");
  put("to", wanted.to ? compact_time(*wanted.to) : "");
  put("run", wanted.run ? compact_time(*wanted.run) : "");
  put("address", address);
  put("here", fetcher.folder.string());
  put("folder", target.parent_path().string());
  put("file", target.filename().string());
  put("target", target.string());
  return words;
}

/// The word in braces of an argument, at its place; npos: it has none.
std::pair<std::size_t, std::string> word_in(const std::string& argument) {
  const std::size_t from = argument.find('{');
  const std::size_t to = from == std::string::npos ? from : argument.find('}', from);
  if (to == std::string::npos) return {std::string::npos, ""};
  return {from, argument.substr(from + 1, to - from - 1)};
}

void expect_words(const Config& config, const std::vector<std::string>& arguments) {
  const Words known = words_for({}, {}, "folder/file", "");
  std::vector<std::string> names;
  for (const auto& [name, values] : known) names.push_back("{" + name + "}");
  for (const std::string& argument : arguments) {
    const auto [at, word] = word_in(argument);
    if (at == std::string::npos) continue;
    if (!known.contains(word))
      config.refuse("arguments", "found {" + word + "}, expected one of " + joined(names, ", "));
    if (argument.find('{', at + 1) != std::string::npos)
      config.refuse("arguments", "found two words in braces in " + argument +
                                     ", expected one in an argument; give each its own");
  }
}

}  // namespace

const char* words_of(Trouble trouble) noexcept {
  return all_troubles[static_cast<std::size_t>(trouble)].words;
}

bool is_passing(Trouble trouble) noexcept {
  return trouble == Trouble::slow_down || trouble == Trouble::outage ||
         trouble == Trouble::too_slow || trouble == Trouble::damaged || trouble == Trouble::unknown;
}

bool Fetcher::fetches(const std::string& kind) const {
  return std::find(serves.begin(), serves.end(), kind) != serves.end();
}

bool Fetcher::is_asked_by_step() const {
  return std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return argument.find("{address}") != std::string::npos;
  });
}

Fetcher read_fetcher(const Config& config) {
  Fetcher fetcher;
  fetcher.id = config.text("id");
  fetcher.serves = config.texts("serves");
  for (const std::string& kind : fetcher.serves)
    if (std::find(all_kinds.begin(), all_kinds.end(), kind) == all_kinds.end())
      config.refuse("serves", "found " + kind + ", expected some of " + joined(all_kinds, ", "));
  fetcher.order = config.optional_integer("order", 0, 1000).value_or(fetcher.order);
  fetcher.program = config.text("program");
  fetcher.arguments = config.texts("arguments");
  expect_words(config, fetcher.arguments);
  fetcher.environment = config.texts("environment");
  fetcher.secrets = config.texts("secrets");
  fetcher.longest = std::chrono::duration_cast<std::chrono::seconds>(
      seconds(config, "longest_s", fetcher.longest));
  fetcher.memory_gb = config.optional_number("memory_gb", {0.1, 1000}).value_or(fetcher.memory_gb);
  fetcher.attempts = config.optional_integer("attempts", 1, 20).value_or(fetcher.attempts);
  fetcher.first_wait = seconds(config, "first_wait_s", fetcher.first_wait);
  fetcher.between = seconds(config, "between_s", fetcher.between);
  for (const Config& message : config.children("messages"))
    fetcher.messages.push_back({lower(message.text("says")), trouble_named(message)});
  config.expect_all_read();
  return fetcher;
}

std::vector<Fetcher> known_fetchers(const std::filesystem::path& data_folder,
                                    const std::optional<std::filesystem::path>& own_folder) {
  std::map<std::string, Fetcher> by_id;
  const auto read_all = [&](const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) return;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".yaml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) {
      Fetcher fetcher = read_fetcher(Config::load(file));
      fetcher.folder = folder;
      by_id[fetcher.id] = std::move(fetcher);
    }
  };
  read_all(data_folder / "fetchers");
  if (own_folder) read_all(*own_folder / "fetchers");
  std::vector<Fetcher> all;
  all.reserve(by_id.size());
  for (auto& [id, fetcher] : by_id) all.push_back(std::move(fetcher));
  std::stable_sort(all.begin(), all.end(),
                   [](const Fetcher& a, const Fetcher& b) { return a.order < b.order; });
  return all;
}

FetchRequest request_for(const Fetcher& fetcher, const WantedFile& wanted,
                         const std::filesystem::path& target, const std::string& address) {
  const Words words = words_for(fetcher, wanted, target, address);
  FetchRequest request{{fetcher.program}, target};
  for (const std::string& argument : fetcher.arguments) {
    const auto [at, word] = word_in(argument);
    if (at == std::string::npos) {
      request.arguments.push_back(argument);
      continue;
    }
    for (const std::string& value : words.at(word)) {
      std::string filled = argument;
      request.arguments.push_back(filled.replace(at, word.size() + 2, value));
    }
  }
  return request;
}

Trouble trouble_of(const Fetcher& fetcher, const ProgramEnded& ended) {
  switch (ended.end) {
    case ProgramEnded::End::not_found:
      return Trouble::not_installed;
    case ProgramEnded::End::out_of_time:
      return Trouble::too_slow;
    case ProgramEnded::End::stopped:
      return Trouble::stopped;
    case ProgramEnded::End::killed:
    case ProgramEnded::End::exited:
      break;
  }
  const std::string said = lower(ended.output);
  for (const Fetcher::Message& message : fetcher.messages)
    if (said.find(message.says) != std::string::npos) return message.means;
  return Trouble::unknown;
}

std::string last_word(const Fetcher& fetcher, const std::string& output) {
  std::string text = output;
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  text = text.substr(
      text.find_last_of("\r\n") == std::string::npos ? 0 : text.find_last_of("\r\n") + 1);
  for (const std::string& name : fetcher.secrets) {
    const char* const value = std::getenv(name.c_str());
    if (value == nullptr || *value == '\0') continue;
    std::string secret = value;
    while (!secret.empty() && std::isspace(static_cast<unsigned char>(secret.back())))
      secret.pop_back();
    if (secret.empty()) continue;
    constexpr std::string_view instead = "***";
    for (std::size_t at = 0; (at = text.find(secret, at)) != std::string::npos;
         at += instead.size())
      text.replace(at, secret.size(), instead);
  }
  constexpr std::size_t most = 300;
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

std::vector<std::string> environment_of(const Fetcher& fetcher) {
  std::vector<std::string> environment;
  for (const std::string& name : fetcher.environment)
    if (const char* const value = std::getenv(name.c_str()))
      environment.push_back(name + "=" + value);
  return environment;
}

}  // namespace slackwater::api
