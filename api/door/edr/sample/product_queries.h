#pragma once
#include <filesystem>

#include "api/door/edr/sample/product_collection.h"
#include "api/door/edr/sample/queries.h"

namespace slackwater::api::edr {

/// The answer of a stored product to position, radius, area or cube: at its own times, levels and,
/// of areas, cells. An instant is answered by the mean that holds it, or at the nearest of the
/// instants around it, which a note says; in a gap of its times not at all.
/// Reads files, and so always takes long.
/// @param store  the store's folder
/// @throws Error(usage) for what cannot be read or is too much; Error(not_found), with what the
/// product holds, for what it does not reach and for a place on land; Error(unavailable) where its
/// files cannot be read
[[nodiscard]] Answer product_answer(const std::filesystem::path& store,
                                    const StoredProduct& product, const QueryType& type,
                                    const QueryString& query);

/// The same at a place: a column of a forecast, by the name it has there.
[[nodiscard]] Answer product_answer_at(const std::filesystem::path& store,
                                       const StoredProduct& product, const GeoPoint& place,
                                       const QueryString& query);

}  // namespace slackwater::api::edr
