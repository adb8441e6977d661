"""same_records.py RUN.mcap AGAIN.mcap: what a run told of its vehicles and of the water is told again, to the byte, by
its log."""
import sys

import mcap.reader


def told(path):
    topics = {}
    with open(path, "rb") as file:
        for _, channel, message in mcap.reader.make_reader(file).iter_messages(log_time_order=False):
            topics.setdefault(channel.topic, []).append((message.log_time, message.data))
    return topics


run, again = told(sys.argv[1]), told(sys.argv[2])
# Who is at the helm, which mission_state has, is not in a log; refusals are in it with their count.
own = [topic for topic in again if topic.split("/")[-1] not in ("mission_state", "reserve", "refused")]
assert len(own) > 15, own
for topic in own:
    if topic.endswith("/waypoints"):  # a client's stamps are not in a log; the last place is in the last 56 bytes
        assert [(t, len(d)) for t, d in run[topic]] == [(t, len(d)) for t, d in again[topic]], topic
        assert all(a[1][-56:] == b[1][-56:] for a, b in zip(run[topic], again[topic])), topic
        continue
    assert run[topic] == again[topic], (topic, len(run[topic]), len(again[topic]))
print(f"{len(own)} topics told again: {sum(len(again[topic]) for topic in own)} messages, the same to the byte")
