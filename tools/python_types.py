#!/usr/bin/env python3
"""Makes the types of the Python package, python/fmi_hazard/types.py, from docs/schema/commands.schema.json.

    tools/python_types.py            writes them
    tools/python_types.py --check    says whether they are current

Needs datamodel-code-generator (tools/requirements.txt).
"""

import json
import pathlib
import re
import sys
import tempfile
import warnings

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCHEMA = ROOT / "docs" / "schema" / "commands.schema.json"
TYPES = ROOT / "python" / "fmi_hazard" / "types.py"
HEADER = '''"""What the program writes and prints, as types. Made by tools/python_types.py from docs/schema/commands.schema.json; do not edit."""
'''


def titled(schema):
    """Each variant of a tagged object gets a name, that of the object and of its tag; and it may get further properties one day."""
    for name, definition in schema["$defs"].items():
        for variant in definition.get("oneOf", []):
            variant.pop("additionalProperties", None)
            tags = [p["const"] for p in variant.get("properties", {}).values() if "const" in p]
            tags += [key for key in variant.get("required", []) if not tags and len(variant["required"]) == 1]
            if variant.get("type") == "object" and tags:
                variant["title"] = name + "".join(word.capitalize() for word in re.split(r"[_-]", tags[0]))
    return schema


def made():
    """The file, anew."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import datamodel_code_generator as generator
        from datamodel_code_generator.format import Formatter, PythonVersion

    with warnings.catch_warnings(), tempfile.TemporaryDirectory() as folder:
        # Integers of other sizes are integers.
        warnings.filterwarnings("ignore", "format of 'uint")
        out = pathlib.Path(folder) / "types.py"
        generator.generate(
            json.dumps(titled(json.loads(SCHEMA.read_text(encoding="utf-8")))),
            input_file_type=generator.InputFileType.JsonSchema,
            output=out,
            output_model_type=generator.DataModelType.TypingTypedDict,
            target_python_version=PythonVersion.PY_311,
            enum_field_as_literal=generator.LiteralType.All,
            use_schema_description=True,
            use_field_description=True,
            use_standard_collections=True,
            use_union_operator=True,
            use_title_as_name=True,
            disable_timestamp=True,
            custom_file_header=HEADER,
            formatters=[Formatter.BUILTIN],
        )
        text = out.read_text(encoding="utf-8").rstrip("\n") + "\n"
        # What Python 3.11 has not got is left out, so that the package needs no other.
        text = text.replace("\nfrom typing_extensions import TypedDict\n", "").replace("(TypedDict, closed=True)", "(TypedDict)")
        return re.sub(r"^from typing import (.*)$", r"from typing import \1, TypedDict", text, count=1, flags=re.M)


def main():
    text = made()
    if sys.argv[1:] != ["--check"]:
        TYPES.write_text(text, encoding="utf-8")
    elif not TYPES.exists() or text != TYPES.read_text(encoding="utf-8"):
        sys.exit(f"{TYPES.relative_to(ROOT)} is not current: run tools/python_types.py")


if __name__ == "__main__":
    main()
