"""read_records.py LOG.nc FILE.mcap BAG: what mcap and rosbags read in the records of a live run is what its log has."""
import datetime
import pathlib
import sys

import mcap.reader
import mcap_ros2.decoder
import netCDF4
import rosbags.highlevel


def stamp(header):
    return header.stamp.sec + 1e-9 * header.stamp.nanosec


def of_mcap(path):
    """(topic, log time, decoder of the message) in the order of the times."""
    factory = mcap_ros2.decoder.DecoderFactory()
    with open(path, "rb") as file:
        for schema, channel, message in mcap.reader.make_reader(file).iter_messages():
            yield channel.topic, message.log_time, (
                lambda schema=schema, channel=channel, message=message:
                factory.decoder_for(channel.message_encoding, schema)(message.data))


def of_bag(path):
    with rosbags.highlevel.AnyReader([pathlib.Path(path)]) as reader:
        for connection, log_time, raw in reader.messages():
            yield connection.topic, log_time, (
                lambda connection=connection, raw=raw: reader.deserialize(raw, connection.msgtype))


log = netCDF4.Dataset(sys.argv[1])
names = ["".join(c.decode() for c in row if c).strip("\0 ") for row in log["trajectory"][:].filled(b"")]
rov = names.index("rov")
epoch = netCDF4.num2date(log["time"][0], log["time"].units, only_use_cftime_datetimes=False)
begin = epoch.replace(tzinfo=datetime.timezone.utc).timestamp()
seconds = log["time"][:] - log["time"][0]
tracks = {round(float(t), 3): (float(x), float(y), float(z)) for t, x, y, z in
          zip(seconds, log["x"][rov], log["y"][rov], log["z"][rov])}

counts = {}
for name, records in (("mcap", of_mcap(sys.argv[2])), ("bag", of_bag(sys.argv[3]))):
    count, poses, worst = {}, 0, 0.0
    for topic, log_time, decode in records:
        count[topic] = count.get(topic, 0) + 1
        # Every message of the track, the first of each other topic.
        if topic != "/rov/pose":
            if count[topic] == 1:
                decode()
            continue
        message = decode()
        t = round(stamp(message.header) - begin, 3)
        assert abs(log_time * 1e-9 - stamp(message.header)) < 1e-6
        if t in tracks:
            poses += 1
            p = message.pose.position
            worst = max(worst, max(abs(a - b) for a, b in zip((p.x, p.y, p.z), tracks[t])))
    assert poses > 50, (name, poses)
    assert worst < 1e-6, (name, worst)
    for topic in ("/clock", "/rov/odometry", "/rov/imu", "/usv/nav_sat_fix", "/rov/battery_state", "/rov/mission_state",
                  "/site/current_profile", "/site/wind", "/rov/cmd_vel", "/rov/waypoints", "/rov/refused",
                  "/late/pose", "/late/battery_state", "/late/waypoints", "/late_usv/odometry"):
        assert count.get(topic, 0) > 0, (name, topic)
    # As `ros2 bag record -a` has it.
    assert not [topic for topic in count if "/_" in topic], (name, sorted(count))
    counts[name] = count
    print(f"{name}: {sum(count.values())} messages on {len(count)} topics, {poses} poses as in the log")
assert counts["mcap"] == counts["bag"]

# Front to end, as most read it: one schema that it cannot name would end it for all.
with open(sys.argv[2], "rb") as file:
    reader = mcap.reader.make_reader(file, decoder_factories=[mcap_ros2.decoder.DecoderFactory()])
    assert sum(1 for _ in reader.iter_decoded_messages()) == sum(counts["mcap"].values())
