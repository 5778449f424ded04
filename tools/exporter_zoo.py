"""Makes FMUs with exporters that this project did not write, all of them from PyPI (tools/requirements.txt).

    tools/exporter_zoo.py FOLDER EXAMPLES

FOLDER gets joint2.fmu (PythonFMU, FMI 2.0), joint3.fmu (PythonFMU3, FMI 3.0), and container2.fmu and container3.fmu: the
container of the FMU Manipulation Toolbox, in both versions, around the three parts of the sensor-mat cell that lie in
EXAMPLES. The last line printed is the Python library that PythonFMU's binaries need in a host that is no Python, empty if
this machine has none.
"""

import ctypes.util
import pathlib
import subprocess
import sys
import sysconfig

import pythonfmu
import pythonfmu3

HERE = pathlib.Path(__file__).resolve().parent
PARTS = ["plc", "controller", "kinematics"]


def python_fmu(package, script, folder):
    """One FMU with PythonFMU or PythonFMU3; named after its script."""
    built = pathlib.Path(package.builder.FmuBuilder.build_FMU(HERE / "zoo" / script, dest=folder))
    built.rename(folder / pathlib.Path(script).with_suffix(".fmu").name)


def container(version, suffix, folder, examples):
    """The container around the parts of a cell; ports of one name are linked, the others exposed."""
    name = f"container{version}"
    rules = ["rule;from_fmu;from_port;to_fmu;to_port"]
    rules += [f"FMU;{examples / f'sensor-mat-{part}{suffix}.fmu'};;;" for part in PARTS]
    (folder / f"{name}.csv").write_text("\n".join(rules) + "\n", encoding="utf-8")
    command = "import sys; from fmu_manipulation_toolbox.cli.fmucontainer import fmucontainer; sys.exit(fmucontainer())"
    arguments = ["-container", f"{name}.csv:0.02", "-fmu-directory", str(folder), "-fmi", str(version)]
    done = subprocess.run([sys.executable, "-c", command, *arguments], capture_output=True, text=True, check=False)
    if not (folder / f"{name}.fmu").is_file():
        sys.exit(f"the FMU container for FMI {version} was not made:\n{done.stdout}{done.stderr}")


def python_library():
    """This Python as a shared library: a path, a name that the loader knows, or nothing."""
    name, place = (sysconfig.get_config_var(variable) or "" for variable in ("INSTSONAME", "LIBDIR"))
    path = pathlib.Path(place) / name
    if ".so" in name and path.is_file():
        return str(path)
    return ctypes.util.find_library(f"python{sys.version_info.major}.{sys.version_info.minor}") or ""


def main():
    folder, examples = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    python_fmu(pythonfmu, "joint2.py", folder)
    python_fmu(pythonfmu3, "joint3.py", folder)
    container(2, "", folder, examples)
    container(3, "-fmi3", folder, examples)
    print(python_library())


if __name__ == "__main__":
    main()
