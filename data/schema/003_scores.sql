-- How a forecast and its baselines did once the truth was in. Replaceable: better truth may come later.

CREATE TABLE score (
  forecast_id INTEGER NOT NULL REFERENCES forecast (id) ON DELETE CASCADE,
  method      TEXT    NOT NULL,  -- 'forecast' or the name of a baseline
  json        TEXT    NOT NULL,
  PRIMARY KEY (forecast_id, method)
) STRICT, WITHOUT ROWID;
