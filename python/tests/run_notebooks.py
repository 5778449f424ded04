"""Runs the example notebook as it stands, then one whose stop button is pressed. Needs nbclient, ipykernel and pandas.

    run_notebooks.py FIRST_SCAN.ipynb

In the folder from which it is started; tools/installs.py does that in a fresh environment.
"""

import asyncio
import sys

import nbclient
import nbformat

LONG = """
import fmi_hazard

def heard(event):
    if event["event"] == "hazard":
        print("found", flush=True)

scan = fmi_hazard.scan("cells/safety-fence/cell.toml", strategy="exhaustive", no_advice=True, out="stopped", progress=heard)
"""
KEPT = "assert scan.interrupted and scan.exit_code == 130 and scan.hazards; 'kept'"


class Stopped(nbclient.NotebookClient):
    """Presses the stop button once, when a cell prints that something was found."""

    pressed = None

    def process_message(self, message, cell, cell_index):
        if self.pressed is None and message["msg_type"] == "stream" and "found" in message["content"]["text"]:
            self.pressed = asyncio.ensure_future(self.km.interrupt_kernel())
        return super().process_message(message, cell, cell_index)


def first_scan(path):
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    shown = [output.data for output in outputs if output.output_type == "execute_result"]
    pages = [data["text/html"] for data in shown if "text/html" in data]
    assert any(page.startswith("<iframe srcdoc=") and "three.js" in page for page in pages), "no report is shown"
    assert sum("<table" in page for page in pages if "<iframe" not in page) == 2, "no tables are shown"
    told = "".join(data["text/plain"] for data in shown)
    assert "'reproduced'" in told and "'fixed'" in told, told
    print(f"    the notebook runs: {len(outputs)} outputs")


def stopped():
    cells = [nbformat.v4.new_code_cell(code) for code in (LONG, KEPT)]
    client = Stopped(nbformat.v4.new_notebook(cells=cells), timeout=300, kernel_name="python3")
    client.execute()
    assert client.pressed is not None, "nothing was found to be stopped after"
    assert client.nb.cells[1].outputs[0].data["text/plain"] == "'kept'"
    print("    one that is stopped keeps what was found")


if __name__ == "__main__":
    first_scan(sys.argv[1])
    stopped()
