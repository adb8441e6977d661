#include "ingest/netcdf/header.h"

#include <netcdf.h>
#include <netcdf_filter.h>

#include <algorithm>
#include <string>

#include "fields/base/error.h"
#include "ingest/netcdf/library.h"
#include "ingest/netcdf/refuse_file.h"

namespace slackwater::ingest::netcdf {
namespace {

// A product file has tens of variables with tens of attributes. These bounds keep a hostile one
// from eating memory.
constexpr int max_dimensions = 4096;
constexpr int max_attributes = 1024;
constexpr std::size_t max_attribute_values = std::size_t{1} << 20;

Type type_of(nc_type type) noexcept {
  switch (type) {
    case NC_BYTE:
      return Type::int8;
    case NC_UBYTE:
      return Type::uint8;
    case NC_CHAR:
      return Type::character;
    case NC_SHORT:
      return Type::int16;
    case NC_USHORT:
      return Type::uint16;
    case NC_INT:
      return Type::int32;
    case NC_UINT:
      return Type::uint32;
    case NC_INT64:
      return Type::int64;
    case NC_UINT64:
      return Type::uint64;
    case NC_FLOAT:
      return Type::float32;
    case NC_DOUBLE:
      return Type::float64;
    case NC_STRING:
      return Type::string;
    default:
      return Type::other;
  }
}

/// What the library wrote into a buffer that was made for the longest name.
std::string before_null(const std::string& buffer) { return buffer.substr(0, buffer.find('\0')); }

Attribute read_attribute(int file, int variable, int number, const std::filesystem::path& path) {
  Attribute attribute;
  std::string name(NC_MAX_NAME + 1, '\0');
  check(nc_inq_attname(file, variable, number, name.data()), path, "reading an attribute name");
  attribute.name = before_null(name);
  nc_type type = NC_NAT;
  std::size_t length = 0;
  const std::string doing = "reading attribute '" + attribute.name + "'";
  check(nc_inq_att(file, variable, attribute.name.c_str(), &type, &length), path, doing);
  attribute.type = type_of(type);
  if (length > max_attribute_values) {
    refuse_file(path, "attribute '" + attribute.name + "' holds " + std::to_string(length) +
                          " values; expected at most " + std::to_string(max_attribute_values));
  }
  if (attribute.type == Type::character) {
    std::string text(length, '\0');
    if (length > 0)
      check(nc_get_att_text(file, variable, attribute.name.c_str(), text.data()), path, doing);
    while (!text.empty() && text.back() == '\0') text.pop_back();
    attribute.value = std::move(text);
  } else if (attribute.type == Type::string) {
    std::vector<char*> strings(length, nullptr);
    std::string text;
    if (length > 0) {
      check(nc_get_att_string(file, variable, attribute.name.c_str(), strings.data()), path, doing);
      for (const char* part : strings) {
        if (!text.empty()) text += ' ';
        if (part != nullptr) text += part;
      }
      nc_free_string(length, strings.data());
    }
    attribute.value = std::move(text);
  } else if (attribute.type == Type::other) {
    attribute.value = std::string();
  } else {
    std::vector<double> numbers(length);
    if (length > 0)
      check(nc_get_att_double(file, variable, attribute.name.c_str(), numbers.data()), path, doing);
    attribute.value = std::move(numbers);
  }
  return attribute;
}

/// A hyperslab that takes a few rows of each chunk must not fetch whole chunks that the cache drops
/// again: without filters, HDF5 reads just the rows once the cache is too small for a chunk. Small
/// chunks are better fetched whole.
void read_large_plain_chunks_in_place(int file, const Variable& variable) {
  constexpr std::size_t large_chunk = std::size_t{256} << 10;  // values, of 1 to 8 bytes
  int shuffle = 0;
  int deflate = 0;
  int level = 0;
  int checksum = NC_NOCHECKSUM;
  std::size_t filters = 0;
  if (nc_inq_var_deflate(file, variable.id, &shuffle, &deflate, &level) != NC_NOERR ||
      nc_inq_var_fletcher32(file, variable.id, &checksum) != NC_NOERR ||
      nc_inq_var_filter_ids(file, variable.id, &filters, nullptr) != NC_NOERR) {
    return;
  }
  std::size_t values = 1;
  for (const std::size_t n : variable.chunks) {
    if (__builtin_mul_overflow(values, n, &values)) return;
  }
  const bool plain = shuffle == 0 && deflate == 0 && checksum == NC_NOCHECKSUM && filters == 0;
  if (plain && values >= large_chunk) nc_set_var_chunk_cache(file, variable.id, 0, 1, 0.0F);
}

}  // namespace

std::vector<Attribute> read_attributes(int file, int variable, int count,
                                       const std::filesystem::path& path) {
  if (count > max_attributes)
    refuse_file(path, "has " + std::to_string(count) + " attributes on one variable");
  std::vector<Attribute> attributes;
  attributes.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) attributes.push_back(read_attribute(file, variable, i, path));
  return attributes;
}

