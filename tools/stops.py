#!/usr/bin/env python3
"""How long it takes from Ctrl-C to the end, at random moments, and how long a scan of some seconds takes.

    tools/stops.py FMI_HAZARD FOLDER [--moments 20] [--seed 1] [--only NAME]

Five cells, made in FOLDER: links that are hulls of 6,400 corners, a curtain with a door, an FMU of 50 ms a step, the example
head-collision as it is scanned by default, and a campaign of it. Each is begun and sent the signal at moments up to 8 s, or to its end; then
`check` of the hulls and `explain` of head-collision. What is left behind has to be a result that can be read. FMPy and gcc make the FMUs.
"""

import argparse
import json
import math
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "random_cells"))
from fmu import build, description  # noqa: E402
from generate import Robot, cell, fence, sensor  # noqa: E402

LAST_S = 8.0


def ellipsoid(half, middle, rings=79, around=81):
    """An STL of an ellipsoid about z with so many rings of corners, which are all corners of its hull."""
    def point(ring, n):
        polar, turn = math.pi * ring / (rings + 1), 2 * math.pi * n / around
        unit = math.sin(polar) * math.cos(turn), math.sin(polar) * math.sin(turn), math.cos(polar)
        return [m + h * u for m, h, u in zip(middle, half, unit)]

    triangles = []
    for ring in range(rings + 1):
        for n in range(around):
            a, b, c, d = point(ring, n), point(ring + 1, n), point(ring + 1, n + 1), point(ring, n + 1)
            triangles += [[a, b, c]] * (ring < rings) + [[a, c, d]] * (ring > 0)
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *[v for corner in triangle for v in corner], 0) for triangle in triangles)
    return bytes(80) + struct.pack("<I", len(triangles)) + body


def hulls(program, folder):
    """The example sensor-mat with a hull in place of each capsule."""
    subprocess.run([program, "examples", "export", str(folder / "examples")], check=True, capture_output=True)
    home = folder / "examples" / "sensor-mat"
    text = (home / "cell.toml").read_text()
    for number, found in enumerate(re.finditer(r"capsule = \{ from_m = (\[.*?\]), to_m = (\[.*?\]), radius_m = ([\d.]+) \}", text)):
        (a, b), radius = (json.loads(found[1]), json.loads(found[2])), float(found[3])
        half = [abs(p - q) / 2 + radius for p, q in zip(a, b)]
        (home / f"hull{number}.stl").write_bytes(ellipsoid(half, [(p + q) / 2 for p, q in zip(a, b)]))
        text = text.replace(found[0], f'mesh = {{ file = "hull{number}.stl", metres_per_unit = 1 }}')
    (home / "hulls.toml").write_text(text)
    return home / "hulls.toml"


def curtain_and_door(folder):
    """A fence with a curtain in its front and a door in its back, both restarting."""
    robot = Robot(random.Random(3), 1, False)
    fx, fy = robot.ex + 0.4, robot.ey + 0.9
    parts = fence(fx, fy, opening=(-0.4, 0.4)) + sensor("door", "interlocked_door", [[-0.4, -fy - 0.01], [0.4, -fy - 0.01]], "s1", 20)
    curtain = sensor("curtain", "interlocked_door", [[-0.4, -fy + 0.3], [0.4, -fy + 0.3]], "s2", 20)
    parts += curtain.replace("interlocked_door", "light_curtain")
    text = cell("curtain-and-door", 0, [robot], parts, robot.parameters(1, latched=False), (0.0, -fy - 0.5, 90), 1.6, True)
    (folder / "curtain-and-door.toml").write_text(text)
    return folder / "curtain-and-door.toml"


def slow(folder):
    """The same with an FMU of 50 ms a step."""
    import zipfile

    library = folder / "slow.so"
    command = ["gcc", "-O2", "-DSLEEP_US=50000", "-shared", "-fPIC", "-fvisibility=hidden", "-o", library, HERE / "random_cells/robots.c", "-lm"]
    subprocess.run([str(c) for c in command], check=True)
    with zipfile.ZipFile(folder / "slow.fmu", "w") as pack:
        pack.writestr("modelDescription.xml", description(2))
        pack.write(library, "binaries/linux64/robots.so")
    text = (folder / "curtain-and-door.toml").read_text().replace('"robots2.fmu"', '"slow.fmu"')
    (folder / "slow.toml").write_text(text)
    return folder / "slow.toml"


