"""Reads the recording of a hazard with the MCAP library and compares it with the scan that it is from.

    tools/check_mcap.py hazard.mcap out/cell H-123abc

Prints the topics. Exit code 1: problems found.
"""

import argparse
import json
import math
import pathlib

import jsonschema
import pandas
from mcap.reader import make_reader


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("recording")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("id")
    arguments = parser.parse_args()
    scan = json.loads((arguments.folder / "scan.json").read_text(encoding="utf-8"))
    hazard = next(hazard for hazard in scan["hazards"] if hazard["id"] == arguments.id)
    step = scan["settings"]["contact_check_interval_s"]
    contact = round(hazard["time_s"] / step)

    topics = {}
    with open(arguments.recording, "rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        assert reader.get_header().library.startswith("fmi-hazard ")
        (metadata,) = reader.iter_metadata()
        assert metadata.name == "hazard" and metadata.metadata["id"] == hazard["id"]
        for schema, channel, message in reader.iter_messages():
            assert channel.message_encoding == "json" and schema.encoding == "jsonschema"
            value = json.loads(message.data)
            jsonschema.validate(value, json.loads(schema.data))
            assert set(value) <= set(json.loads(schema.data)["properties"])
            topics.setdefault(channel.topic, []).append((message.log_time, value))
        counts = reader.get_summary().statistics.channel_message_counts
        assert sum(counts.values()) == sum(len(messages) for messages in topics.values())

    frames = len(topics["/hazard"])
    assert len(topics["/scene"]) == len(topics["/sensors"]) == frames > contact
    for frame, (time, value) in enumerate(topics["/hazard"]):
        assert time == round(frame * step * 1e9), (frame, time)
        assert math.isclose(value["time_s"], frame * step, abs_tol=1e-9)
    at_contact = topics["/hazard"][contact][1]
    assert at_contact["force_ratio"] == hazard["ratio"] and at_contact["speed_m_s"] == hazard["speed_m_s"]
    reported = {sensor["name"]: sensor["person_detected"] for sensor in hazard["sensors"]}
    assert topics["/sensors"][contact][1] == reported
    check_scene(topics["/scene"], contact, hazard)

    if "/fmu/outputs" in topics:
        for topic, file, first in [("/fmu/inputs", "inputs", 0), ("/fmu/outputs", "outputs", 1)]:
            table = pandas.read_csv(arguments.folder / f"{hazard['id']}.{file}.csv")
            rows = len(topics[topic])
            # The table of inputs repeats its last row at the end.
            assert rows == len(table) - (topic == "/fmu/inputs")
            for number, (time, value) in enumerate(topics[topic]):
                assert time == round((number + first) * step * 1e9)
                assert all(value[name] == table[name][number] for name in table.columns[1:]), (topic, number)
    for topic, messages in sorted(topics.items()):
        print(topic, len(messages))


def check_scene(messages, contact, hazard):
    """The marker is where the hazard is, something of the robot and of the person is near it, and both have moved."""
    ids = [{entity["id"]: entity for entity in value["entities"]} for _, value in messages]
    marker = ids[contact]["contact"]["spheres"][-1]["pose"]["position"]
    point = [marker["x"], marker["y"], marker["z"]]
    assert point == hazard["contact_point_m"]
    assert not any("contact" in entities for entities in ids[:contact])
    link = [entity for name, entity in ids[contact].items() if f" {hazard['robot_link'].split()[-1]} " in name]
    robots = [part for entity in link for part in entity["spheres"] + entity["cylinders"]]
    assert robots and min(distance(part, point) for part in robots) < 0.5
    assert min(distance(part, point) for part in ids[contact]["person"]["cylinders"]) < 1.5
    assert ids[0]["person"] != ids[contact]["person"] and "cell" in ids[0]


def distance(part, point):
    position = part["pose"]["position"]
    return math.dist([position["x"], position["y"], position["z"]], point)


if __name__ == "__main__":
    main()
