"""make_counted_values.py FOLDER IDL...: what fills every structure of the IDL with counted values, in C++ for
fastddsgen's types and in C for idlc's; and a list of them all. IDL files in the order in which they include each
other."""
import pathlib
import re
import sys

# type of IDL: what puts a value there (counted_values.h, cyclone_types.c), type of C
SIMPLE = {
    "double": ("real", "double"),
    "float": ("real32", "float"),
    "long": ("int32", "int32_t"),
    "unsigned long": ("uint32", "uint32_t"),
    "unsigned short": ("uint16", "uint16_t"),
    "unsigned long long": ("uint64", "uint64_t"),
    "int8": ("int8", "int8_t"),
    "octet": ("octet", "uint8_t"),
    "boolean": ("boolean", "bool"),
    "char": ("character", "char"),
    "string": ("text", "char *"),
}


def structures(texts):
    """(modules, name, [(type, element of a sequence or bounds of an array, name)])"""
    found = []
    for text in texts:
        text = re.sub(r"//.*|#.*|@\w+", "", text)
        tokens = re.findall(r"[\w:]+|[^\s\w]", text)
        modules = []
        while tokens:
            word = tokens.pop(0)
            if word == "module":
                modules.append(tokens.pop(0))
                assert tokens.pop(0) == "{"
            elif word == "}":
                modules.pop()
                assert tokens.pop(0) == ";"
            elif word == "struct":
                name = tokens.pop(0)
                body = tokens[1:tokens.index("}")]
                del tokens[:len(body) + 3]
                members = [m.split() for m in " ".join(body).split(";") if m.strip()]
                found.append((tuple(modules), name, members))
            else:
                raise ValueError(f"cannot read {word!r}: structures in modules are all that is known")
    return found


class Maker:
    def __init__(self, found):
        self.found = found
        self.names = {"::".join((*modules, name)) for modules, name, _ in found}

    def whole(self, modules, words):
        """The name of a type with its modules."""
        name = " ".join(words)
        own = "::".join((*modules, name))
        return own if own in self.names else name

    def put(self, modules, member):
        """(name, what is called in C)"""
        if member[0] == "sequence":
            element = self.whole(modules, member[2:-2])
            function, c_type = SIMPLE.get(element) or ("fill_" + element.replace("::", "_"),
                                                       "struct " + element.replace("::", "_"))
            return member[-1], f"SEQUENCE(m->{member[-1]}, {c_type}, {function});"
        is_array = member[-1] == "]"
        words = member[:-3] if is_array else member
        *words, name = words
        if "<" in words:
            return name, f"short_text(n, m->{name});"
        of = self.whole(modules, words)
        function = SIMPLE[of][0] if of in SIMPLE else "fill_" + of.replace("::", "_")
        return name, f"ARRAY(m->{name}, {function});" if is_array else f"{function}(n, &m->{name});"

    def cpp(self):
        for modules, name, members in self.found:
            fields = ", ".join(f"m.{self.put(modules, member)[0]}()" for member in members)
            yield f"void put({'::'.join((*modules, name))}& m) {{ all({fields}); }}"

    def c(self):
        for modules, name, members in self.found:
            whole = "_".join((*modules, name))
            yield f"static void fill_{whole}(unsigned* n, {whole}* m) {{"
            yield from ("  " + self.put(modules, member)[1] for member in members)
            yield "}"

    def every(self):
        yield "#define SLACKWATER_EVERY_TYPE(X) \\"
        for modules, name, _ in self.found:
            yield f"  X({', '.join((*modules, name))}) \\"
        yield ""


def main():
    folder = pathlib.Path(sys.argv[1])
    maker = Maker(structures([pathlib.Path(idl).read_text() for idl in sys.argv[2:]]))
    for file, lines in (("counted_fields.inc", maker.cpp()), ("cyclone_fields.inc", maker.c()),
                        ("every_type.h", maker.every())):
        (folder / file).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
