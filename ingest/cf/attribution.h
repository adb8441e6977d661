#pragma once
#include <string>
#include <string_view>

#include "ingest/copernicus/product.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// The sentence to print where a file's data are shown: that of its product, which was recognised
/// by what the file says of itself; else what the file asks for (`acknowledgement`, `citation`,
/// `credit`); else its maker ("Data of INSTITUTE"), or its title or source alone; else "Source
/// not named in the file". Nobody is credited whom the file does not name.
/// @param made_by  the words before the institution
[[nodiscard]] std::string attribution_of(const netcdf::File& file, const Product& product,
                                         std::string_view made_by = "Data of");

}  // namespace slackwater::ingest
