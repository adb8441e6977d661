#include "ingest/cf/settle.h"

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/units.h"

namespace slackwater::ingest {
namespace {

bool are_same_unit(const std::string& a, const std::string& b) {
  if (lower_case(a) == lower_case(b)) return true;
  try {
    return unit_conversion(a, b, "unit").is_identity();
  } catch (const Error&) {
    return false;
  }
}

bool are_same_name(const std::string& a, const std::string& b, const Vocabulary& vocabulary) {
  const Quantity* quantity = vocabulary.by_standard_name(a);
  return a == b || (quantity != nullptr && quantity == vocabulary.by_standard_name(b));
}

[[noreturn]] void refuse_attribute(const netcdf::Variable& variable, const char* attribute,
                                   const std::string& own, const std::string& stated,
                                   const Product& product) {
  throw Error(ErrorKind::invalid_input,
              "variable '" + variable.name + "': the file says " + attribute + " '" + own +
                  "', the descriptor of product '" + product.id + "' says '" + stated +
                  "'; leave that out of the descriptor, or use the descriptor of this file's "
                  "product");
}

/// Fills one attribute in, or holds it against what the file says.
template <typename AreSame>
void settle_one(netcdf::File& file, const netcdf::Variable& variable, const char* attribute,
                const std::optional<std::string>& stated, const Product& product,
                const AreSame& are_same) {
  if (!stated) return;
  const std::string own = variable.text(attribute).value_or("");
  // Some writers say that they do not know.
  if (own.empty() || own == "unknown" || own == "none") {
    file.settle(variable, attribute, *stated);
  } else if (!are_same(own, *stated)) {
    refuse_attribute(variable, attribute, own, *stated, product);
  }
}

}  // namespace

const Product& product_for(const netcdf::File& file, const ProductCatalogue& products,
                           const IngestOptions& options) {
  const Product& by_file = products.product_of(file);
  if (!options.product) return by_file;
  const bool names_none = by_file.id == products.products().back().id;
  if (!names_none && by_file.id != options.product->id) {
    throw Error(ErrorKind::invalid_input, "the file says that it is of product '" + by_file.id +
                                              "', --product says '" + options.product->id +
                                              "'; ingest it without --product");
  }
  return *options.product;
}

void settle(netcdf::File& file, const Product& product, const Vocabulary& vocabulary) {
  const auto same_text = [](const std::string& a, const std::string& b) {
    return lower_case(a) == lower_case(b);
  };
  const auto same_name = [&](const std::string& a, const std::string& b) {
    return are_same_name(a, b, vocabulary);
  };
  for (const SettledAttributes& entry : product.settles) {
    const netcdf::Variable* variable = file.find(entry.variable);
    if (variable == nullptr) continue;
    settle_one(file, *variable, "units", entry.units, product, are_same_unit);
    settle_one(file, *variable, "standard_name", entry.standard_name, product, same_name);
    settle_one(file, *variable, "positive", entry.positive, product, same_text);
  }
  for (const auto& [name, standard_name] : product.variables) {
    const netcdf::Variable* variable = file.find(name);
    const std::string own = variable == nullptr ? "" : variable->text("standard_name").value_or("");
    // A name that is not ours may be anything, this too; one of ours is a statement.
    const bool is_ours = vocabulary.by_standard_name(own) != nullptr;
    if (is_ours && !same_name(own, standard_name))
      refuse_attribute(*variable, "standard_name", own, standard_name, product);
  }
}

}  // namespace slackwater::ingest
