#include "data/store/granule_table.h"

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/geo/coverage.h"

namespace slackwater::store {
namespace {

std::string_view vertical_name(VerticalKind kind) {
  switch (kind) {
    case VerticalKind::none:
      return "none";
    case VerticalKind::depth_m:
      return "depth_m";
    case VerticalKind::height_m:
      return "height_m";
  }
  return "none";
}

VerticalKind vertical_from(const std::string& name) {
  if (name == "depth_m") return VerticalKind::depth_m;
  if (name == "height_m") return VerticalKind::height_m;
  return VerticalKind::none;
}

DataStatus status_from(const std::string& name) {
  if (const auto status = data_status_from(name)) return *status;
  throw Error(ErrorKind::invalid_input, "no status of a granule");
}

constexpr std::string_view granule_columns =
    "SELECT g.id, s.sha256, s.cut_key, g.content_sha256, g.contains_stokes, g.is_point_series, "
    "g.station, "
    "g.status, g.reference_time_ms, g.ensemble_member, g.first_time_ms, g.last_time_ms, g.times, "
    "g.west_deg, "
    "g.south_deg, g.east_deg, g.north_deg, g.vertical, g.lowest_level_m, g.highest_level_m, "
    "g.product_id, "
    "g.dataset_id, g.attribution, s.ingested_at_ms, s.published_at_ms FROM granule g "
    "JOIN source s ON s.id = g.source_id ";

GranuleRow granule_from(const Statement& row) {
  GranuleRow granule;
  int column = 0;
  granule.id = row.integer(column++);
  granule.source_sha256 = row.checksum(column++);
  granule.cut_key = row.text(column++);
  granule.content_sha256 = row.checksum(column++);
  granule.contains_stokes = row.integer(column++) != 0;
  granule.is_point_series = row.integer(column++) != 0;
  granule.station = row.name(column++);
  granule.status = row.parsed(column++, status_from);
  granule.reference_time = row.optional_time(column++);
  if (const auto member = row.optional_integer(column++)) {
    granule.ensemble_member = static_cast<int>(*member);
  }
  granule.first_time = row.optional_time(column++);
  granule.last_time = row.optional_time(column++);
  granule.times = static_cast<std::size_t>(row.integer(column++));
  granule.bounds.west_deg = row.real(column++);
  granule.bounds.south_deg = row.real(column++);
  granule.bounds.east_deg = row.real(column++);
  granule.bounds.north_deg = row.real(column++);
  granule.vertical = vertical_from(row.text(column++));
  granule.lowest_level_m = row.optional_real(column++);
  granule.highest_level_m = row.optional_real(column++);
  granule.product_id = row.name(column++);
  granule.dataset_id = row.name(column++);
  granule.attribution = row.text(column++);
  granule.ingested_at = row.time(column++);
  granule.published_at = row.optional_time(column++);
  return granule;
}

class VariableNames {
 public:
  explicit VariableNames(Database& database)
      : query_(database.prepare(
            "SELECT standard_name FROM granule_variable WHERE granule_id = ? ORDER BY position")) {}
  std::vector<std::string> of(std::int64_t granule) {
    std::vector<std::string> names;
    query_.bind(1, granule);
    while (query_.step()) names.push_back(query_.text(0));
    query_.reset();
    return names;
  }

