"""Fetches files of others that tests read, by the names of their packages, each checked against its SHA-256.

    tools/third_party.py FOLDER

FOLDER gets yourdfpy-0.0.60.tar.gz (MIT): a URDF reader, whose tests hold a description of the Franka Emika Panda. What is
there already is left alone.
"""

import hashlib
import pathlib
import subprocess
import sys

FILES = {
    "yourdfpy-0.0.60.tar.gz": (
        "yourdfpy==0.0.60",
        "2af2d8bdeea1b85b642590a3b4236fdb35746d7b3e38ce460a169c18d9c4f868",
    )
}


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, (package, expected) in FILES.items():
        path = folder / name
        if path.is_file() and hashlib.sha256(path.read_bytes()).hexdigest() == expected:
            continue
        pip = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*pip, "--no-deps", "--no-binary", ":all:", "--dest", str(folder), package], check=True)
        if hashlib.sha256(path.read_bytes()).hexdigest() != expected:
            path.unlink()
            sys.exit(f"{name} of {package} is not what it was: another SHA-256")


if __name__ == "__main__":
    main()
