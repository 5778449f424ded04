"""Writes the small cells that brute.py and walks.py are meant for: cells.py FOLDER GUARDED_FMU GANTRY_FMU

A bar turns (or slides), low enough or slow enough that no arm is hit too hard; mats, fields and walls around it. Each file's first line
says until when to look, and how.
"""

import shutil
import sys
from pathlib import Path


def square(half, notch=""):
    return f"[[{-half}, {-half}], [{half}, {-half}], [{half}, {half}], {notch}[{-half}, {half}]]"


def mat(polygon, name="mat", variable="clear", kind="mat", delay=0):
    delay = f"delay_ms = {delay}\n" if delay else ""
    return f'[[sensor]]\nname = "{name}"\nkind = "{kind}"\nvariable = "{variable}"\nactive = false\n{delay}zone = {{ polygon_m = {polygon} }}\n'


def wall(name, x0, y0, x1, y1):
    return (f'[[obstacle]]\nname = "{name}"\ncentre_m = [{(x0 + x1) / 2}, {(y0 + y1) / 2}, 1.1]\n'
            f"size_m = [{x1 - x0}, {y1 - y0}, 2.2]\n")


def bar(parts, z=0.45, length=0.35, speed=2.5, bends=False, parameters=""):
    bent = "" if bends else "bend_forward_deg = 0\nbend_lateral_deg = 0\n"
    return f"""fmu = "guarded.fmu"
[[robot]]
name = "bar"
base = {{ xyz_m = [0, 0, {z}] }}
moving_mass_kg = 40
payload_kg = 3
[[robot.joint]]
name = "axis"
axis = [0, 0, 1]
angle = {{ variable = "q", unit = "rad", offset_deg = -125 }}
speed = {{ variable = "qd", unit = "rad/s" }}
[[robot.link]]
name = "bar"
joint = "axis"
capsule = {{ from_m = [0, 0, 0], to_m = [{length}, 0, 0], radius_m = 0.05 }}
{parts}
[human]
start = {{ xy_m = [0, -3], heading_deg = 90 }}
{bent}[search]
actions = 2
[parameters]
"drive.speed" = {speed}
"ssm.distance" = 0.0
{parameters}"""


def slide(parts, parameters=""):
    return f"""fmu = "gantry.fmu"
[[robot]]
name = "slide"
base = {{ xyz_m = [-0.5, 0, 0.45] }}
moving_mass_kg = 40
payload_kg = 3
[[robot.joint]]
name = "axis"
axis = [1, 0, 0]
position = {{ variable = "axis.position[1]", unit = "m" }}
speed = {{ variable = "axis.velocity[1]", unit = "m/s" }}
[[robot.link]]
name = "beam"
joint = "axis"
capsule = {{ from_m = [0, -0.2, 0], to_m = [0, 0.2, 0], radius_m = 0.05 }}
{parts}
[human]
start = {{ xy_m = [0, -3], heading_deg = 90 }}
bend_forward_deg = 0
bend_lateral_deg = 0
[search]
actions = 2
[inputs]
"plc.reset" = false
[parameters]
"axis.stroke[1]" = 1.0
"axis.speed[1]" = 1.0
{parameters}"""


def react(seconds, more=""):
    return f'"plc.t_react" = {seconds}\n{more}'


labyrinth = wall("left", -0.95, -0.9, -0.9, 0.9) + wall("right", 0.9, -0.9, 0.95, 0.9) + wall("back", -0.95, 0.9, 0.95, 0.95)
slot = "[{0}, {1}], [{0}, 0.45], [-{0}, 0.45], [-{0}, {1}], "
GANTRY_MATS = mat(square(0.85), "mat", "plc.curtain_clear")
# A ring of two mats around floor on which nobody is seen either.
RING = (mat("[[-1.05, 1.05], [-1.05, -1.05], [1.05, -1.05], [1.05, 1.05], [0.8, 1.05], [0.8, -0.8], [-0.8, -0.8], [-0.8, 1.05]]", "three sides",
            "plc.curtain_clear") + mat("[[-0.9, 0.8], [0.9, 0.8], [0.9, 1.05], [-0.9, 1.05]]", "fourth side", "plc.door_clear"))
