"""played_records.py RUN.mcap PLAYED.mcap: what a run heard is heard again where its record is played, a step later, and
its vehicles pass by."""
import sys

import mcap.reader
import mcap_ros2.decoder


def told(path):
    """Messages by topic, each with its seconds since the first of all."""
    topics, begin = {}, None
    with open(path, "rb") as file:
        reader = mcap.reader.make_reader(file, decoder_factories=[mcap_ros2.decoder.DecoderFactory()])
        for _, channel, message, decoded in reader.iter_decoded_messages():
            begin = message.log_time if begin is None else begin
            topics.setdefault(channel.topic, []).append((1e-9 * (message.log_time - begin), message.data, decoded))
    return topics


run, played = told(sys.argv[1]), told(sys.argv[2])
end = played["/clock"][-1][0]
step = 0.05
asked = [(at + step, data) for at, data, _ in run["/rov/cmd_vel"] if at + step <= end + 1e-3]
heard = [(at, data) for at, data, _ in played["/rov/cmd_vel"]]
assert len(heard) > 50 and len(heard) == len(asked), (len(heard), len(asked))
for (at, data), (heard_at, heard_data) in zip(asked, heard):
    assert data == heard_data and abs(at - heard_at) < 1e-3, (at, heard_at)
names = {target.name for _, _, target in played["/ais"]}
assert {"rov", "usv"} <= names, names
print(f"{len(heard)} commands heard again, passed by: {', '.join(sorted(names))}")
