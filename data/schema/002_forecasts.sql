-- Forecasts as issued: inserted once, never changed, removed only by `store prune --forecasts`.

CREATE TABLE forecast (
  id             INTEGER PRIMARY KEY AUTOINCREMENT,
  site_id        TEXT    NOT NULL,
  day            TEXT    NOT NULL CHECK (day GLOB '[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]'),  -- day D
  issued_ms      INTEGER NOT NULL,
  valid_from_ms  INTEGER NOT NULL,
  valid_to_ms    INTEGER NOT NULL,
  wind_policy    TEXT    NOT NULL,
  origin         TEXT    NOT NULL CHECK (origin IN ('forecast', 'hindcast')),
  degraded       INTEGER NOT NULL CHECK (degraded IN (0, 1)),
  headline       TEXT    NOT NULL,
  content_sha256 TEXT    NOT NULL CHECK (length(content_sha256) = 64),
  content_bytes  INTEGER NOT NULL CHECK (content_bytes >= 0),
  summary_json   TEXT    NOT NULL,
  code_version   TEXT    NOT NULL,
  CHECK (valid_from_ms <= valid_to_ms)
) STRICT;

CREATE INDEX forecast_by_site ON forecast (site_id, day, issued_ms);
CREATE INDEX forecast_by_content ON forecast (content_sha256);

-- No cascade from granule: an input of a forecast cannot go while the forecast stays.
CREATE TABLE forecast_input (
  forecast_id INTEGER NOT NULL REFERENCES forecast (id) ON DELETE CASCADE,
  position    INTEGER NOT NULL,
  granule_id  INTEGER NOT NULL REFERENCES granule (id),
  PRIMARY KEY (forecast_id, position)
) STRICT, WITHOUT ROWID;

CREATE INDEX forecast_input_by_granule ON forecast_input (granule_id);

CREATE TRIGGER forecast_is_immutable BEFORE UPDATE ON forecast
BEGIN SELECT RAISE(ABORT, 'a forecast as issued is never changed'); END;

CREATE TRIGGER forecast_input_is_immutable BEFORE UPDATE ON forecast_input
BEGIN SELECT RAISE(ABORT, 'a forecast as issued is never changed'); END;
