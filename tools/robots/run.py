#!/usr/bin/env python3
"""Robots with their own meshes against the same with thin capsules: are scans as fast?

    tools/robots/run.py [--from start|anywhere] FMI_HAZARD PACKAGES OUT [NAME ...]
    tools/robots/run.py --table OUT

PACKAGES is a folder of ROS packages, as the makers of robots publish them: each URDF or xacro file of a robot in it is taken, or those
whose names hold a NAME. OUT gets for each a folder with four cells and a result.json; what is in that is left alone, so that a run goes on
where one ended. PyPI's xacro expands xacro files, trimesh and scipy read meshes, FMPy unpacks the FMU: install those four.

A cell is the robot, its first two axes swinging, before a scanner field: flawed, where the field is shorter than the arm, and repaired. Each
is there with the meshes and with capsules in their place, along the longest side of a mesh and of 0.75 times the radius that holds it.
"""

import argparse
import itertools
import json
import math
import os
import pathlib
import resource
import subprocess
import sys
import time
import xml.etree.ElementTree as ET

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "random_cells"))
import fmu  # noqa: E402

THIN = 0.75
# People walk at this, m/s; the robot stops in this, s.
WALK, STOP = 1.6, 0.2
# A scan may take so long, s. Of one that takes longer is told when it was how far.
AT_MOST_S = {"start": 300, "anywhere": 90}


def expanded(path, packages):
    """The URDF of a file, with xacro expanded."""
    if path.suffix == ".urdf":
        return ET.fromstring(path.read_text(encoding="utf-8"))
    import xacro

    # xacro asks a ROS installation where packages are: here it is a folder.
    import xacro.substitution_args as arguments

    arguments._eval_find = lambda name: str((packages / name).resolve())
    return ET.fromstring(xacro.process_file(str(path)).toxml())


def robots(packages, names):
    """Name and file of each robot."""
    for package in sorted(one for one in packages.iterdir() if one.is_dir()):
        files = [f for kind in ("xacro", "urdf") for f in sorted(package.glob(f"*/*.{kind}"))]
        for path in files:
            text = path.read_text(encoding="utf-8", errors="replace")
            whole = "<joint" in text if path.suffix == ".urdf" else "xacro:include" in text and "_macro" not in path.stem
            if whole and (not names or any(name in path.stem for name in names)):
                yield path.stem, path


def numbers(text, default):
    return [float(v) for v in text.split()] if text else default


def place(origin):
    """A 4x4 matrix of an <origin>."""
    xyz, rpy = ([0, 0, 0], [0, 0, 0]) if origin is None else (numbers(origin.get("xyz"), [0, 0, 0]), numbers(origin.get("rpy"), [0, 0, 0]))
    (cr, sr), (cp, sp), (cy, sy) = [(math.cos(a), math.sin(a)) for a in rpy]
    pose = np.eye(4)
    pose[:3, :3] = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]]) @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]]) @ \
        np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    pose[:3, 3] = xyz
    return pose


def turned(axis, angle):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    pose = np.eye(4)
    pose[:3, :3] += math.sin(angle) * k + (1 - math.cos(angle)) * k @ k
    return pose


def chain(urdf):
    """The longest chain of joints from the root."""
    children = {}
    for joint in urdf.findall("joint"):
        children.setdefault(joint.find("parent").get("link"), []).append(joint)
    roots = {link.get("name") for link in urdf.findall("link")} - {j.find("child").get("link") for j in urdf.findall("joint")}
    if len(roots) != 1:
        # A part of a robot, which other files put together.
        return []
    root = roots.pop()

    def longest(link):
        ways = [[joint, *longest(joint.find("child").get("link"))] for joint in children.get(link, [])]
        return max(ways, key=lambda way: sum(j.get("type") == "revolute" for j in way), default=[])

    return longest(root)


