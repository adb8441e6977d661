-- What was decided about starts of work, by whom, on which forecast, and what was said then.
-- Only ever added to: of records of one task, turbine and start the one filed last counts.

CREATE TABLE decision (
  id             INTEGER PRIMARY KEY AUTOINCREMENT,
  site_id        TEXT    NOT NULL CHECK (site_id <> ''),
  task           TEXT    NOT NULL CHECK (task <> ''),
  turbine        TEXT    NOT NULL,  -- '' where the work has none
  start_ms       INTEGER NOT NULL,
  work_ms        INTEGER CHECK (work_ms > 0),  -- to the end of its contingency; NULL: not known
  decided        TEXT    NOT NULL CHECK (decided IN ('go', 'no_go')),
  decided_by     TEXT    NOT NULL CHECK (trim(decided_by) <> '' AND length(decided_by) <= 200),
  recorded_at_ms INTEGER NOT NULL,
  by_clock       INTEGER NOT NULL CHECK (by_clock IN (0, 1)),  -- 0: the time of record was stated
  -- No cascade: a forecast that a decision names cannot go.
  forecast_id    INTEGER NOT NULL REFERENCES forecast (id),
  probability    REAL    CHECK (probability BETWEEN 0 AND 1),  -- NULL: nothing was said, see unsaid
  verdict        TEXT    NOT NULL CHECK (verdict IN ('', 'go', 'marginal', 'no-go')),
  unsaid         TEXT    NOT NULL,  -- why nothing was said of the start; else ''
  note           TEXT    NOT NULL CHECK (length(note) <= 2000),
  CHECK ((probability IS NULL) = (verdict = ''))
) STRICT;

CREATE INDEX decision_by_site ON decision (site_id, start_ms);
CREATE INDEX decision_by_start ON decision (start_ms);
CREATE INDEX decision_by_forecast ON decision (forecast_id);

CREATE TRIGGER decision_is_immutable BEFORE UPDATE ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is never changed: record another one'); END;

CREATE TRIGGER decision_is_kept BEFORE DELETE ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is never removed'); END;