CELLS = {
    # name: (until, options of brute.py, text)
    "late": ("1.0", "", bar(mat(square(1.1)), parameters=react(0.3))),
    "late-longer": ("1.8", "", bar(mat(square(1.1)), parameters=react(0.3))),
    "just-in-time": ("1.2", "", bar(mat(square(1.1)), parameters=react(0.1))),
    "safe": ("1.2", "", bar(mat(square(1.1)), parameters=react(0.05, '"plc.t_ramp" = 0.15\n'))),
    "small-mat": ("1.2", "", bar(mat(square(0.8)), parameters=react(0.05))),
    "fast": ("1.0", "", bar(mat(square(1.3)), speed=5, parameters=react(0.35))),
    "unseen": ("1.0", "", bar(mat(square(0.55)), length=0.5, parameters=react(0.05))),
    "bends": ("1.0", "--bends", bar(mat(square(1.3)), z=0.9, bends=True, parameters=react(0.25))),
    "bends-unseen": ("1.0", "--bends", bar(mat(square(0.7)), z=1.1, bends=True, parameters=react(0.05))),
    "wall": ("1.2", "", bar(mat("[[-1.1, -1.1], [0.6, -1.1], [0.6, 1.1], [-1.1, 1.1]]") + wall("beside", 0.5, -0.6, 0.55, 0.9),
                            parameters=react(0.2))),
    "labyrinth": ("1.8", "", bar(mat(square(1.35)) + labyrinth + wall("before", -0.5, -0.72, 0.9, -0.67), speed=5, parameters=react(0.7))),
    "filter": ("1.0", "", bar(mat(square(0.9)), parameters=react(0.05, '"filter.tau" = 0.15\n"plc.t_ramp" = 0.15\n'))),
    "muted": ("1.0", "", bar(mat(square(1.1)), parameters=react(0.05, '"muting.enabled" = true\n"muting.hold_time" = 0.4\n'))),
    "delay": ("1.0", "", bar(mat(square(1.1), delay=110), parameters=react(0.15))),
    "field": ("1.0", "", bar(mat("[[-1.0, -0.2], [0.1, -1.2], [1.3, 0.1], [0.5, 0.5], [0.2, 1.2]]", kind="scanner_field"),
                             parameters=react(0.15))),
    "slot": ("1.0", "", bar(mat(square(1.5, slot.format(0.125, 1.5))), speed=5, parameters=react(0.05))),
    "slot-narrow": ("1.0", "", bar(mat(square(1.5, slot.format(0.05, 1.5))), speed=5, parameters=react(0.05))),
    "slot-closed": ("1.0", "", bar(mat(square(1.5)), speed=5, parameters=react(0.05))),
    "slide": ("0.48", "", slide(GANTRY_MATS, '"plc.latched" = false\n"plc.reaction_ms" = 160\n')),
    "slide-latched": ("1.2", "", slide(GANTRY_MATS, '"plc.reaction_ms" = 140\n')),
    "ring": ("1.0", "", slide(RING, '"plc.filter_ms" = 200\n')),
    "ring-held": ("1.0", "", slide(RING, '"plc.filter_ms" = 100\n"plc.ramp_ms" = 100\n')),
    "ring-open": ("0.6", "", slide(RING, '"plc.latched" = false\n"plc.reaction_ms" = 100\n')),
    "slide-two": ("1.0", "", slide(mat("[[-1.1, -1.1], [0, -1.1], [0, 1.1], [-1.1, 1.1]]", "left", "plc.curtain_clear")
                                   + mat("[[0, -1.1], [1.1, -1.1], [1.1, 1.1], [0, 1.1]]", "right", "plc.door_clear"),
                                   '"muting.from_ms" = 100\n"muting.to_ms" = 400\n"plc.reaction_ms" = 100\n')),
}


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for fmu, name in zip(sys.argv[2:], ("guarded", "gantry")):
        shutil.copy(fmu, folder / f"{name}.fmu")
    for name, (until, options, text) in CELLS.items():
        (folder / f"{name}.toml").write_text(f'# {until} {options}\nschema = 1\nname = "{name}"\n{text}')


if __name__ == "__main__":
    main()
