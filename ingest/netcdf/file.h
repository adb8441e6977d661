#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slackwater::ingest::netcdf {

/// Storage type of a variable, the NetCDF external types we meet.
enum class Type {
  int8,
  uint8,
  character,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  string,
  other
};

struct Dimension {
  int id = 0;
  std::string name;
  std::size_t length = 0;
  bool unlimited = false;
};

/// An attribute: text, or numbers widened to double.
struct Attribute {
  std::string name;
  Type type = Type::character;
  std::variant<std::string, std::vector<double>> value;
  [[nodiscard]] std::optional<std::string> text() const;
  [[nodiscard]] std::optional<double> number() const;  ///< the first one
};

struct Variable {
  int id = 0;
  std::string name;
  Type type = Type::other;
  std::vector<int> dimension_ids;  ///< slowest first
  std::vector<std::string> dimensions;
  std::vector<std::size_t> shape;
  std::vector<std::size_t> chunks;  ///< empty: contiguous
  bool compressed = false;          ///< deflated chunks
  std::vector<Attribute> attributes;

  [[nodiscard]] const Attribute* find(std::string_view attribute) const noexcept;
  [[nodiscard]] std::optional<std::string> text(std::string_view attribute) const;
  [[nodiscard]] std::optional<double> number(std::string_view attribute) const;
  [[nodiscard]] std::size_t size() const noexcept;  ///< product of shape, saturated
  /// Not text, and no type of the file's own making.
  [[nodiscard]] bool has_numbers() const noexcept {
    return type != Type::character && type != Type::string && type != Type::other;
  }
};

/// A NetCDF file (classic, 64-bit offset, netCDF-4) open for reading. Every failure is an Error
/// that carries path, variable and the library's own text. NetCDF/HDF5 is not thread-safe: all
/// calls take one process-wide lock.
class File {
 public:
  /// Throws Error(not_found) if absent, Error(invalid_input) if it is not NetCDF, is empty or is
  /// truncated.
  [[nodiscard]] static File open(const std::filesystem::path& path);
  ~File();
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] const std::vector<Dimension>& dimensions() const noexcept { return dimensions_; }
  [[nodiscard]] const std::vector<Variable>& variables() const noexcept { return variables_; }
  [[nodiscard]] const std::vector<Attribute>& attributes() const noexcept { return attributes_; }
  [[nodiscard]] const Variable* find(std::string_view name) const noexcept;
  [[nodiscard]] std::optional<std::string> text(std::string_view global_attribute) const;

  /// States a text attribute that the file forgets, as if the file said it; nothing is written.
  /// @param variable  of this file
  void settle(const Variable& variable, std::string_view attribute, std::string_view text);

  /// Reads a hyperslab, raw (unscaled), converted by the library to the buffer's type.
  /// `start` and `count` have one entry per dimension; the buffer holds product(count) values.
  void read(const Variable& variable, std::span<const std::size_t> start,
            std::span<const std::size_t> count, std::span<double> out) const;
  void read(const Variable& variable, std::span<const std::size_t> start,
            std::span<const std::size_t> count, std::span<float> out) const;
  void read(const Variable& variable, std::span<const std::size_t> start,
            std::span<const std::size_t> count, std::span<std::int64_t> out) const;
  /// A whole numeric variable as double. Refuses more than 64 Mi values.
  [[nodiscard]] std::vector<double> read_all(const Variable& variable) const;
  /// A char array or string scalar as text (trailing blanks and NULs cut). Refuses more than
  /// 64 KiB.
  [[nodiscard]] std::string read_text(const Variable& variable) const;
  /// The rows of a char array of two dimensions, each up to its first NUL. Millions of them;
  /// refuses more than 1 GiB in memory, and more letters than the file can hold.
  [[nodiscard]] std::vector<std::string> read_texts(const Variable& variable) const;

 private:
  File() = default;
  std::filesystem::path path_;
  int id_ = -1;
  std::vector<Dimension> dimensions_;
  std::vector<Variable> variables_;
  std::vector<Attribute> attributes_;
};

/// A netCDF-4 file being written. `close()` flushes and fsyncs; without it the destructor discards
/// quietly.
class Writer {
 public:
  [[nodiscard]] static Writer create(const std::filesystem::path& path);
  ~Writer();
  Writer(Writer&& other) noexcept;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  int dimension(const std::string& name, std::size_t length);
  int unlimited_dimension(const std::string& name);
  struct Layout {
    std::vector<std::size_t> chunks;   ///< empty: contiguous
    int deflate = 0;                   ///< 0..9
    std::optional<double> fill_value;  ///< _FillValue, in the variable's type
    bool is_prefilled = true;          ///< false: all of it will be written, so nothing is before
  };
  int variable(const std::string& name, Type type, const std::vector<int>& dimension_ids,
               const Layout& layout);
  int variable(const std::string& name, Type type, const std::vector<int>& dimension_ids) {
    return variable(name, type, dimension_ids, Layout{});
  }
  static constexpr int global = -1;  ///< the NC_GLOBAL pseudo variable
  void attribute(int variable, const std::string& name, const std::string& text);
  void attribute(int variable, const std::string& name, double value);
  void attribute(int variable, const std::string& name, std::span<const double> values, Type type);
  void end_definitions();
  void write(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const double> values);
  void write(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const float> values);
  void write(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const std::int64_t> values);
  void write(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             std::span<const std::int8_t> values);
  void write_all(int variable, std::span<const double> values);
  /// A whole char variable, row after row; NULs fill what the text leaves.
  void write_text(int variable, std::string_view text);
  void close() { close(Durable::yes); }
  /// Without waiting for the disk: for files that can be made again.
  enum class Durable { yes, no };
  void close(Durable durable);

 private:
  Writer() = default;
  /// Throws Error(unavailable) unless `status` is 0.
  void checked(int status, std::string_view doing);
  std::filesystem::path path_;
  int id_ = -1;
  bool failed_ = false;  ///< a write failed: the library must not touch the file again
};

}  // namespace slackwater::ingest::netcdf
