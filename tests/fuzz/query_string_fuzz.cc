#include <array>
#include <set>
#include <string>

#include "api/door/edr/read/crs.h"
#include "api/door/edr/read/parameter_names.h"
#include "api/door/edr/read/query_string.h"
#include "api/door/edr/write/content.h"
#include "fields/base/encode/percent.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;
using namespace slackwater::api::edr;

void check_query(std::string_view text) {
  fuzz::accepts([&] {
    const QueryString query = QueryString::parse(text);
    std::string written;
    std::set<std::string> keys;
    for (const auto& [key, value] : query.all()) {
      fuzz::claim(!key.empty() && keys.insert(key).second, "an empty or repeated key");
      fuzz::claim((key + value).find('\0') == std::string::npos, "a NUL byte");
      written += percent_encoded(key) + "=" + percent_encoded(value) + "&";
    }
    if (written.size() > max_query_bytes) return;
    fuzz::claim(QueryString::parse(written).all() == query.all(),
                "a query changes when it is written and read");
  });
}

void check_choices(std::string_view text) {
  constexpr std::array offered{Format::coverage_json, Format::csv};
  const std::vector<std::string> known{"eastward_sea_water_velocity", "wind_speed"};
  fuzz::accepts([&] { (void)choose_format("", text, offered); });
  fuzz::accepts([&] { (void)choose_format(text, "", offered); });
  fuzz::accepts([&] { expect_supported_crs(text); });
  fuzz::accepts([&] {
    const auto asked = parse_parameter_names(text, known);
    fuzz::claim(!asked.empty() && asked.size() <= known.size(), "no parameter, or one twice");
  });
}

}  // namespace

/// Query strings and what is chosen by name: formats, parameters, reference systems.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  check_query(text);
  check_choices(text);
  return 0;
}