def stretched(joints):
    """Angles at which the arm's end is far out and as high as a belly: of the second and third axis, by trying."""
    moving = [j for j in joints if j.get("type") in ("revolute", "continuous")]

    def at(angles):
        pose = np.eye(4)
        for joint in joints:
            pose = pose @ place(joint.find("origin"))
            if joint in moving:
                pose = pose @ turned(numbers(joint.find("axis").get("xyz"), [0, 0, 1]), angles.get(joint.get("name"), 0.0))
        return pose[:3, 3]

    def within(joint):
        limit = joint.find("limit")
        low, high = (-math.pi, math.pi) if limit is None else (float(limit.get("lower", -math.pi)), float(limit.get("upper", math.pi)))
        low, high = max(low, -math.pi), min(high, math.pi)
        return np.linspace(low + 0.05 * (high - low), high - 0.05 * (high - low), 15)

    bends = [joint for joint in moving if joint is not moving[0]][:3]
    best, found = -math.inf, {}
    for values in itertools.product(*[within(joint) for joint in bends]):
        angles = {joint.get("name"): float(value) for joint, value in zip(bends, values)}
        end = at(angles)
        score = math.hypot(end[0], end[1]) - 2 * abs(end[2] - 1.0)
        if score > best:
            best, found = score, {**angles, "end": end}
    return moving, found


def mesh_file(name, packages, urdf_path):
    name = name.removeprefix("file://")
    if name.startswith(("package://", "model://")):
        package, rest = name.split("//", 1)[1].split("/", 1)
        # Some wheels keep a folder above the package's.
        ways = [packages / package / rest, packages / rest.split("/", 1)[-1], packages / "/".join(rest.split("/")[1:])]
        return next((way for way in ways if way.exists()), ways[0])
    return urdf_path.parent / name


def capsule(points):
    """Ends and radius of a capsule along the longest side of the box that holds these points, which holds them."""
    low, high = points.min(0), points.max(0)
    centre, half = (low + high) / 2, (high - low) / 2
    axis = np.eye(3)[int(np.argmax(half))]
    off = points - centre
    least = np.linalg.norm(off - np.outer(off @ axis, axis), axis=1).max()
    core = max(half.max() - least / 2, 0.0)
    along = np.clip(off @ axis, -core, core)
    return centre, axis, core, float(np.linalg.norm(off - np.outer(along, axis), axis=1).max())


