"""Keeps what cargo compiled of packages of others, for clean checkouts of this machine: target/debug of a checkout without what is ours.

    tools/compiled.py restore    into target/, where nothing is built yet
    tools/compiled.py keep       from target/, where that is not kept yet

In ${XDG_CACHE_HOME:-~/.cache}/fmi-hazard/compiled, by the compiler, the versions of all packages and the profiles that they are compiled
with. Nothing depends on its being there: cargo looks at every file itself, and compiles what is missing or old.
"""

import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TARGET = ROOT / "target" / "debug"
FOLDERS = [".fingerprint", "build", "deps"]
# Older ones than so many are deleted.
KEPT = 3


def output(*command):
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout


def place():
    """Where what is compiled with this compiler, these versions and these profiles is kept."""
    cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache")
    key = hashlib.sha256(output("rustc", "-vV").encode())
    for name in ["Cargo.lock", "Cargo.toml"]:
        key.update((ROOT / name).read_bytes())
    return cache / "fmi-hazard" / "compiled" / key.hexdigest()[:24]


def ours():
    """How the names of what cargo makes of our own packages begin."""
    names = set()
    for package in json.loads(output("cargo", "metadata", "--no-deps", "--offline", "--format-version", "1"))["packages"]:
        names |= {package["name"]} | {target["name"] for target in package["targets"] if target["kind"] != ["custom-build"]}
    return {begin + name for name in names | {name.replace("-", "_") for name in names} for begin in ("", "lib")}


def restore():
    kept = place()
    if TARGET.exists() or not kept.is_dir():
        print("  none" if not kept.is_dir() else "  something is built already")
        return
    for folder in FOLDERS:
        shutil.copytree(kept / folder, TARGET / folder, symlinks=True)
    os.utime(kept)
    print(f"  {sum(1 for _ in (TARGET / 'deps').iterdir())} files from {kept}")


def keep():
    kept = place()
    if kept.exists():
        return
    own = ours()
    kept.parent.mkdir(parents=True, exist_ok=True)
    making = pathlib.Path(tempfile.mkdtemp(dir=kept.parent))
    for folder in FOLDERS:

        def skipped(inside, names, top=TARGET / folder):
            # NAME-HASH, with or without an ending.
            return [name for name in names if inside == str(top) and name.split(".")[0].rpartition("-")[0] in own]

        shutil.copytree(TARGET / folder, making / folder, symlinks=True, ignore=skipped)
    try:
        making.rename(kept)
    except OSError:
        # Somebody else was first.
        shutil.rmtree(making)
    for old in sorted(kept.parent.iterdir(), key=lambda path: -path.stat().st_mtime)[KEPT:]:
        shutil.rmtree(old)


if __name__ == "__main__":
    {"restore": restore, "keep": keep}[sys.argv[1]]()
