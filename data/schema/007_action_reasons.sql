-- Why an action of people was refused, in one word, and how many sticks the end of them stands for.

ALTER TABLE session_action ADD COLUMN reason TEXT NOT NULL DEFAULT '';  -- 'stale', ...; '': taken
ALTER TABLE session_action ADD COLUMN count INTEGER NOT NULL DEFAULT 1 CHECK (count > 0);
