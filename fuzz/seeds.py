#!/usr/bin/env python3
"""Makes the archives of seeds/archive from the descriptions of seeds/description, and the description in UTF-16.

    fuzz/seeds.py

The same bytes every time.
"""

import pathlib
import zipfile

SEEDS = pathlib.Path(__file__).resolve().parent / "seeds"


def archive(name, entries, method):
    """Writes one archive; all entries of one time."""
    with zipfile.ZipFile(SEEDS / "archive" / name, "w", method) as file:
        for path, content in entries.items():
            info = zipfile.ZipInfo(path, date_time=(1980, 1, 1, 0, 0, 0))
            info.compress_type = method
            info.external_attr = 0o644 << 16
            file.writestr(info, content)


def main():
    two = (SEEDS / "description" / "fmi2.xml").read_bytes()
    three = (SEEDS / "description" / "fmi3.xml").read_bytes()
    utf16 = two.decode().replace("UTF-8", "UTF-16").encode("utf-16-le")
    (SEEDS / "description" / "utf16.xml").write_bytes(b"\xff\xfe" + utf16)
    files = {"modelDescription.xml": two, "binaries/linux64/Seed.so": b"\x7fELF", "resources/a.txt": b"a" * 50}
    archive("deflated.fmu", files, zipfile.ZIP_DEFLATED)
    archive("stored.fmu", {"modelDescription.xml": three, "resources/": b"", "extra/b": b""}, zipfile.ZIP_STORED)
    archive("nested.fmu", {"cell/modelDescription.xml": two, "cell/resources/a": b"a"}, zipfile.ZIP_DEFLATED)


if __name__ == "__main__":
    main()
