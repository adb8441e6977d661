// made_up_answers OUT: writes an answer of each domain type, of one domain and of three, with and
// without levels, in each format, for strangers' tools to open:
// OUT/<kind>-<domains>.{covjson,geojson,csv,nc}.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "api/door/edr/write/body.h"
#include "fields/base/error.h"
#include "tests/api/door/edr/made_up_answer.h"

namespace {

using namespace slackwater;
using api::edr::Answer;
using api::edr::DomainType;
using api::edr::Format;

struct Kind {
  const char* name;
  DomainType type;
};

constexpr Kind kinds[] = {{"point", DomainType::point},
                          {"series", DomainType::point_series},
                          {"profile", DomainType::vertical_profile},
                          {"grid", DomainType::grid},
                          {"trajectory", DomainType::trajectory}};

const char* ending(Format format) {
  switch (format) {
    case Format::coverage_json:
      return ".covjson";
    case Format::geojson:
      return ".geojson";
    case Format::csv:
      return ".csv";
    default:
      return ".nc";
  }
}

void write(const std::filesystem::path& folder, const std::string& name, const Answer& answer) {
  for (const Format format : api::edr::answer_formats()) {
    if (format == Format::json) continue;  // the CoverageJSON document under another name
    std::ofstream file(folder / (name + ending(format)), std::ios::binary);
    file << write_answer(answer, format).bytes;
    if (!file.flush()) throw Error(ErrorKind::unavailable, "cannot write " + name);
  }
}

/// The same values at the sea surface, without a vertical axis: one level only.
Answer without_levels(DomainType type, std::size_t domains) {
  Answer answer = tests::made_up_answer(type, domains, 1);
  answer.vertical = api::edr::Vertical::none;
  for (auto& coverage : answer.coverages) coverage.vertical_m.clear();
  return answer;
}

Answer as_heights(Answer answer) {
  answer.vertical = api::edr::Vertical::height_up;
  return answer;
}

/// A line at one depth.
Answer at_one_level(Answer answer) {
  for (auto& coverage : answer.coverages) coverage.vertical_m.resize(1);
  return answer;
}

void write_all(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const std::size_t domains : {1, 3}) {
    const std::string count = "-" + std::to_string(domains);
    for (const Kind& kind : kinds) {
      const Answer answer = tests::made_up_answer(kind.type, domains);
      write(folder, kind.name + count, answer);
      write(folder, std::string(kind.name) + "_up" + count, as_heights(answer));
      if (kind.type == DomainType::vertical_profile) continue;
      write(folder, std::string(kind.name) + "_flat" + count, without_levels(kind.type, domains));
    }
    write(folder, "trajectory_level" + count,
          at_one_level(tests::made_up_answer(DomainType::trajectory, domains)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "give OUT\n");
    return 2;
  }
  try {
    write_all(argv[1]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return 0;
}
