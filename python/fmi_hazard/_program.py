"""Where the program is."""

import os
import shutil
import site
import sysconfig


def program() -> str:
    """The `fmi-hazard` that was installed with this package, else the one on the PATH."""
    folders = [sysconfig.get_path("scripts"), os.path.join(site.getuserbase(), "bin")]
    for folder in folders:
        path = os.path.join(folder, "fmi-hazard")
        if os.access(path, os.X_OK):
            return path
    found = shutil.which("fmi-hazard")
    if found is None:
        raise FileNotFoundError("the program fmi-hazard is neither in this Python's folder of scripts nor on the PATH")
    return found
