"""Our recordings read by rosbags and mcap: every topic, type, time, value and count; and theirs read by us."""

import copy
import json
import pathlib
import subprocess
import sys
from datetime import datetime
from importlib.metadata import version

import mcap.reader
import mcap.records
import mcap.stream_reader
import mcap.writer
import mcap_ros2.decoder
import rosbags.rosbag2
from rosbags.interfaces import Qos, QosDurability, QosHistory, QosLiveliness, QosReliability, QosTime
from rosbags.rosbag2 import StoragePlugin
from rosbags.typesys import get_types_from_msg
from rosbags.typesys.store import Typestore

MADE_UP, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
EXPECTED = json.loads((WORK / "expected.json").read_text())
IN_TIME = sorted(EXPECTED, key=lambda m: m["log_time_ns"])
QUALITIES = {  # reliable, transient local, depth
    "/site/tide_level": (True, True, 1),
    "/site/other_level": (True, True, 1),
    "/site/wind": (False, False, 5),
}
FOREVER = QosTime(9223372036, 854775807)


def values_of(message):
    """The fields of a decoded message of either type, by either library."""
    if hasattr(message, "data"):
        return [message.data]
    header, vector = message.header, message.vector
    return [header.stamp.sec, header.stamp.nanosec, header.frame_id, vector.x, vector.y, vector.z]


def differences(found, expected):
    """Where what was read is otherwise, as texts."""
    texts = [] if len(found) == len(expected) else [f"{len(found)} messages, not {len(expected)}"]
    for number, (f, e) in enumerate(zip(found, expected, strict=False)):
        texts += [f"message {number}: {k} {f[k]!r}, not {e[k]!r}" for k in f if f[k] != e[k]]
    return texts


def expect_same(what, found, expected):
    texts = differences(found, expected)
    assert not texts, f"{what}: {len(texts)} differences, first: {texts[0]}"
    print(f"{what}: {len(found)} messages are the same")


def read_by_rosbags(path):
    found = []
    with rosbags.rosbag2.Reader(path) as reader:
        stores = {}
        for connection in reader.connections:
            # What the recording itself says of the type must do.
            store = stores[connection.topic] = Typestore()
            store.register(get_types_from_msg(connection.msgdef.data, connection.msgtype))
            if path.is_dir():
                assert connection.digest in ("", store.hash_rihs01(connection.msgtype)), connection
            assert connection.msgcount == sum(m["topic"] == connection.topic for m in EXPECTED), connection
            (qos,) = connection.ext.offered_qos_profiles
            quality = (
                qos.reliability == QosReliability.RELIABLE,
                qos.durability == QosDurability.TRANSIENT_LOCAL,
                qos.depth,
            )
            assert quality == QUALITIES[connection.topic], qos
            assert (qos.history, qos.deadline) == (QosHistory.KEEP_LAST, FOREVER), qos
        assert reader.message_count == len(EXPECTED), reader.message_count
        assert reader.start_time == IN_TIME[0]["log_time_ns"], reader.start_time
        assert reader.end_time == IN_TIME[-1]["log_time_ns"] + 1, reader.end_time
        for connection, time_ns, data in reader.messages():
            message = stores[connection.topic].deserialize_cdr(data, connection.msgtype)
            found.append(
                {
                    "topic": connection.topic,
                    "type": connection.msgtype,
                    "log_time_ns": time_ns,
                    "values": values_of(message),
                    "payload": bytes(data).hex(),
                }
            )
    return found


def of_mcap(schema, channel, message, decoded):
    assert (schema.encoding, channel.message_encoding) == ("ros2msg", "cdr"), (schema, channel)
    return {
        "topic": channel.topic,
        "type": schema.name,
        "log_time_ns": message.log_time,
        "values": values_of(decoded),
        "payload": message.data.hex(),
    }


def read_by_mcap(path):
    """By its index, all sums checked."""
    with path.open("rb") as file:
        reader = mcap.reader.SeekingReader(
            file, validate_crcs=True, decoder_factories=[mcap_ros2.decoder.DecoderFactory()]
        )
        assert reader.get_header().profile == "ros2"
        statistics = reader.get_summary().statistics
        assert statistics.message_count == len(EXPECTED), statistics
        assert statistics.message_start_time == IN_TIME[0]["log_time_ns"], statistics
        assert statistics.message_end_time == IN_TIME[-1]["log_time_ns"], statistics
        assert statistics.chunk_count == len(reader.get_summary().chunk_indexes) > 20, statistics
        wind = [m for m in IN_TIME if m["topic"] == "/site/wind"]
        picked = reader.iter_decoded_messages(topics=["/site/wind"])
        expect_same("mcap, one topic", [of_mcap(*four) for four in picked], wind)
        return [of_mcap(*four) for four in reader.iter_decoded_messages()]


