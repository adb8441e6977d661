#include <fcntl.h>
#include <netcdf.h>
#include <unistd.h>

#include <cstring>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/netcdf/file.h"
#include "ingest/netcdf/library.h"

namespace slackwater::ingest::netcdf {
namespace {

nc_type external_type(Type type) {
  switch (type) {
    case Type::int8:
      return NC_BYTE;
    case Type::uint8:
      return NC_UBYTE;
    case Type::character:
      return NC_CHAR;
    case Type::int16:
      return NC_SHORT;
    case Type::uint16:
      return NC_USHORT;
    case Type::int32:
      return NC_INT;
    case Type::uint32:
      return NC_UINT;
    case Type::int64:
      return NC_INT64;
    case Type::uint64:
      return NC_UINT64;
    case Type::float32:
      return NC_FLOAT;
    case Type::float64:
      return NC_DOUBLE;
    case Type::string:
      return NC_STRING;
    case Type::other:
      break;
  }
  expects(false, "Writer: a type that can be written");
  return NC_NAT;
}

/// The fill value as bytes of the variable's type.
template <typename T>
int define_fill(int file, int variable, double value) {
  const T typed = static_cast<T>(value);
  return nc_def_var_fill(file, variable, NC_FILL, &typed);
}

int define_fill(int file, int variable, Type type, double value) {
  switch (type) {
    case Type::int8:
      return define_fill<signed char>(file, variable, value);
    case Type::uint8:
      return define_fill<unsigned char>(file, variable, value);
    case Type::int16:
      return define_fill<short>(file, variable, value);
    case Type::uint16:
      return define_fill<unsigned short>(file, variable, value);
    case Type::int32:
      return define_fill<int>(file, variable, value);
    case Type::uint32:
      return define_fill<unsigned int>(file, variable, value);
    case Type::int64:
      return define_fill<long long>(file, variable, value);
    case Type::uint64:
      return define_fill<unsigned long long>(file, variable, value);
    case Type::float32:
      return define_fill<float>(file, variable, value);
    case Type::float64:
      return define_fill<double>(file, variable, value);
    default:
      expects(false, "Writer: a fill value needs a numeric type");
      return NC_EBADTYPE;
  }
}

/// With less room than this, a write that failed is told as a full disk: the library does not say
/// why it failed.
constexpr std::uintmax_t full_disk_bytes = std::uintmax_t{1} << 20;
/// Room that the library's caches may still want when a file is given up.
constexpr std::uintmax_t room_to_abort_bytes = std::uintmax_t{64} << 20;

std::uintmax_t room_at(const std::filesystem::path& file) {
  std::error_code problem;
  const auto disk = std::filesystem::space(std::filesystem::absolute(file).parent_path(), problem);
  return problem ? std::numeric_limits<std::uintmax_t>::max() : disk.available;
}

std::size_t length_of(int file, int dimension) {
  std::size_t length = 0;
  nc_inq_dimlen(file, dimension, &length);
  return length;
}

std::vector<std::size_t> shape_of(int file, int variable) {
  int rank = 0;
  nc_inq_varndims(file, variable, &rank);
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  if (rank > 0) nc_inq_vardimid(file, variable, dimensions.data());
  std::vector<std::size_t> shape;
  shape.reserve(dimensions.size());
  for (const int dimension : dimensions) shape.push_back(length_of(file, dimension));
  return shape;
}

std::size_t product_of(std::span<const std::size_t> counts) {
  std::size_t product = 1;
  for (const std::size_t count : counts) product *= count;
  return product;
}

}  // namespace

Writer Writer::create(const std::filesystem::path& path) {
  const LibraryLock lock;
  Writer writer;
  writer.path_ = path;
  const std::string name = std::filesystem::absolute(path).string();
  const int status = nc_create(name.c_str(), NC_NETCDF4 | NC_CLOBBER, &writer.id_);
  if (status != NC_NOERR) writer.id_ = -1;
  writer.checked(status, "creating the file");
  return writer;
}

Writer::~Writer() {
  if (id_ < 0) return;
  const LibraryLock lock;
  // To give a file up the library writes it to its end, and crashes where it cannot (HDF5 1.10,
  // NetCDF 4.9): then the file stays open in the library until the process ends.
  if (!failed_ && room_at(path_) >= room_to_abort_bytes) nc_abort(id_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

Writer::Writer(Writer&& other) noexcept
    : path_(std::move(other.path_)), id_(std::exchange(other.id_, -1)), failed_(other.failed_) {}

void Writer::checked(int status, std::string_view doing) {
  if (status == NC_NOERR) return;
  failed_ = true;
  if (room_at(path_) < full_disk_bytes) {
    throw Error(ErrorKind::unavailable,
                path_.string() + ": " + std::string(doing) +
                    ": no space left on the disk; free some space and run the command again");
  }
  check(status, path_, doing, ErrorKind::unavailable);
}

int Writer::dimension(const std::string& name, std::size_t length) {
  expects(length > 0, "Writer: a dimension has a length (0 would mean unlimited)");
  const LibraryLock lock;
  int id = -1;
  checked(nc_def_dim(id_, name.c_str(), length, &id), "defining dimension '" + name + "'");
  return id;
}

int Writer::unlimited_dimension(const std::string& name) {
  const LibraryLock lock;
  int id = -1;
  checked(nc_def_dim(id_, name.c_str(), NC_UNLIMITED, &id), "defining dimension '" + name + "'");
  return id;
}

int Writer::variable(const std::string& name, Type type, const std::vector<int>& dimension_ids,
                     const Layout& layout) {
  const LibraryLock lock;
  const std::string doing = "defining variable '" + name + "'";
  int id = -1;
  checked(nc_def_var(id_, name.c_str(), external_type(type), static_cast<int>(dimension_ids.size()),
                     dimension_ids.data(), &id),
          doing);
  if (!layout.chunks.empty()) {
    expects(layout.chunks.size() == dimension_ids.size(), "Writer: one chunk length per dimension");
    checked(nc_def_var_chunking(id_, id, NC_CHUNKED, layout.chunks.data()), doing);
  }
  if (layout.deflate > 0) checked(nc_def_var_deflate(id_, id, 1, 1, layout.deflate), doing);
  if (!layout.is_prefilled) {
    checked(nc_def_var_fill(id_, id, NC_NOFILL, nullptr), doing);
    if (layout.fill_value) {
      attribute(id, "_FillValue", std::span<const double>(&*layout.fill_value, 1), type);
    }
  } else if (layout.fill_value) {
    checked(define_fill(id_, id, type, *layout.fill_value), doing);
  }
  return id;
}

void Writer::attribute(int variable, const std::string& name, const std::string& text) {
  const LibraryLock lock;
  checked(nc_put_att_text(id_, variable, name.c_str(), text.size(), text.c_str()),
          "writing attribute '" + name + "'");
}

void Writer::attribute(int variable, const std::string& name, double value) {
  attribute(variable, name, std::span<const double>(&value, 1), Type::float64);
}

void Writer::attribute(int variable, const std::string& name, std::span<const double> values,
                       Type type) {
  const LibraryLock lock;
  checked(nc_put_att_double(id_, variable, name.c_str(), external_type(type), values.size(),
                            values.data()),
          "writing attribute '" + name + "'");
}

void Writer::end_definitions() {
  const LibraryLock lock;
  checked(nc_enddef(id_), "ending the definitions");
}

void Writer::write(int variable, std::span<const std::size_t> start,
                   std::span<const std::size_t> count, std::span<const double> values) {
  expects(start.size() == count.size() && product_of(count) == values.size(),
          "Writer: a whole hyperslab");
  const LibraryLock lock;
  checked(nc_put_vara_double(id_, variable, start.data(), count.data(), values.data()),
          "writing values");
}

void Writer::write(int variable, std::span<const std::size_t> start,
                   std::span<const std::size_t> count, std::span<const float> values) {
  expects(start.size() == count.size() && product_of(count) == values.size(),
          "Writer: a whole hyperslab");
  const LibraryLock lock;
  checked(nc_put_vara_float(id_, variable, start.data(), count.data(), values.data()),
          "writing values");
}

void Writer::write(int variable, std::span<const std::size_t> start,
                   std::span<const std::size_t> count, std::span<const std::int64_t> values) {
  expects(start.size() == count.size() && product_of(count) == values.size(),
          "Writer: a whole hyperslab");
  static_assert(sizeof(long long) == sizeof(std::int64_t));
  const LibraryLock lock;
  checked(nc_put_vara_longlong(id_, variable, start.data(), count.data(),
                               reinterpret_cast<const long long*>(values.data())),
          "writing values");
}

void Writer::write(int variable, std::span<const std::size_t> start,
                   std::span<const std::size_t> count, std::span<const std::int8_t> values) {
  expects(start.size() == count.size() && product_of(count) == values.size(),
          "Writer: a whole hyperslab");
  const LibraryLock lock;
  checked(nc_put_vara_schar(id_, variable, start.data(), count.data(), values.data()),
          "writing values");
}

void Writer::write_all(int variable, std::span<const double> values) {
  const LibraryLock lock;
  const std::vector<std::size_t> shape = shape_of(id_, variable);
  const std::vector<std::size_t> start(shape.size(), 0);
  write(variable, start, shape, values);
}

void Writer::write_text(int variable, std::string_view text) {
  const LibraryLock lock;
  const std::vector<std::size_t> shape = shape_of(id_, variable);
  const std::size_t room = product_of(shape);
  expects(!shape.empty() && text.size() <= room, "Writer: the text fits its char dimensions");
  std::string padded_text(text);
  padded_text.resize(room, '\0');
  checked(nc_put_var_text(id_, variable, padded_text.data()), "writing text");
}

void Writer::close(Durable durable) {
  expects(id_ >= 0, "Writer: closed once");
  const LibraryLock lock;
  const int status = nc_close(std::exchange(id_, -1));
  try {
    checked(status, "closing the file");
    if (durable == Durable::no) return;
    const int descriptor = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int cause = errno;
    if (descriptor >= 0) ::close(descriptor);
    if (!synced) {
      throw Error(ErrorKind::unavailable, "cannot flush " + path_.string() + " to disk (" +
                                              std::strerror(cause) +
                                              "); check free space and permissions");
    }
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    throw;
  }
}

}  // namespace slackwater::ingest::netcdf
