#!/usr/bin/env python3
"""Installs what tools/release made, as users do, where there is no Rust, and tries it.

    tools/installs.py [DIST]     DIST: the folder with it (default: target/dist)

The wheel goes into a fresh environment of Python in which nothing else is on the PATH: an example, the notebook, and a notebook whose
stop button is pressed. The program that cargo installed from its package, and the one in the archive, run where nothing is on the
PATH at all. All of them find the same in a short scan, and have the same example FMUs.
"""

import hashlib
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import time
import venv

ROOT = pathlib.Path(__file__).resolve().parent.parent
BESIDE = ["pandas", "nbclient", "ipykernel"]


def clean(folder, *path):
    """An environment in which nothing else is known."""
    return {"PATH": os.pathsep.join(map(str, path)), "HOME": str(folder), "LANG": "C.UTF-8", "JUPYTER_PLATFORM_DIRS": "1"}


def timed(what, began):
    print(f"  {time.monotonic() - began:5.1f} s  {what}", flush=True)


def example(program, folder, environment):
    """Runs an example, which ends with hazards found."""
    folder.mkdir()
    run = subprocess.run([program, "examples", "run"], cwd=folder, env=environment, capture_output=True, text=True)
    if run.returncode != 1 or "fmi-hazard explain" not in run.stderr:
        sys.exit(f"{program} examples run: exit code {run.returncode}\n{run.stdout}{run.stderr}")
    assert (folder / "out/examples/safety-fence/report.html").exists()


def found(program, folder, environment):
    """What a short scan finds, and the sums of the example FMUs."""
    folder.mkdir(exist_ok=True)
    scan = ["scan", "cells/head-collision/cell.toml", "--from", "start", "--strategy", "hybrid", "--iterations", "10", "--no-advice"]
    for arguments, code in [(["examples", "export", "cells"], 0), ([*scan, "--out", "short"], 1)]:
        run = subprocess.run([program, *arguments], cwd=folder, env=environment, capture_output=True, text=True)
        if run.returncode != code:
            sys.exit(f"{program} {arguments[0]}: exit code {run.returncode}\n{run.stdout}{run.stderr}")
    fmus = sorted((folder / "cells").rglob("*.fmu"))
    return [(folder / "short/scan.json").read_text(), [hashlib.sha256(fmu.read_bytes()).hexdigest() for fmu in fmus]]


def main():
    dist = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "target/dist").resolve()
    (wheel,), (archive,) = dist.glob("*.whl"), dist.glob("*.tar.gz")
    subprocess.run(["sha256sum", "--check", "--quiet", "SHA256SUMS"], cwd=dist, check=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        began = time.monotonic()
        own = folder / "own"
        venv.create(own, with_pip=True)
        constraints = ["--constraint", ROOT / "tools/requirements.txt"]
        pip = [own / "bin/python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*pip, *constraints, wheel, *BESIDE], check=True)
        timed("the wheel is installed in an environment of its own", began)
        began = time.monotonic()
        # With Rust, as far as it goes without building all of it anew.
        subprocess.run([*pip, "--dry-run", "--no-deps", "--force-reinstall", ROOT], check=True)
        timed("from a checkout it would be", began)

        began = time.monotonic()
        environment = clean(folder, own / "bin")
        # By its name: it is on the PATH of that environment.
        example("fmi-hazard", folder / "wheel", environment)
        expected = found("fmi-hazard", folder / "wheel", environment)
        timed("an example runs", began)
        began = time.monotonic()
        notebook = ROOT / "python/examples/first_scan.ipynb"
        subprocess.run([own / "bin/python", ROOT / "python/tests/run_notebooks.py", notebook], cwd=folder, env=environment, check=True)
        timed("notebooks run", began)

        began = time.monotonic()
        of_cargo = found(dist / "installed/bin/fmi-hazard", folder / "cargo", clean(folder))
        assert of_cargo == expected, "what cargo installed finds something else"
        with tarfile.open(archive) as packed:
            packed.extractall(folder, filter="data")
        (program,) = folder.glob("fmi-hazard-*/bin/fmi-hazard")
        assert found(program, folder / "archive", clean(folder)) == expected, "the archive's finds something else"
        for file in ["man/fmi-hazard-scan.1", "completions/_fmi-hazard", "THIRD-PARTY.txt", "LICENSE-MIT"]:
            assert (program.parent.parent / file).stat().st_size > 500, file
        timed("what cargo installed from its package, and the archive, find the same", began)


if __name__ == "__main__":
    main()
