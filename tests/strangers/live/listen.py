"""listen.py DOMAIN: hears the clock of a run, until it is killed."""
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "examples" / "live"))
from cyclonedds.domain import DomainParticipant
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

import square_agent

participant = DomainParticipant(int(sys.argv[1]))
reader = DataReader(participant, Topic(participant, "rt/rov/pose", square_agent.PoseStamped), qos=square_agent.RELIABLE)
while True:
    reader.take()
    time.sleep(0.001)