std::vector<Dimension> read_dimensions(int file, const std::filesystem::path& path) {
  int count = 0;
  check(nc_inq_dimids(file, &count, nullptr, 0), path, "counting dimensions");
  if (count > max_dimensions) refuse_file(path, "has " + std::to_string(count) + " dimensions");
  std::vector<int> ids(static_cast<std::size_t>(count));
  check(nc_inq_dimids(file, nullptr, ids.data(), 0), path, "listing dimensions");
  int unlimited_count = 0;
  check(nc_inq_unlimdims(file, &unlimited_count, nullptr), path, "counting unlimited dimensions");
  std::vector<int> unlimited(static_cast<std::size_t>(unlimited_count));
  check(nc_inq_unlimdims(file, nullptr, unlimited.data()), path, "listing unlimited dimensions");
  std::vector<Dimension> dimensions;
  for (const int id : ids) {
    Dimension dimension;
    dimension.id = id;
    std::string name(NC_MAX_NAME + 1, '\0');
    check(nc_inq_dim(file, id, name.data(), &dimension.length), path, "reading a dimension");
    dimension.name = before_null(name);
    dimension.unlimited = std::find(unlimited.begin(), unlimited.end(), id) != unlimited.end();
    dimensions.push_back(std::move(dimension));
  }
  return dimensions;
}

Variable read_variable(int file, int id, const std::filesystem::path& path) {
  Variable variable;
  variable.id = id;
  std::string name(NC_MAX_NAME + 1, '\0');
  nc_type type = NC_NAT;
  int rank = 0;
  int attribute_count = 0;
  check(nc_inq_var(file, id, name.data(), &type, &rank, nullptr, &attribute_count), path,
        "reading a variable");
  variable.name = before_null(name);
  variable.type = type_of(type);
  variable.dimension_ids.resize(static_cast<std::size_t>(rank));
  const std::string doing = "reading variable '" + variable.name + "'";
  if (rank > 0) check(nc_inq_vardimid(file, id, variable.dimension_ids.data()), path, doing);
  for (const int dimension : variable.dimension_ids) {
    std::size_t length = 0;
    check(nc_inq_dim(file, dimension, name.data(), &length), path, doing);
    variable.dimensions.emplace_back(name.c_str());
    variable.shape.push_back(length);
  }
  int storage = NC_CONTIGUOUS;
  std::vector<std::size_t> chunks(variable.shape.size());
  if (rank > 0 && nc_inq_var_chunking(file, id, &storage, chunks.data()) == NC_NOERR &&
      storage == NC_CHUNKED) {
    variable.chunks = std::move(chunks);
  }
  int shuffle = 0;
  int deflate = 0;
  int level = 0;
  if (nc_inq_var_deflate(file, id, &shuffle, &deflate, &level) == NC_NOERR)
    variable.compressed = deflate != 0;
  if (!variable.chunks.empty()) read_large_plain_chunks_in_place(file, variable);
  variable.attributes = read_attributes(file, id, attribute_count, path);
  return variable;
}

}  // namespace slackwater::ingest::netcdf