def written(urdf, folder, packages, path):
    """Writes meshes.urdf and capsules.urdf; how many corners the hulls of the meshes have."""
    import trimesh

    for link in urdf.findall("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
    corners = []
    for mesh in urdf.iter("mesh"):
        mesh.set("filename", str(mesh_file(mesh.get("filename"), packages, path).resolve()))
    (folder / "meshes.urdf").write_text(ET.tostring(urdf, encoding="unicode"), encoding="utf-8")
    for collision in urdf.iter("collision"):
        geometry, mesh = collision.find("geometry"), collision.find("geometry/mesh")
        if mesh is None:
            continue
        read = trimesh.load(mesh.get("filename"), force="mesh")
        points = np.array(read.vertices) * np.array(numbers(mesh.get("scale"), [1, 1, 1]))
        corners.append(len(trimesh.PointCloud(points).convex_hull.vertices))
        centre, axis, core, radius = capsule(points)
        geometry.remove(mesh)
        ET.SubElement(geometry, "capsule", radius=f"{THIN * radius:.6f}", length=f"{2 * core:.6f}")
        rpy = {0: "0 1.5707963267948966 0", 1: "1.5707963267948966 0 0", 2: "0 0 0"}[int(np.argmax(axis))]
        origin = place(collision.find("origin"))
        turn = place(ET.fromstring(f'<origin rpy="{rpy}"/>'))
        turn[:3, 3] = centre
        whole = origin @ turn
        if collision.find("origin") is not None:
            collision.remove(collision.find("origin"))
        yaw, pitch, roll = math.atan2(whole[1, 0], whole[0, 0]), math.asin(-max(-1, min(1, whole[2, 0]))), math.atan2(whole[2, 1], whole[2, 2])
        ET.SubElement(collision, "origin", xyz=" ".join(f"{v:.9f}" for v in whole[:3, 3]), rpy=f"{roll:.9f} {pitch:.9f} {yaw:.9f}")
    (folder / "capsules.urdf").write_text(ET.tostring(urdf, encoding="unicode"), encoding="utf-8")
    return corners


def cell(name, urdf, others, moving, found, flawed):
    """The text of a cell file."""
    first, second = moving[0].get("name"), moving[1].get("name")
    end = found["end"]
    far = math.hypot(end[0], end[1])
    reach = far + 0.4
    heading = math.degrees(math.atan2(end[1], end[0]))
    field = 0.45 * reach if flawed else reach + WALK * (STOP + 0.1) + 1.0
    start = max(field + 0.25, reach + 0.15)
    toward = math.radians(heading)
    xy = [round(start * math.cos(toward), 3), round(start * math.sin(toward), 3)]
    swing, period = 0.5, max(int(2 * math.pi * 0.5 * far / 1.8 * 1000 / 20) * 20, 400)
    text = f'schema = 1\nname = "{name}"\nfmu = "../fmu/robots2.fmu"\n[time]\nstep_s = 0.02\n[[robot]]\nname = "arm"\nurdf = "{urdf}"\n'
    text += "moving_mass_kg = 200\npayload_kg = 10\n" if reach > 2 else "moving_mass_kg = 20\npayload_kg = 3\n"
    for joint in moving:
        text += f'[[robot.joint]]\nname = "{joint.get("name")}"\n'
        if joint.get("name") in (first, second):
            n = 1 if joint.get("name") == first else 2
            text += f'angle = {{ variable = "r{n}.q", unit = "rad" }}\nspeed = {{ variable = "r{n}.qd", unit = "rad/s" }}\n'
        else:
            text += f'held_deg = {math.degrees(found.get(joint.get("name"), 0.0)):.4f}\n'
    for joint in others:
        held = "held_m" if joint.get("type") == "prismatic" else "held_deg"
        text += f'[[robot.joint]]\nname = "{joint.get("name")}"\n{held} = 0\n'
    polygon = [[round(field * math.cos(a), 3), round(field * math.sin(a), 3)] for a in np.linspace(0, 2 * math.pi, 12, endpoint=False)]
    text += f'[[sensor]]\nname = "field"\nkind = "scanner_field"\nvariable = "s1"\nactive = false\nzone = {{ polygon_m = {polygon} }}\n'
    text += f"[human]\nstart = {{ xy_m = {xy}, heading_deg = {(heading + 180) % 360:.1f} }}\n[search]\nactions = 8\n[parameters]\n"
    for n, (middle, swings) in enumerate([(0.0, swing), (found.get(second, 0.0), 0.1)], 1):
        text += (f'"r{n}.middle" = {middle:.4f}\n"r{n}.swing" = {swings}\n"r{n}.period_ms" = {period}\n"r{n}.reaction_ms" = 100\n"r{n}.ramp_ms" = 100\n'
                 f'"r{n}.heeds" = 1\n"r{n}.latched" = true\n')
    return text


def processor_s(process):
    """Seconds of processor time that a process has taken, without its children."""
    ticks = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="ascii").rpartition(")")[2].split()[11:13]
    return sum(map(int, ticks)) / os.sysconf("SC_CLK_TCK")


