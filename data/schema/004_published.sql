-- When the provider published what a product file holds, where the file says it (ingest/publication.h).
-- NULL: nobody knows, as for every file that came in before this was read.

ALTER TABLE source ADD COLUMN published_at_ms INTEGER;