def campaign(program, folder):
    """A planned campaign over starts of head-collision."""
    home = folder / "examples" / "head-collision"
    starts = ", ".join(f"{{ xy_m = [{x}, -2.2], heading_deg = 90 }}" for x in (-1, -0.5, 0.5, 1))
    over = f"[over.human]\nother_starts = [{starts}]\nbegins_s = [0, 0.4, 0.8]\n"
    (home / "campaign.toml").write_text(f'schema = 1\nname = "stops"\ncells = ["cell.toml"]\n{over}')
    out = folder / "campaign"
    shutil.rmtree(out, ignore_errors=True)
    subprocess.run([program, "campaign", "plan", str(home / "campaign.toml"), "--out", str(out)], check=True, capture_output=True)
    return out


def readable(out):
    """Whether every result in a folder can be read."""
    for file in out.rglob("*.json"):
        json.loads(file.read_text(encoding="utf-8"))
    return len(list(out.rglob("scan.json")))


def one(command, out, moment):
    """From the signal to the end, s, the exit code, and how many results there are; the moment none, it ends by itself."""
    begun = time.time()
    run = subprocess.Popen([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if moment is not None:
        try:
            run.wait(moment)
            return None
        except subprocess.TimeoutExpired:
            run.send_signal(signal.SIGINT)
        begun = time.time()
    words, _ = run.communicate(timeout=300)
    took = time.time() - begun
    # Before a scan has begun there is nothing to keep, and the signal does what it always does.
    begun = out and out.exists()
    if "panicked" in words or (run.returncode < 0 and (begun or run.returncode != -signal.SIGINT)):
        sys.exit(f"{command}: {words[-2000:]}")
    return took, run.returncode, readable(out) if out and out.exists() else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--moments", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    program, folder = str(Path(arguments.program).resolve()), arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    build(folder)
    out = folder / "out"
    of_hulls, doors, planned = hulls(program, folder), curtain_and_door(folder), campaign(program, folder)
    collision = folder / "examples/head-collision/cell.toml"
    scan = lambda of, *more: [program, "scan", of, "--out", out, *more]  # noqa: E731
    shown = folder / "shown"
    commands = {"hulls": scan(of_hulls), "curtain and door": scan(doors), "slow": scan(slow(folder)), "default": scan(collision),
                "campaign": [program, "campaign", "run", planned], "check": [program, "check", of_hulls], "explain": None}
    rng, longest = random.Random(arguments.seed), 0.0
    print("| what | moments | longest from signal to end | with `--time 4s` |\n|---|---|---|---|")
    for name, command in commands.items():
        if arguments.only not in name:
            continue
        if name == "explain":
            subprocess.run([program, "scan", str(collision), "--from", "start", "--no-advice", "--quiet", "--out", str(shown)], capture_output=True)
            command = [program, "explain", shown, json.loads((shown / "scan.json").read_text())["causes"][0]["id"]]
        all_took, last = [], LAST_S
        if name == "check":
            last = min(last, one(command, None, None)[0])
        for _ in range(arguments.moments):
            shutil.rmtree(out, ignore_errors=True)
            ended = one(command, planned if name == "campaign" else out, rng.uniform(0.1, last))
            if ended:
                all_took.append((ended[0], ended[1:]))
        shutil.rmtree(out, ignore_errors=True)
        timed = f"{one([*command, '--time', '4s'], out, None)[0]:.2f} s" if command[1] == "scan" else ""
        worst = max(all_took, default=(0.0, ()))
        longest = max(longest, worst[0])
        print(f"| {name} | {len(all_took)} | {worst[0]:.2f} s | {timed} |", flush=True)
    print(f"longest: {longest:.2f} s")


if __name__ == "__main__":
    main()
