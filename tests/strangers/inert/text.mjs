// text.mjs FIELD: what a field is filled with, for a command line.
import { text_of } from "./fields.mjs";

process.stdout.write(text_of(process.argv[2]));
