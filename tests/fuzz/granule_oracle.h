#pragma once
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/ingest.h"

namespace slackwater::fuzz {

/// The descriptors of data/products, loaded once.
const ingest::ProductCatalogue& products();

/// Claims what every decoded file promises, whatever bytes it came from: at least one granule;
/// canonical axes inside the globe and inside the years that time decoding admits; a content file
/// that reads back to the same granule; each value finite or NaN, and present only where its status
/// says so; the vocabulary's name and unit for each quantity where `names_are_ours`.
void claim_sound(const ingest::Ingested& ingested, bool names_are_ours);

}  // namespace slackwater::fuzz
