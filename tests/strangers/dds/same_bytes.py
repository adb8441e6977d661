"""same_bytes.py OURS CYCLONES: every type, byte for byte. Cyclone DDS fills its messages up to a multiple of four, and
says in the last byte of the encapsulation header with how many bytes; all else must be the same."""
import pathlib
import sys


def without_padding(data):
    padding = data[3] & 3
    return data[:3] + b"\0" + data[4:len(data) - padding]


def main():
    ours, theirs = ({path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
                    for folder in sys.argv[1:3])
    assert ours.keys() == theirs.keys(), ours.keys() ^ theirs.keys()
    for name, data in sorted(ours.items()):
        other = without_padding(theirs[name])
        assert data[:4] == b"\0\1\0\0", name
        assert data == other, f"{name}: ours {data.hex(' ')}\nCyclone's {other.hex(' ')}"
    types = {name.rsplit(".", 1)[0] for name in ours}
    print(f"{len(types)} types, {len(ours)} messages of {sum(map(len, ours.values()))} bytes: the same bytes as Cyclone's")
    assert len(types) >= 59 and len(ours) == 8 * len(types)


if __name__ == "__main__":
    main()
