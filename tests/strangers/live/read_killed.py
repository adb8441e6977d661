"""read_killed.py FILE.mcap BAG: what mcap and rosbags read in the records of a live run that was killed: each step that the
bag says it has, and of both the same."""
import pathlib
import sqlite3
import struct
import sys

import mcap.exceptions
import mcap.reader
import rosbags.rosbag2


def of_mcap(path):
    """(topic, log time, bytes). The file has no end: it is read as a stream, until there is no more."""
    messages = []
    with path.open("rb") as file:
        try:
            for _, channel, message in mcap.reader.NonSeekingReader(file, validate_crcs=True).iter_messages(
                    log_time_order=False):
                messages.append((channel.topic, message.log_time, bytes(message.data)))
        except (mcap.exceptions.EndOfFile, struct.error):
            pass
        else:
            raise AssertionError("the file was complete: nothing was killed")
    return messages


def of_bag(path):
    (file,) = path.glob("*.db3")
    # rosbags takes the file as it is. Where the kill came in the middle of a commit (its journal has a valid header), who
    # opens it in the ordinary way undoes that first.
    journal = path / (file.name + "-journal")
    if journal.exists() and journal.read_bytes()[:8] == bytes.fromhex("d9d505f920a163d7"):
        sqlite3.connect(file).execute("SELECT count(*) FROM messages").fetchall()
    with rosbags.rosbag2.Reader(path) as reader:
        told = reader.message_count
        return told, [(connection.topic, time, bytes(data)) for connection, time, data in reader.messages()]


mcap_messages = of_mcap(pathlib.Path(sys.argv[1]))
told, bag_messages = of_bag(pathlib.Path(sys.argv[2]))
assert len(bag_messages) >= told > 0, (len(bag_messages), told)
both = min(len(mcap_messages), len(bag_messages))
for i in range(both):
    assert mcap_messages[i] == bag_messages[i], (i, mcap_messages[i], bag_messages[i])
for name, messages in ("mcap", mcap_messages), ("rosbags", bag_messages):
    clock = [time for topic, time, _ in messages if topic == "/clock"]
    assert len(clock) > 10, len(clock)
    assert all(abs(b - a - 50_000_000) < 1000 for a, b in zip(clock, clock[1:])), "a step is missing"
    print(f"{name}: {len(messages)} messages, {len(clock)} steps")
