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
# What clients said and were answered is not in a log; who is at the helm is in mission_state.
own = [topic for topic in again if topic.split("/")[-1] not in ("mission_state", "reserve")]
assert len(own) > 15, own
for topic in own:
    assert run[topic] == again[topic], (topic, len(run[topic]), len(again[topic]))
print(f"{len(own)} topics told again: {sum(len(again[topic]) for topic in own)} messages, the same to the byte")
