"""Fetches files of others that tests read, by the names of their packages, each checked against its SHA-256.

    tools/third_party.py FOLDER

FOLDER gets yourdfpy-0.0.60.tar.gz (MIT): a URDF reader, whose tests hold a description of the Franka Emika Panda; and of
example-robot-data 6.0.0 (BSD) the UR5 with its collision meshes, in the folders of its package. What is there already is
left alone.
"""

import hashlib
import pathlib
import subprocess
import sys
import tempfile
import zipfile

FILES = {
    "yourdfpy-0.0.60.tar.gz": (
        "yourdfpy==0.0.60",
        "2af2d8bdeea1b85b642590a3b4236fdb35746d7b3e38ce460a169c18d9c4f868",
    )
}

ROBOT = "example-robot-data==6.0.0"
ROBOT_SHA256 = "424092a8093411ac2cd4ccc0572382bfc6b5eb4833aa984ef5e671dd67cd0a6e"
ROBOT_FILES = ("ur_description/urdf/ur5_robot.urdf", "ur_description/meshes/ur5/collision/")


def download(folder, package, *options):
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, "--no-deps", *options, "--dest", str(folder), package], check=True)


def fetch_robot(folder):
    """The wheel is large: only what is needed of it is kept."""
    done = folder / "ur5.sha256"
    if done.is_file() and done.read_text() == ROBOT_SHA256:
        return
    with tempfile.TemporaryDirectory() as temporary:
        download(temporary, ROBOT, "--only-binary", ":all:")
        (wheel,) = pathlib.Path(temporary).glob("*.whl")
        if hashlib.sha256(wheel.read_bytes()).hexdigest() != ROBOT_SHA256:
            sys.exit(f"{ROBOT} is not what it was: another SHA-256")
        with zipfile.ZipFile(wheel) as files:
            wanted = [name for name in files.namelist() if any(part in name for part in ROBOT_FILES)]
            for name in wanted:
                inside = name[name.index("example-robot-data/") :]
                path = folder / inside
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(files.read(name))
    done.write_text(ROBOT_SHA256)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    fetch_robot(folder)
    for name, (package, expected) in FILES.items():
        path = folder / name
        if path.is_file() and hashlib.sha256(path.read_bytes()).hexdigest() == expected:
            continue
        download(folder, package, "--no-binary", ":all:")
        if hashlib.sha256(path.read_bytes()).hexdigest() != expected:
            path.unlink()
            sys.exit(f"{name} of {package} is not what it was: another SHA-256")


if __name__ == "__main__":
    main()
