"""The Python package with the program that is on the PATH: results, exceptions, progress, interruption, and that its options are those of
the program. `python -m unittest discover python/tests` with `python` on PYTHONPATH.
"""

import contextlib
import io
import os
import re
import signal
import subprocess
import tempfile
import threading
import typing
import unittest
from pathlib import Path

import fmi_hazard
from fmi_hazard import options

# Some seconds as a program optimised for tests; long enough to be interrupted.
QUICK: options.ScanOptions = {"strategy": "hybrid", "iterations": 10, "no_advice": True}
LONG: options.ScanOptions = {"strategy": "exhaustive", "no_advice": True}


def setUpModule():
    # Whoever starts tests in the background, as some runners do, has them ignore Ctrl-C, and all that they start.
    signal.signal(signal.SIGINT, signal.default_int_handler)


class InAFolder(unittest.TestCase):
    """Each test has the example cells in a folder of its own, and is there."""

    def setUp(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        self.enterContext(contextlib.chdir(folder))
        self.assertIn(Path("head-collision/cell.toml"), fmi_hazard.export_examples("."))


class Results(InAFolder):
    def test_a_scan_and_what_follows_it(self):
        before = fmi_hazard.scan("head-collision/cell.toml", out="before", progress=False, **QUICK)
        self.assertTrue(before.has_hazards and before.exit_code == 1 and not before.interrupted)
        self.assertEqual(before.data["verdict"], "hazards_found")
        self.assertEqual(before.data, fmi_hazard.read_scan("before").data)
        hazards = before.hazards_frame()
        self.assertEqual(list(hazards["id"]), [hazard["id"] for hazard in before.hazards])
        self.assertEqual(len(before.causes_frame()), len(before.causes))
        worst = before.causes[0]["id"]
        self.assertIn(worst, before.printed)
        shown = before._repr_html_()
        self.assertTrue(shown.startswith("<iframe srcdoc=") and worst in shown and "<html" not in shown)

        replayed = fmi_hazard.replay(before)
        self.assertEqual(replayed.exit_code, 1)
        self.assertEqual({hazard["result"] for hazard in replayed.data}, {"reproduced"})
        self.assertEqual(len(replayed.data), len(before.hazards))
        self.assertEqual(replayed.data[0]["now"]["force_n"], before.hazards[0]["force_n"])
        self.assertEqual(len(fmi_hazard.replay(before, worst).data), 1)
        explained = fmi_hazard.explain(before, worst, no_changes=True, progress=False)
        self.assertEqual(explained.data["hazard"]["id"], before.causes[0]["worst"])
        self.assertEqual((explained.data["remedies"], explained.exit_code), ([], 0))

        verified = fmi_hazard.replay_changed("before", "head-collision/fixed.toml")
        # The larger field is over the start.
        self.assertEqual({hazard["outcome"]["result"] for hazard in verified.data}, {"seen"})
        self.assertEqual(verified.exit_code, 4)
        self.assertEqual({hazard["cause"] for hazard in verified.data}, {cause["id"] for cause in before.causes})
        there = fmi_hazard.replay_changed(before, "head-collision/cell.toml")
        self.assertEqual({hazard["outcome"]["result"] for hazard in there.data}, {"still_there"})
        self.assertEqual(there.exit_code, 1)
        after = fmi_hazard.scan("head-collision/fixed.toml", out=Path("after"), progress=False, **QUICK)
        self.assertEqual((after.exit_code, after.hazards, after.has_hazards, after.inconclusive), (4, [], False, True))
        self.assertEqual(len(after.hazards_frame()), 0)
        self.assertEqual(fmi_hazard.compare(before, after).exit_code, 4)
        worse = fmi_hazard.compare(after, before)
        self.assertEqual((worse.exit_code, worse.data["counts"]), (1, {"new": len(before.hazards)}))

    def test_several_beginnings_and_anywhere_have_results_of_their_own(self):
        cell = Path("safety-fence/cell.toml").read_text()
        several = "[search]\nactions = 2\n[human]\nbegins_s = [0, 0.8]"
        Path("safety-fence/many.toml").write_text(cell.replace("[human]", several))
        scan = fmi_hazard.scan("safety-fence/many.toml", progress=False, **QUICK)
        self.assertEqual([bool(one.data["hazards"]) for one in scan.beginnings], [one.has_hazards for one in scan.beginnings])
        self.assertEqual(len(scan.beginnings), 2)
        with self.assertRaisesRegex(FileNotFoundError, "beginnings"):
            _ = scan.data
        cell = Path("head-collision/cell.toml")
        search: options.ScanOptions = {"no_advice": True}
        if os.environ.get("FMI_HAZARD_SAMPLE") != "all":
            # A piece of floor around the start, which is soon looked at.
            floor = "[human]\nfloor_m = [[0.1, -2], [0.3, -2], [0.3, -1.8], [0.1, -1.8]]\n"
            text, cell, search = cell.read_text(), cell.with_name("floor.toml"), QUICK
            cell.write_text(text.replace("[human]\n", floor))
        whole = fmi_hazard.scan(cell, from_="both", until="1s", time="20s", progress=False, **search)
        self.assertIsNotNone(whole.anywhere)
        self.assertEqual(whole.anywhere.anywhere_data["until_s"], 1.0)
        self.assertIsNone(scan.anywhere)


class Errors(InAFolder):
    def test_each_exit_code_that_is_no_result_has_its_exception_with_the_words_of_the_program(self):
        for arguments in (["scan", "nowhere.toml"], ["scan", "head-collision/cell.toml", "--seed=x"]):
            said = subprocess.run([fmi_hazard.program(), *arguments], capture_output=True, text=True)
            path, *words = arguments[1:]
            with self.assertRaises(fmi_hazard.UsageError) as caught:
                fmi_hazard.scan(path, progress=False, **({"seed": "x"} if words else {}))
            self.assertEqual((caught.exception.exit_code, said.returncode), (2, 2))
            self.assertEqual(str(caught.exception).split(), said.stderr.removeprefix("Error: ").split())
        with self.assertRaisesRegex(fmi_hazard.UsageError, "no hazard H-000000"):
            fmi_hazard.scan("head-collision/cell.toml", out="out", progress=False, **QUICK)
            fmi_hazard.explain("out", "H-000000")
        with self.assertRaises(fmi_hazard.UsageError):
            fmi_hazard.compare("out", "nowhere")

    def test_an_fmu_that_fails_is_an_exception_with_what_is_known(self):
        cell = os.environ.get("FMI_HAZARD_FAILING_CELL")
        if cell is None:
            self.skipTest("no cell is named whose FMU fails")
        with self.assertRaisesRegex(fmi_hazard.FmuFailedError, "FMU") as caught:
            fmi_hazard.scan(cell, out="out", progress=False, **QUICK)
        self.assertEqual(caught.exception.exit_code, 3)

    def test_problems_are_what_check_is_for(self):
        good = fmi_hazard.check("head-collision/cell.toml")
        self.assertEqual((good.exit_code, good.data["problems"]), (0, []))
        self.assertTrue(Path(good.data["picture"]).exists())
        cell = Path("head-collision/cell.toml").read_text()
        Path("head-collision/wrong.toml").write_text(cell.replace("moving_mass_kg", "moving_mas_kg"))
        wrong = fmi_hazard.check("head-collision/wrong.toml", no_run=True)
        self.assertEqual(wrong.exit_code, 2)
        self.assertIn("moving_mas_kg", wrong.data["problems"][0]["message"])
        with self.assertRaises(fmi_hazard.UsageError):
            fmi_hazard.check("nowhere.toml")


class Progress(InAFolder):
    def test_what_a_scan_tells_can_be_gone_through(self):
        with fmi_hazard.start_scan("head-collision/cell.toml", out="out", **QUICK) as running:
            events = list(running)
            scan = running.result()
        kinds = {event["event"] for event in events}
        self.assertLessEqual({"doing", "progress", "hazard", "results", "note"}, kinds)
        counted = [event for event in events if event["event"] == "progress"]
        self.assertEqual((counted[-1]["done"], counted[-1]["total"], counted[-1]["unit"]), (10, 10, "iterations"))
        self.assertLessEqual({h["id"] for h in scan.hazards}, {e["hazard"]["id"] for e in events if e["event"] == "hazard"})
        # Shown as a line, and heard by a function.
        shown, heard = io.StringIO(), []
        with contextlib.redirect_stderr(shown):
            fmi_hazard.scan("head-collision/cell.toml", progress=True, **QUICK)
            self.assertIn("10/10 iterations", shown.getvalue())
            fmi_hazard.scan("head-collision/cell.toml", progress=heard.append, **QUICK)
        self.assertEqual({event["event"] for event in heard}, kinds)


class Interruption(InAFolder):
    def interrupted(self, running, when):
        """Presses Ctrl-C in this process as soon as the scan tells what it waits for; what it tells until its end."""
        events = []
        for event in running:
            events.append(event)
            if when(events):
                when = lambda _: False
                # While the next event is waited for.
                threading.Timer(0.05, os.kill, [os.getpid(), signal.SIGINT]).start()
        return events

    def test_ctrl_c_ends_the_search_and_the_results_so_far_are_there(self):
        running = fmi_hazard.start_scan("head-collision/cell.toml", out="out", **LONG)
        events = self.interrupted(running, lambda events: events[-1]["event"] == "hazard")
        scan = running.result()
        self.assertTrue(scan.interrupted and scan.exit_code == 130)
        self.assertFalse(scan.data["certificate"]["complete"])
        self.assertIn("Stopping", str(events))
        self.assertTrue(scan.hazards and scan.report.exists())
        # It goes on as on the command line.
        running = fmi_hazard.start_scan(resume="out")
        self.assertIn("Resumed", str(self.interrupted(running, lambda events: events[-1]["event"] == "progress")))
        self.assertTrue(running.result().interrupted)

    def test_ctrl_c_while_an_event_is_told_keeps_the_results(self):
        pressed = []

        def heard(event):
            if event["event"] == "hazard" and not pressed:
                pressed.append(event)
                os.kill(os.getpid(), signal.SIGINT)

        scan = fmi_hazard.scan("head-collision/cell.toml", out="out", progress=heard, **LONG)
        self.assertTrue(pressed and scan.interrupted and scan.exit_code == 130 and scan.hazards)

    def test_whoever_leaves_ends_the_search(self):
        with self.assertRaises(ZeroDivisionError):
            with fmi_hazard.start_scan("head-collision/cell.toml", out="out", **LONG) as running:
                next(event for event in running if event["event"] == "progress")
                raise ZeroDivisionError
        self.assertTrue(running.result().interrupted)

    def test_a_program_that_nobody_reads_ends(self):
        command = [fmi_hazard.program(), "--progress", "json", "scan", "head-collision/cell.toml", "--out=out"]
        process = subprocess.Popen([*command, "--strategy=exhaustive", "--no-advice"], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        for line in process.stderr:
            if b'"states"' in line:
                break
        process.stderr.close()
        self.assertEqual(process.wait(timeout=60), 130)
        self.assertTrue(fmi_hazard.read_scan("out").data)

    def test_before_there_is_anything_ctrl_c_is_an_interrupt(self):
        running = fmi_hazard.start_scan("head-collision/cell.toml", **QUICK)
        running.interrupt()
        with self.assertRaises(KeyboardInterrupt):
            running.result()


class Options(unittest.TestCase):
    # Of every command, and what the package itself says.
    OURS = {"help", "progress", "quiet", "verbose", "format"}

    def test_options_and_their_values_are_those_of_the_program(self):
        for command in ("scan", "check", "explain", "replay"):
            listed = subprocess.run([fmi_hazard.program(), command, "--help"], capture_output=True, text=True, check=True).stdout
            theirs = dict(re.findall(r"\n +(?:-\w, )?--([a-z-]+)(.*?)(?=\n +(?:-\w, )?--[a-z-]+|\Z)", listed, re.DOTALL))
            own = typing.get_type_hints(getattr(options, f"{command.capitalize()}Options"))
            if command == "replay":
                # The changed cell is an argument in Python.
                own |= {**typing.get_type_hints(options.ChangedOptions), "changed": options.File}
            names = {name.rstrip("_").replace("_", "-"): kind for name, kind in own.items()}
            self.assertEqual(names.keys() - self.OURS, theirs.keys() - self.OURS, command)
            for name, kind in names.items():
                text = theirs[name]
                takes = re.match(r" (<\w+>)", text) is not None
                self.assertEqual(takes, kind is not bool, name)
                values = re.findall(r"^ +- ([a-z-]+):", text, re.MULTILINE)
                values += [value for line in re.findall(r"\[possible values: (.*?)\]", text) for value in line.split(", ")]
                if typing.get_origin(kind) is typing.Literal:
                    self.assertEqual(set(typing.get_args(kind)), set(values), name)
                else:
                    self.assertEqual(values, [], name)


if __name__ == "__main__":
    unittest.main()
