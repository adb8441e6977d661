#include "ingest/netcdf/file.h"

#include <netcdf.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/netcdf/classic_header.h"
#include "ingest/netcdf/hdf5_heap.h"
#include "ingest/netcdf/header.h"
#include "ingest/netcdf/library.h"
#include "ingest/netcdf/refuse_file.h"

namespace slackwater::ingest::netcdf {
namespace {

constexpr int max_variables = 4096;
constexpr std::size_t max_read_all = std::size_t{64} << 20;
constexpr std::size_t max_text = std::size_t{1} << 16;
constexpr std::size_t max_texts_bytes = std::size_t{1} << 30;  // as strings in memory
constexpr std::size_t letters_at_once = std::size_t{1} << 20;

void expect_netcdf_magic(const std::filesystem::path& path) {
  std::error_code status;
  if (!std::filesystem::exists(path, status)) {
    throw Error(ErrorKind::not_found, "no such file: " + path.string());
  }
  if (!std::filesystem::is_regular_file(path, status))
    refuse_file(path, "is not a regular file; give a NetCDF file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw Error(ErrorKind::unavailable, "cannot read " + path.string() + "; check its permissions");
  std::string magic(8, '\0');
  stream.read(magic.data(), 8);
  const auto found = static_cast<std::size_t>(stream.gcount());
  if (found == 0) refuse_file(path, "is empty (0 bytes); expected a NetCDF file; fetch it again");
  const bool hdf5 = found == 8 && magic == std::string("\x89HDF\r\n\x1a\n", 8);
  const bool classic =
      found >= 4 && magic.starts_with("CDF") && (magic[3] == 1 || magic[3] == 2 || magic[3] == 5);
  if (!hdf5 && !classic) {
    std::string shown;
    for (std::size_t i = 0; i < std::min<std::size_t>(found, 8); ++i) {
      const auto byte = static_cast<unsigned char>(magic[i]);
      shown += byte >= 32 && byte < 127 ? magic[i] : '.';
    }
    refuse_file(
        path,
        "is not a NetCDF file (it starts with '" + shown +
            "'); expected netCDF classic, 64-bit offset or netCDF-4; convert it or leave it out");
  }
  if (classic) expect_classic_file_is_whole(path);
  if (hdf5) expect_sound_global_heaps(path);
}

/// The promises of read(): rank, bounds and buffer agree. A mismatch is a bug of the caller, never
/// of the file.
void expect_hyperslab(const Variable& variable, std::span<const std::size_t> start,
                      std::span<const std::size_t> count, std::size_t values) {
  expects(start.size() == variable.shape.size() && count.size() == start.size(),
          "read: one start and count per dimension");
  std::size_t product = 1;
  for (std::size_t d = 0; d < start.size(); ++d) {
    expects(start[d] <= variable.shape[d] && count[d] <= variable.shape[d] - start[d],
            "read: inside the shape");
    product *= count[d];
  }
  expects(product == values, "read: the buffer holds product(count) values");
}

/// What a header claims is not allocated before it is known to be plausible.
void expect_bounded_texts(const std::filesystem::path& path, const Variable& variable) {
  const std::size_t rows = variable.shape[0];
  const std::size_t letters = variable.shape[1];
  const std::string found = "variable '" + variable.name + "' holds " + std::to_string(rows) +
                            " texts of " + std::to_string(letters) + " letters";
  if (rows != 0 && max_texts_bytes / rows < sizeof(std::string) + letters)
    refuse_file(path, found + "; expected at most 1 GiB of them in memory");
  std::error_code none;
  const std::uintmax_t bytes = std::filesystem::file_size(path, none);
  if (!none && variable.chunks.empty() && variable.size() > bytes) {
    refuse_file(path, found + ", more than the " + std::to_string(bytes) +
                          " bytes of the file; it is damaged or truncated; fetch it again");
  }
}

}  // namespace

std::optional<std::string> Attribute::text() const {
  if (const auto* found = std::get_if<std::string>(&value)) return *found;
  return std::nullopt;
}

std::optional<double> Attribute::number() const {
  const auto* found = std::get_if<std::vector<double>>(&value);
  if (found == nullptr || found->empty()) return std::nullopt;
  return found->front();
}

const Attribute* Variable::find(std::string_view attribute) const noexcept {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const Attribute& a) { return a.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

std::optional<std::string> Variable::text(std::string_view attribute) const {
  const Attribute* found = find(attribute);
  return found == nullptr ? std::nullopt : found->text();
}

std::optional<double> Variable::number(std::string_view attribute) const {
  const Attribute* found = find(attribute);
  return found == nullptr ? std::nullopt : found->number();
}

std::size_t Variable::size() const noexcept {
  std::size_t product = 1;
  for (const std::size_t length : shape) {
    if (__builtin_mul_overflow(product, length, &product))
      return std::numeric_limits<std::size_t>::max();
  }
  return product;
}

File File::open(const std::filesystem::path& path) {
  const LibraryLock lock;
  expect_netcdf_magic(path);
  File file;
  file.path_ = path;
  // An absolute path starts with '/', so the library cannot take it for a URL.
  const std::string name = std::filesystem::absolute(path).string();
  const int status = nc_open(name.c_str(), NC_NOWRITE, &file.id_);
  if (status != NC_NOERR) {
    file.id_ = -1;
    refuse_file(path, std::string("cannot be opened as NetCDF (") + nc_strerror(status) +
                          "); it is damaged or truncated; fetch it again");
  }
  int variables = 0;
  int global_attributes = 0;
  check(nc_inq(file.id_, nullptr, &variables, &global_attributes, nullptr), path,
        "reading the header");
  if (variables > max_variables)
    refuse_file(path, "has " + std::to_string(variables) + " variables");
  file.dimensions_ = read_dimensions(file.id_, path);
  file.attributes_ = read_attributes(file.id_, NC_GLOBAL, global_attributes, path);
  for (int id = 0; id < variables; ++id)
    file.variables_.push_back(read_variable(file.id_, id, path));
  return file;
}

File::~File() {
  if (id_ < 0) return;
  const LibraryLock lock;
  nc_close(id_);
}

File::File(File&& other) noexcept { *this = std::move(other); }

File& File::operator=(File&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(id_, other.id_);
  std::swap(dimensions_, other.dimensions_);
  std::swap(variables_, other.variables_);
  std::swap(attributes_, other.attributes_);
  return *this;
}

const Variable* File::find(std::string_view name) const noexcept {
  const auto found = std::find_if(variables_.begin(), variables_.end(),
                                  [&](const Variable& v) { return v.name == name; });
  return found == variables_.end() ? nullptr : &*found;
}

std::optional<std::string> File::text(std::string_view global_attribute) const {
  for (const Attribute& attribute : attributes_) {
    if (attribute.name == global_attribute) return attribute.text();
  }
  return std::nullopt;
}

void File::settle(const Variable& variable, std::string_view attribute, std::string_view text) {
  const auto found =
      std::find_if(variables_.begin(), variables_.end(),
                   [&](const Variable& candidate) { return candidate.id == variable.id; });
  expects(found != variables_.end(), "a variable of this file");
  std::erase_if(found->attributes, [&](const Attribute& a) { return a.name == attribute; });
  found->attributes.push_back({std::string(attribute), Type::character, std::string(text)});
}

void File::read(const Variable& variable, std::span<const std::size_t> start,
                std::span<const std::size_t> count, std::span<double> out) const {
  expect_hyperslab(variable, start, count, out.size());
  if (out.empty()) return;
  const LibraryLock lock;
  const int status = nc_get_vara_double(id_, variable.id, start.data(), count.data(), out.data());
  check(status, path_, "reading variable '" + variable.name + "'");
}

void File::read(const Variable& variable, std::span<const std::size_t> start,
                std::span<const std::size_t> count, std::span<float> out) const {
  expect_hyperslab(variable, start, count, out.size());
  if (out.empty()) return;
  const LibraryLock lock;
  const int status = nc_get_vara_float(id_, variable.id, start.data(), count.data(), out.data());
  if (status == NC_ERANGE)
    return;  // a double beyond float, e.g. a fill value of 1e308, reads as infinity
  check(status, path_, "reading variable '" + variable.name + "'");
}

void File::read(const Variable& variable, std::span<const std::size_t> start,
                std::span<const std::size_t> count, std::span<std::int64_t> out) const {
  expect_hyperslab(variable, start, count, out.size());
  if (out.empty()) return;
  const LibraryLock lock;
  static_assert(sizeof(long long) == sizeof(std::int64_t));
  const int status = nc_get_vara_longlong(id_, variable.id, start.data(), count.data(),
                                          reinterpret_cast<long long*>(out.data()));
  check(status, path_, "reading variable '" + variable.name + "'");
}

std::vector<double> File::read_all(const Variable& variable) const {
  const std::size_t size = variable.size();
  if (size > max_read_all) {
    refuse_file(path_, "variable '" + variable.name + "' holds " + std::to_string(size) +
                           " values; expected at most " + std::to_string(max_read_all) +
                           " in one piece");
  }
  std::vector<double> values(size);
  const std::vector<std::size_t> start(variable.shape.size(), 0);
  read(variable, start, variable.shape, values);
  return values;
}

std::string File::read_text(const Variable& variable) const {
  const LibraryLock lock;
  const std::string doing = "reading text variable '" + variable.name + "'";
  if (variable.size() > max_text)
    refuse_file(path_, "variable '" + variable.name + "' is too long for a text");
  std::string text;
  if (variable.type == Type::character) {
    text.resize(variable.size());
    if (!text.empty()) check(nc_get_var_text(id_, variable.id, text.data()), path_, doing);
  } else if (variable.type == Type::string && variable.size() >= 1) {
    std::vector<char*> strings(variable.size(), nullptr);
    check(nc_get_var_string(id_, variable.id, strings.data()), path_, doing);
    if (strings.front() != nullptr) text = strings.front();
    nc_free_string(strings.size(), strings.data());
  } else if (variable.type != Type::string) {
    refuse_file(path_, "variable '" + variable.name + "' holds numbers; expected text");
  }
  const auto last = text.find_last_not_of(std::string_view(" \0\t", 3));
  text.resize(last == std::string::npos ? 0 : last + 1);
  return text;
}

std::vector<std::string> File::read_texts(const Variable& variable) const {
  expects(variable.type == Type::character && variable.shape.size() == 2,
          "read_texts: letters of rows");
  expect_bounded_texts(path_, variable);
  const std::size_t rows = variable.shape[0];
  const std::size_t width = variable.shape[1];
  std::vector<std::string> texts(rows);
  if (width == 0) return texts;
  const std::size_t rows_at_once = std::max<std::size_t>(1, letters_at_once / width);
  std::string letters;
  const LibraryLock lock;
  for (std::size_t first = 0; first < rows; first += rows_at_once) {
    const std::size_t start[] = {first, 0};
    const std::size_t count[] = {std::min(rows_at_once, rows - first), width};
    letters.resize(count[0] * width);
    check(nc_get_vara_text(id_, variable.id, start, count, letters.data()), path_,
          "reading text variable '" + variable.name + "'");
    for (std::size_t i = 0; i < count[0]; ++i) {
      const auto one = std::string_view(letters).substr(i * width, width);
      texts[first + i] = one.substr(0, one.find('\0'));
    }
  }
  return texts;
}

}  // namespace slackwater::ingest::netcdf
