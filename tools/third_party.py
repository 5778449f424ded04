"""Fetches files of others that tests read, from PyPI, each checked against its SHA-256.

    tools/third_party.py FOLDER

FOLDER gets yourdfpy-0.0.60.tar.gz (MIT): a URDF reader, whose tests hold a description of the Franka Emika Panda. What is
there already is left alone.
"""

import hashlib
import pathlib
import sys
import urllib.request

FILES = {
    "yourdfpy-0.0.60.tar.gz": (
        "https://files.pythonhosted.org/packages/ff/19/"
        "20c50861f30aff7720f9a601f386d73760c2df9961de1f98d0dbf3b85e69/yourdfpy-0.0.60.tar.gz",
        "2af2d8bdeea1b85b642590a3b4236fdb35746d7b3e38ce460a169c18d9c4f868",
    )
}


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, (address, expected) in FILES.items():
        path = folder / name
        if path.is_file() and hashlib.sha256(path.read_bytes()).hexdigest() == expected:
            continue
        content = urllib.request.urlopen(address, timeout=120).read()
        if hashlib.sha256(content).hexdigest() != expected:
            sys.exit(f"{address} is not what it was: another SHA-256")
        path.write_bytes(content)


if __name__ == "__main__":
    main()