def streamed_by_mcap(path):
    """Record by record, as far as it goes; of a file that was left in the middle too. Its order is that of writing."""
    factory, schemas, channels, decoders, found = mcap_ros2.decoder.DecoderFactory(), {}, {}, {}, []
    with path.open("rb") as file:
        reader = mcap.stream_reader.StreamReader(file, validate_crcs=True)
        try:
            for record in reader.records:
                if isinstance(record, mcap.records.Schema):
                    schemas[record.id] = record
                elif isinstance(record, mcap.records.Channel):
                    channels[record.id] = record
                elif isinstance(record, mcap.records.Message):
                    channel = channels[record.channel_id]
                    schema = schemas[channel.schema_id]
                    if channel.id not in decoders:
                        decoders[channel.id] = factory.decoder_for("cdr", schema)
                    found.append(of_mcap(schema, channel, record, decoders[channel.id](record.data)))
        except mcap.exceptions.EndOfFile:
            assert path.name == "left.mcap", "a whole file ends too early"
    return found


def read_by_us(path):
    answer = json.loads(subprocess.run([MADE_UP, "read", path], check=True, capture_output=True).stdout)
    channels = answer["channels"]
    messages = [
        {
            "topic": channels[channel]["topic"],
            "type": channels[channel]["type"],
            "log_time_ns": time_ns,
            "payload": payload,
        }
        for channel, time_ns, payload in answer["messages"]
    ]
    return channels, messages, answer["warnings"]


def definitions():
    """Of each type, as our recording has it."""
    with (WORK / "whole.mcap").open("rb") as file:
        schemas = mcap.reader.SeekingReader(file).get_summary().schemas
    return {s.name: s.data.decode() for s in schemas.values()}


def write_by_rosbags(path, plugin, of_version):
    with rosbags.rosbag2.Writer(path, version=of_version, storage_plugin=plugin) as writer:
        connections = {}
        for topic, kind in sorted({(m["topic"], m["type"]) for m in EXPECTED}):
            store = Typestore()
            store.register(get_types_from_msg(definitions()[kind], kind))
            reliable, transient, depth = QUALITIES[topic]
            qos = Qos(
                QosHistory.KEEP_LAST,
                depth,
                QosReliability.RELIABLE if reliable else QosReliability.BEST_EFFORT,
                QosDurability.TRANSIENT_LOCAL if transient else QosDurability.VOLATILE,
                FOREVER,
                FOREVER,
                QosLiveliness.AUTOMATIC,
                FOREVER,
                False,
            )
            connections[topic] = writer.add_connection(topic, kind, typestore=store, offered_qos_profiles=[qos])
        for m in EXPECTED:
            writer.write(connections[m["topic"]], m["log_time_ns"], bytes.fromhex(m["payload"]))


def write_by_mcap(path, **options):
    writer = mcap.writer.Writer(str(path), **options)
    writer.start(profile="ros2")
    schemas, channels = {}, {}
    for m in EXPECTED:
        if m["type"] not in schemas:
            data = definitions()[m["type"]].encode()
            schemas[m["type"]] = writer.register_schema(m["type"], "ros2msg", data)
        if m["topic"] not in channels:
            channels[m["topic"]] = writer.register_channel(m["topic"], "cdr", schemas[m["type"]])
        writer.add_message(channels[m["topic"]], m["log_time_ns"], bytes.fromhex(m["payload"]), m["log_time_ns"])
    writer.finish()


def expect_read_by_us(what, path, has_qualities):
    channels, messages, warnings = read_by_us(path)
    assert not warnings, warnings
    assert {c["topic"] for c in channels} == QUALITIES.keys(), channels
    for c in channels:
        store, ours = Typestore(), Typestore()
        store.register(get_types_from_msg(c["definition"], c["type"]))
        ours.register(get_types_from_msg(definitions()[c["type"]], c["type"]))
        assert store.hash_rihs01(c["type"]) == ours.hash_rihs01(c["type"]), c
        quality = (c["is_reliable"], c["is_transient_local"], c["depth"])
        assert not has_qualities or quality == QUALITIES[c["topic"]], c
    expect_same(f"we, what {what} wrote", messages, IN_TIME)