 private:
  Statement query_;
};

void insert_granule(Database& database, std::int64_t source, const GranuleRow& row,
                    const SealedFile& content) {
  expects(row.first_time.has_value() == row.last_time.has_value(),
          "a granule has both ends of its time or, static, neither");
  for (const std::string& name : {row.station, row.product_id, row.dataset_id})
    expects(name.size() <= longest_name_bytes, "who ingests has looked at the names");
  Statement insert = database.prepare(
      "INSERT INTO granule (source_id, content_sha256, content_bytes, contains_stokes, "
      "is_point_series, station, "
      "status, reference_time_ms, ensemble_member, first_time_ms, last_time_ms, times, west_deg, "
      "south_deg, "
      "east_deg, north_deg, vertical, lowest_level_m, highest_level_m, product_id, dataset_id, "
      "attribution) "
      "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  std::optional<std::int64_t> member;
  if (row.ensemble_member) member = *row.ensemble_member;
  insert.bind_all(source, content.sha256, static_cast<std::int64_t>(content.bytes),
                  std::int64_t{row.contains_stokes}, std::int64_t{row.is_point_series}, row.station,
                  name_of(row.status), row.reference_time, member, row.first_time, row.last_time,
                  static_cast<std::int64_t>(row.times), row.bounds.west_deg, row.bounds.south_deg,
                  row.bounds.east_deg, row.bounds.north_deg, vertical_name(row.vertical),
                  row.lowest_level_m, row.highest_level_m, row.product_id, row.dataset_id,
                  row.attribution);
  insert.run();
  const std::int64_t granule = database.last_inserted_id();
  Statement variable = database.prepare(
      "INSERT INTO granule_variable (granule_id, position, standard_name) VALUES (?,?,?)");
  for (std::size_t i = 0; i < row.standard_names.size(); ++i) {
    variable.bind_all(granule, static_cast<std::int64_t>(i), row.standard_names[i]).run();
  }
}

}  // namespace

std::optional<std::int64_t> source_id(Database& database, const std::string& sha256,
                                      const std::string& cut_key) {
  Statement query = database.prepare("SELECT id FROM source WHERE sha256 = ? AND cut_key = ?");
  query.bind_all(sha256, cut_key);
  if (!query.step()) return std::nullopt;
  return query.integer(0);
}

SourceFile read_source(Database& database, std::int64_t id) {
  Statement query = database.prepare(
      "SELECT sha256, cut_key, name, bytes, product_id, dataset_id, attribution, ingested_at_ms, "
      "published_at_ms FROM source WHERE id = ?");
  query.bind(1, id);
  expects(query.step(), "a source is read by an id just found");
  SourceFile source;
  source.sha256 = query.checksum(0);
  source.cut_key = query.text(1);
  source.name = query.text(2);
  source.bytes = static_cast<std::uint64_t>(query.integer(3));
  source.product_id = query.name(4);
  source.dataset_id = query.name(5);
  source.attribution = query.text(6);
  source.ingested_at = query.time(7);
  source.published_at = query.optional_time(8);
  Statement warnings =
      database.prepare("SELECT text FROM source_warning WHERE source_id = ? ORDER BY position");
  warnings.bind(1, id);
  while (warnings.step()) source.warnings.push_back(warnings.text(0));
  return source;
}

std::vector<SourceFile> read_sources(Database& database) {
  std::vector<SourceFile> sources;
  Statement query = database.prepare("SELECT id FROM source ORDER BY ingested_at_ms, id");
  while (query.step()) sources.push_back(read_source(database, query.integer(0)));
  return sources;
}

std::vector<NamedContent> contents_of_source(Database& database, std::int64_t source) {
  std::vector<NamedContent> contents;
  Statement query = database.prepare(
      "SELECT content_sha256, content_bytes FROM granule WHERE source_id = ? ORDER BY id");
  query.bind(1, source);
  while (query.step()) {
    contents.push_back({query.checksum(0), static_cast<std::uint64_t>(query.integer(1))});
  }
  return contents;
}

bool is_input_of_a_forecast(Database& database, std::int64_t source) {
  Statement query = database.prepare(
      "SELECT 1 FROM forecast_input i JOIN granule g ON g.id = i.granule_id WHERE g.source_id = ? "
      "LIMIT 1");
  query.bind(1, source);
  return query.step();
}

void insert_source(Database& database, const SourceFile& source,
                   std::span<const NewGranule> granules, std::span<const SealedFile> sealed) {
  expects(granules.size() == sealed.size(), "one content file per granule");
  Statement insert = database.prepare(
      "INSERT INTO source (sha256, cut_key, name, bytes, product_id, dataset_id, attribution, "
      "ingested_at_ms, published_at_ms) "
      "VALUES (?,?,?,?,?,?,?,?,?)");
  insert.bind_all(source.sha256, source.cut_key, source.name,
                  static_cast<std::int64_t>(source.bytes), source.product_id, source.dataset_id,
                  source.attribution, source.ingested_at, source.published_at);
  insert.run();
  const std::int64_t id = database.last_inserted_id();
  Statement warning =
      database.prepare("INSERT INTO source_warning (source_id, position, text) VALUES (?,?,?)");
  for (std::size_t i = 0; i < source.warnings.size(); ++i) {
    warning.bind_all(id, static_cast<std::int64_t>(i), source.warnings[i]).run();
  }
  for (std::size_t i = 0; i < granules.size(); ++i) {
    insert_granule(database, id, granules[i].row, sealed[i]);
  }
}

void delete_source(Database& database, std::int64_t id) {
  database.prepare("DELETE FROM source WHERE id = ?").bind(1, id).run();
}

std::vector<GranuleRow> select_granules(Database& database, const GranuleQuery& query) {
  std::string sql(granule_columns);
  sql += "WHERE 1";
  if (query.from) sql += " AND (g.last_time_ms IS NULL OR g.last_time_ms >= ?)";
  if (query.to) sql += " AND (g.first_time_ms IS NULL OR g.first_time_ms <= ?)";
  if (query.ingested_by) sql += " AND s.ingested_at_ms <= ?";
  if (query.status) sql += " AND g.status = ?";
  if (!query.any_of.empty()) {
    sql += " AND g.id IN (SELECT granule_id FROM granule_variable WHERE standard_name IN (?";
    for (std::size_t i = 1; i < query.any_of.size(); ++i) sql += ",?";
    sql += "))";
  }
  // NULLs come first: static fields, then by time.
  sql += " ORDER BY g.first_time_ms, g.status, g.reference_time_ms, g.ensemble_member, g.id";
  Statement select = database.prepare(sql);
  int position = 0;
  if (query.from) select.bind(++position, *query.from);
  if (query.to) select.bind(++position, *query.to);
  if (query.ingested_by) select.bind(++position, *query.ingested_by);
  if (query.status) select.bind(++position, name_of(*query.status));
  for (const std::string& name : query.any_of) select.bind(++position, name);

  std::optional<BoundingBox> box;
  if (query.box) box = widened(*query.box, query.margin_km);
  std::optional<BoundingBox> around_point;
  if (query.point) around_point = widened(box_of(*query.point), query.margin_km);
  VariableNames names(database);
  std::vector<GranuleRow> granules;
  while (select.step()) {
    GranuleRow granule = granule_from(select);
    if (box && !overlaps(granule.bounds, *box)) continue;
    if (around_point && !overlaps(granule.bounds, *around_point)) continue;
    granule.standard_names = names.of(granule.id);
    granules.push_back(std::move(granule));
  }
  return granules;
}

std::optional<GranuleRow> select_granule(Database& database, std::int64_t id) {
  Statement select = database.prepare(std::string(granule_columns) + "WHERE g.id = ?");
  select.bind(1, id);
  if (!select.step()) return std::nullopt;
  GranuleRow granule = granule_from(select);
  granule.standard_names = VariableNames(database).of(id);
  return granule;
}

}  // namespace slackwater::store
