-- What the next shift is told with a decision. It stood in the note until now; old notes stay.

ALTER TABLE decision ADD COLUMN hand_over TEXT NOT NULL DEFAULT '' CHECK (length(hand_over) <= 2000);
