#include <cmath>

#include "ingest/cf/units.h"
#include "tests/fuzz/fuzz_case.h"

/// Unit texts against each canonical unit that the vocabulary uses.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slackwater;
  const std::string_view text = fuzz::text_of(data, size);
  for (const char* canonical : {"m s-1", "m", "s", "degree", "K", "1"}) {
    fuzz::accepts([&] {
      const auto conversion = ingest::unit_conversion(text, canonical, "a quantity");
      fuzz::claim(std::isfinite(conversion.scale) && conversion.scale != 0,
                  "a unit without a scale");
      fuzz::claim(std::isfinite(conversion.offset), "a unit whose zero is not finite");
    });
  }
  return 0;
}
