-- What was ingested: one row per product file (and cut), one row per granule decoded from it.
-- Times are milliseconds since 1970-01-01T00:00:00Z; latitudes and longitudes are degrees on WGS 84.

CREATE TABLE source (
  id             INTEGER PRIMARY KEY AUTOINCREMENT,
  sha256         TEXT    NOT NULL CHECK (length(sha256) = 64),
  cut_key        TEXT    NOT NULL,  -- '' or the canonical text of the cut and of the operator's overrides
  name           TEXT    NOT NULL,
  bytes          INTEGER NOT NULL CHECK (bytes >= 0),
  product_id     TEXT    NOT NULL,
  dataset_id     TEXT    NOT NULL,
  attribution    TEXT    NOT NULL,
  ingested_at_ms INTEGER NOT NULL,
  UNIQUE (sha256, cut_key)
) STRICT;

CREATE TABLE source_warning (
  source_id INTEGER NOT NULL REFERENCES source (id) ON DELETE CASCADE,
  position  INTEGER NOT NULL,
  text      TEXT    NOT NULL,
  PRIMARY KEY (source_id, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE granule (
  id                INTEGER PRIMARY KEY AUTOINCREMENT,
  source_id         INTEGER NOT NULL REFERENCES source (id) ON DELETE CASCADE,
  content_sha256    TEXT    NOT NULL CHECK (length(content_sha256) = 64),
  content_bytes     INTEGER NOT NULL CHECK (content_bytes >= 0),
  contains_stokes   INTEGER NOT NULL CHECK (contains_stokes IN (0, 1)),
  is_point_series   INTEGER NOT NULL CHECK (is_point_series IN (0, 1)),
  station           TEXT    NOT NULL,
  status            TEXT    NOT NULL,
  reference_time_ms INTEGER,
  ensemble_member   INTEGER,
  first_time_ms     INTEGER,  -- start of the first cell; both NULL: a static field
  last_time_ms      INTEGER,  -- end of the last cell
  times             INTEGER NOT NULL CHECK (times >= 0),
  west_deg          REAL    NOT NULL,  -- west > east: across the antimeridian
  south_deg         REAL    NOT NULL,
  east_deg          REAL    NOT NULL,
  north_deg         REAL    NOT NULL,
  vertical          TEXT    NOT NULL CHECK (vertical IN ('none', 'depth_m', 'height_m')),
  lowest_level_m    REAL,
  highest_level_m   REAL,
  product_id        TEXT    NOT NULL,
  dataset_id        TEXT    NOT NULL,
  attribution       TEXT    NOT NULL,
  CHECK ((first_time_ms IS NULL) = (last_time_ms IS NULL)),
  CHECK (first_time_ms IS NULL OR first_time_ms <= last_time_ms)
) STRICT;

CREATE INDEX granule_by_source ON granule (source_id);
CREATE INDEX granule_by_time ON granule (last_time_ms, first_time_ms);
CREATE INDEX granule_by_content ON granule (content_sha256);

CREATE TABLE granule_variable (
  granule_id    INTEGER NOT NULL REFERENCES granule (id) ON DELETE CASCADE,
  position      INTEGER NOT NULL,
  standard_name TEXT    NOT NULL,  -- CF
  PRIMARY KEY (granule_id, position)
) STRICT, WITHOUT ROWID;

CREATE INDEX granule_variable_by_name ON granule_variable (standard_name, granule_id);

CREATE TRIGGER source_is_immutable BEFORE UPDATE ON source
BEGIN SELECT RAISE(ABORT, 'a source row is never changed'); END;

CREATE TRIGGER granule_is_immutable BEFORE UPDATE ON granule
BEGIN SELECT RAISE(ABORT, 'a granule row is never changed'); END;

CREATE TRIGGER granule_variable_is_immutable BEFORE UPDATE ON granule_variable
BEGIN SELECT RAISE(ABORT, 'a granule row is never changed'); END;
