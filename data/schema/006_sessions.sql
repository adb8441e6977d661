-- Live runs in which people took part, and what each of them did or was refused. Only ever added to.

CREATE TABLE session (
  id       INTEGER PRIMARY KEY AUTOINCREMENT,
  name     TEXT    NOT NULL,  -- of the run
  begun_ms INTEGER NOT NULL
) STRICT;

CREATE TABLE session_action (
  session_id INTEGER NOT NULL REFERENCES session (id),
  number     INTEGER NOT NULL CHECK (number > 0),  -- within the session, from 1
  at_ms      INTEGER NOT NULL,                     -- on the clock of the wall
  time_s     REAL    NOT NULL,                     -- of the run
  step       INTEGER NOT NULL,                     -- of the run
  seat       INTEGER NOT NULL,
  who        TEXT    NOT NULL,
  role       TEXT    NOT NULL,
  what       TEXT    NOT NULL CHECK (what <> ''),
  vehicle    TEXT    NOT NULL,  -- '' where it is of the run or the session
  was        TEXT    NOT NULL,
  became     TEXT    NOT NULL,
  taken      INTEGER NOT NULL CHECK (taken IN (0, 1)),
  why        TEXT    NOT NULL,
  PRIMARY KEY (session_id, number)
) STRICT, WITHOUT ROWID;

CREATE TRIGGER session_action_is_immutable BEFORE UPDATE ON session_action
BEGIN SELECT RAISE(ABORT, 'what was done in a session is never changed'); END;

CREATE TRIGGER session_action_is_kept BEFORE DELETE ON session_action
BEGIN SELECT RAISE(ABORT, 'what was done in a session is never removed'); END;