def timed(program, folder, cell_file, more):
    """What a scan says and takes: seconds of all its processes and from start to end."""
    out = folder / "out" / "-".join([cell_file.stem, more[1], *more[3:4]])
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    words = [program, "scan", str(cell_file), "--no-advice", "--out", str(out), "--time", f"{AT_MOST_S[more[1]]}s", "--workers", "1",
             "--progress", "json", *more]
    run = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    lines, reached = [], [(0.0, 0.0)]
    for line in run.stderr:
        lines.append(line)
        event = json.loads(line) if line.startswith("{") else {}
        if event.get("unit") == "of the floor" and event["done"] / event["total"] > reached[-1][1]:
            reached.append((processor_s(run.pid), event["done"] / event["total"]))
    run.wait()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = {"seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, "wall": time.monotonic() - began}
    if not (out / "scan.json").exists():
        return {**result, "verdict": f"exit {run.returncode}: {lines[-1:]}"}
    report = json.loads((out / "scan.json").read_text(encoding="utf-8"))
    worst = {}
    for hazard in report["hazards"]:
        key = f"{hazard['robot_link']} {hazard['body_region']}"
        worst[key] = max(worst.get(key, 0.0), hazard["ratio"])
    open_ = [one["need"] for one in report["obligations"] if one["standing"] == "open"]
    return {**result, "verdict": report["verdict"], "open": open_, "hazards": worst, "reached": reached}


def main():
    """Makes the cells, scans them and keeps what came of it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--from", dest="origin", choices=["start", "anywhere"], default="start", help="which scans (default: start)")
    parser.add_argument("arguments", nargs="*")
    given = parser.parse_args()
    if given.table:
        table(given.table)
        return
    program, packages, out, *names = given.arguments
    program, packages, out = str(pathlib.Path(program).resolve()), pathlib.Path(packages), pathlib.Path(out)
    fmu.build(out / "fmu")
    for name, path in robots(packages, names):
        folder, file = out / name, out / name / "result.json"
        result = json.loads(file.read_text(encoding="utf-8")) if file.exists() else made(name, path, packages, folder)
        if result is None:
            print(f"{name}: {path} is no whole robot", flush=True)
            continue
        for key, (cell_file, more) in questions(folder).items():
            if key in result or given.origin not in more:
                continue
            result[key] = timed(program, folder, cell_file, more)
            print(name, key, {k: v for k, v in result[key].items() if k not in ("hazards", "reached")}, len(result[key].get("hazards", [])), flush=True)
            file.write_text(json.dumps(result, indent=1), encoding="utf-8")


def made(name, path, packages, folder):
    """Makes the four cells of a robot. What is known before any scan; nothing of a file that is no whole robot with two axes."""
    urdf = expanded(path, packages)
    joints = chain(urdf)
    if sum(j.get("type") in ("revolute", "continuous") for j in joints) < 2:
        return None
    folder.mkdir(parents=True, exist_ok=True)
    moving, found = stretched(joints)
    turn = ("revolute", "continuous", "prismatic")
    others = [j for j in urdf.findall("joint") if j.get("type") in turn and j.find("mimic") is None and j not in moving]
    corners = written(urdf, folder, packages, path)
    for shape, twin in itertools.product(("meshes", "capsules"), ("flawed", "repaired")):
        text = cell(f"{name}-{shape}-{twin}", f"{shape}.urdf", others, moving, found, twin == "flawed")
        (folder / f"{shape}-{twin}.toml").write_text(text, encoding="utf-8")
    return {"corners": corners}


def questions(folder):
    """Each scan's name, cell file and options."""
    # Until one hazard is found, confirmed and reported.
    asked = {"first": (folder / "meshes-flawed.toml", ["--from", "start", "--stop-at", "first"])}
    for more in (["--from", "start", "--strategy", "exhaustive"], ["--from", "anywhere", "--until", "4s"]):
        for twin, shape in itertools.product(("flawed", "repaired"), ("meshes", "capsules")):
            asked[f"{shape} {twin} {more[1]}"] = (folder / f"{shape}-{twin}.toml", more)
    return asked


def compared(mesh, thin):
    """Seconds with meshes, and how many times that of capsules; of searches that did not end, where both were as far."""
    if all({"searched", "finished"}.isdisjoint(one.get("open", [])) for one in (mesh, thin)):
        return f"{mesh['seconds']:.1f}, {mesh['seconds'] / thin['seconds']:.1f}"
    far = min(one["reached"][-1][1] for one in (mesh, thin))
    at = [next(seconds for seconds, share in one["reached"] if share >= far) for one in (mesh, thin)]
    return f"{at[0] / at[1]:.1f} at {100 * far:.1f} %" if far > 0 else "none was looked at"


def table(out):
    """A line for each robot."""
    print("| robot | corners | " + " | ".join(f"{t}, from {f}: s, ratio" for t in ("flawed", "repaired") for f in ("start", "anywhere")) + " | first, s |")
    print("|---|---|---|---|---|---|---|")
    for file in sorted(out.glob("*/result.json")):
        result = json.loads(file.read_text(encoding="utf-8"))
        cells = []
        for twin, origin in itertools.product(("flawed", "repaired"), ("start", "anywhere")):
            both = [result.get(f"{shape} {twin} {origin}") for shape in ("meshes", "capsules")]
            if None in both:
                cells.append("")
                continue
            mesh, thin = both
            cells.append(compared(mesh, thin))
        first = f"{result['first']['wall']:.1f}" if "first" in result else ""
        print(f"| {file.parent.name} | {sum(result['corners'])} | " + " | ".join(cells) + f" | {first} |")


if __name__ == "__main__":
    main()
