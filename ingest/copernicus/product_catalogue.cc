#include "ingest/copernicus/product_catalogue.h"

#include <algorithm>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

/// Some writers say that they do not know; that is not a name.
bool is_a_name(const std::optional<std::string>& standard_name) {
  return standard_name && !standard_name->empty() && *standard_name != "unknown" &&
         *standard_name != "none";
}

std::vector<std::filesystem::path> descriptor_files(const std::filesystem::path& folder) {
  std::error_code status;
  std::filesystem::directory_iterator entries(folder, status);
  if (status) {
    throw Error(ErrorKind::not_found, "no product descriptors in " + folder.string() + " (" +
                                          status.message() +
                                          "); expected the folder data/products of Slackwater");
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : entries) {
    if (entry.path().extension() == ".yaml" && entry.path().filename() != "variables.yaml") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Product ProductCatalogue::describe(const std::filesystem::path& file) const {
  Product product = Product::load(file);
  for (const auto& [name, standard_name] : product.variables) {
    if (vocabulary_.by_standard_name(standard_name) == nullptr) {
      throw Error(ErrorKind::invalid_input, file.string() + ": variables: " + name + ": '" +
                                                standard_name + "' is not in variables.yaml");
    }
  }
  return product;
}

ProductCatalogue ProductCatalogue::load(const std::filesystem::path& products_folder,
                                        std::span<const std::filesystem::path> more) {
  ProductCatalogue catalogue;
  std::vector<std::filesystem::path> files = descriptor_files(products_folder);
  catalogue.vocabulary_ = Vocabulary::load(products_folder / "variables.yaml");
  const std::size_t shipped = files.size();
  for (const auto& folder : more) {
    if (std::filesystem::exists(folder / "variables.yaml")) {
      throw Error(ErrorKind::invalid_input,
                  (folder / "variables.yaml").string() + ": the list of quantities is that of " +
                      products_folder.string() +
                      "; put descriptors of products here, and name short names under `variables`");
    }
    const auto further = descriptor_files(folder);
    files.insert(files.end(), further.begin(), further.end());
  }
  for (const auto& file : files) {
    Product product = catalogue.describe(file);
    if (catalogue.find(product.id) != nullptr) {
      throw Error(ErrorKind::invalid_input, file.string() + ": product '" + product.id +
                                                "' is described twice; keep one descriptor");
    }
    catalogue.products_.push_back(std::move(product));
  }
  std::rotate(catalogue.products_.begin(),
              catalogue.products_.begin() + static_cast<std::ptrdiff_t>(shipped),
              catalogue.products_.end());
  std::stable_sort(
      catalogue.products_.begin(), catalogue.products_.end(),
      [](const Product& a, const Product& b) { return a.match_order < b.match_order; });
  const auto generic = std::find_if(catalogue.products_.begin(), catalogue.products_.end(),
                                    [](const Product& product) { return product.id == "cf"; });
  if (generic == catalogue.products_.end()) {
    throw Error(ErrorKind::invalid_input, products_folder.string() +
                                              ": no descriptor with id 'cf' for files that "
                                              "match no other; restore cf.yaml");
  }
  std::rotate(generic, generic + 1, catalogue.products_.end());
  return catalogue;
}

const Product& ProductCatalogue::product_of(const netcdf::File& file) const {
  for (const Product& product : products_) {
    if (product.matches(file)) return product;
  }
  return products_.back();
}

const Product* ProductCatalogue::find(std::string_view id) const noexcept {
  const auto found = std::find_if(products_.begin(), products_.end(),
                                  [&](const Product& product) { return product.id == id; });
  return found == products_.end() ? nullptr : &*found;
}

const Quantity* ProductCatalogue::quantity_of(const netcdf::Variable& variable,
                                              const Product& product) const {
  if (const auto own = product.variables.find(variable.name); own != product.variables.end()) {
    return vocabulary_.by_standard_name(own->second);
  }
  const auto standard_name = product.attribute(variable, "standard_name");
  if (is_a_name(standard_name)) return vocabulary_.by_standard_name(*standard_name);
  return vocabulary_.by_alias(variable.name);
}

std::vector<Download> ProductCatalogue::downloads() const {
  std::vector<Download> all;
  for (const Product& product : products_) {
    all.insert(all.end(), product.downloads.begin(), product.downloads.end());
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Download& a, const Download& b) { return a.priority < b.priority; });
  return all;
}

}  // namespace slackwater::ingest