def theirs():
    none, lz4, zstd = (mcap.writer.CompressionType[c] for c in ("NONE", "LZ4", "ZSTD"))
    no_summary = {
        "index_types": mcap.writer.IndexType.NONE,
        "repeat_channels": False,
        "repeat_schemas": False,
        "use_statistics": False,
        "use_summary_offsets": False,
    }
    for plugin, of_version in ((StoragePlugin.SQLITE3, 8), (StoragePlugin.SQLITE3, 9), (StoragePlugin.MCAP, 9)):
        name = f"rosbags_{plugin.name.lower()}_{of_version}"
        write_by_rosbags(WORK / name, plugin, of_version)
        # rosbags 0.11 leaves the qualities out of the MCAP files that it writes.
        has_qualities = plugin == StoragePlugin.SQLITE3
        expect_read_by_us(f"rosbags ({plugin.name.lower()}, version {of_version})", WORK / name, has_qualities)
    for name, options in {
        "zstd": {"compression": zstd, "chunk_size": 10000},
        "lz4": {"compression": lz4, "chunk_size": 10000},
        "none": {"compression": none, "chunk_size": 10000},
        "one chunk": {"compression": lz4},
        "no chunks": {"use_chunking": False},
        "zstd without summary": {"compression": zstd, "chunk_size": 10000, **no_summary},
        "lz4 without summary": {"compression": lz4, "chunk_size": 10000, **no_summary},
        "no chunks, no summary": {"use_chunking": False, **no_summary},
        "sum of the data": {"compression": zstd, "enable_data_crcs": True},
    }.items():
        path = WORK / (name.replace(" ", "_").replace(",", "") + ".mcap")
        write_by_mcap(path, **options)
        expect_read_by_us(f"mcap ({name})", path, False)


def ours():
    expect_same("rosbags, our folder", read_by_rosbags(WORK / "whole"), IN_TIME)
    expect_same("rosbags, our MCAP file", read_by_rosbags(WORK / "whole.mcap"), IN_TIME)
    expect_same("rosbags, a folder left in the middle", read_by_rosbags(WORK / "left"), IN_TIME)
    expect_same("mcap, our file", read_by_mcap(WORK / "whole.mcap"), IN_TIME)
    expect_same("mcap, streamed", streamed_by_mcap(WORK / "whole.mcap"), EXPECTED)
    expect_same("mcap, a file left in the middle", streamed_by_mcap(WORK / "left.mcap"), EXPECTED)
    for name in ("whole", "whole.mcap", "left", "left.mcap"):
        _, messages, warnings = read_by_us(WORK / name)
        assert len(warnings) == (name == "left.mcap"), warnings
        expect_same(f"we, {name}", messages, IN_TIME)


def session():
    """The record of a session of people: a row a message, at the time at which it was done."""
    rows = json.loads((WORK / "session.json").read_text())
    expected = [(int(datetime.fromisoformat(row["at"]).timestamp() * 1000 + 0.5) * 1_000_000, row) for row in rows]
    path = WORK / "session.mcap"
    with path.open("rb") as file:
        reader = mcap.reader.SeekingReader(
            file, validate_crcs=True, decoder_factories=[mcap_ros2.decoder.DecoderFactory()]
        )
        found = []
        for schema, channel, message, decoded in reader.iter_decoded_messages():
            assert (schema.name, channel.topic) == ("std_msgs/msg/String", "/slackwater/session/actions"), channel
            found.append((message.log_time, json.loads(decoded.data)))
    assert found == expected, "mcap reads other rows"
    found = []
    with rosbags.rosbag2.Reader(path) as reader:
        for connection, time_ns, data in reader.messages():
            store = Typestore()
            store.register(get_types_from_msg(connection.msgdef.data, connection.msgtype))
            found.append((time_ns, json.loads(store.deserialize_cdr(data, connection.msgtype).data)))
    assert found == expected, "rosbags reads other rows"
    print(f"mcap and rosbags, the record of a session: {len(found)} rows are the same")


def planted():
    """A difference of any kind is seen."""
    found = read_by_rosbags(WORK / "whole")
    for key, change in {
        "topic": lambda t: t + "x",
        "type": lambda t: t + "x",
        "log_time_ns": lambda t: t + 1,
        "values": lambda v: [*v[:-1], v[-1] + 1e-12],
        "payload": lambda p: p[:-1] + ("0" if p[-1] != "0" else "1"),
    }.items():
        changed = copy.deepcopy(found)
        changed[1234][key] = change(changed[1234][key])
        assert differences(changed, IN_TIME), f"another {key} was not seen"
    assert differences(found[:-1], IN_TIME), "a missing message was not seen"


ours()
theirs()
session()
planted()
print(f"rosbags {version('rosbags')}, mcap {version('mcap')}, mcap-ros2-support {version('mcap-ros2-support')}")
