#include <cmath>

#include "ingest/cf/granule_file.h"
#include "tests/fuzz/fuzz_case.h"
#include "tests/fuzz/scratch_folder.h"

/// Content files of the store, as a damaged disk might return them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slackwater;
  const auto path = fuzz::scratch_folder().file_of(data, size, "granule.nc");
  fuzz::accepts([&] {
    const auto file = ingest::GranuleFile::open(path);
    const Granule& granule = file.granule();
    expect_canonical(granule.grid);
    const std::size_t slab = granule.grid.levels() * granule.grid.rows() * granule.grid.columns();
    if (slab > (std::size_t{1} << 20)) return;
    for (const GranuleVariable& variable : granule.variables) {
      const GriddedField field = file.read(variable.standard_name, 0, 1, 0, granule.grid.rows(), 0,
                                           granule.grid.columns());
      fuzz::claim(field.values.size() == slab, "a field of another size than was asked for");
      fuzz::claim(field.status.empty() || field.status.size() == slab,
                  "a status for some values only");
      for (const SampleStatus status : field.status) {
        fuzz::claim(status <= SampleStatus::suspect, "a status that does not exist");
      }
    }
  });
  return 0;
}
