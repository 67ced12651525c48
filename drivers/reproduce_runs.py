"""Runs the cases with the program itself, or takes up runs that are finished."""
import hashlib
import json
import os
import subprocess
import sys
import time

from reproduce_model import Result

RECORD = "reproduced.json"  # in a run's folder: what it was run from


class Interrupted(Exception):
    """The user has stopped a run."""


class Runner:
    def __init__(self, program, inputs, out, quick):
        self.program, self.inputs, self.out, self.quick = program, inputs, out, quick

    def _origin(self, case):
        with open(os.path.join(self.inputs, case.scene + ".xml"), "rb") as file:
            return {"scene": hashlib.sha256(file.read()).hexdigest(), "arguments": list(case.arguments)}

    def _reusable(self, folder, origin):
        """Since when a finished run of the same scene has been there; empty if there is none."""
        try:
            with open(os.path.join(folder, RECORD)) as file:
                if json.load(file) != origin:
                    return ""
            path = os.path.join(folder, "summary.json")
            with open(path) as file:
                if json.load(file)["status"] != "finished":
                    return ""
            return time.strftime("%Y-%m-%d %H:%M", time.localtime(os.path.getmtime(path)))
        except (OSError, ValueError, KeyError):
            return ""

    def result(self, case, place):
        folder = os.path.join(self.out, "runs", case.name)
        try:
            origin = self._origin(case)
        except OSError:
            print(f"{place} {case.name}: scene missing, no {case.scene}.xml in {self.inputs}", flush=True)
            return Result(case, folder, "scene missing")
        since = self._reusable(folder, origin) if self.quick else ""
        if since:
            result = Result(case, folder, reused=since)
            print(f"{place} {case.name}: re-used, run of {since}{_standing(result)}", flush=True)
            return result
        print(f"{place} {case.name} ...", flush=True)
        problem = self._run(case, folder)
        result = Result(case, folder, problem)
        if not problem:
            with open(os.path.join(folder, RECORD), "w") as file:
                json.dump(origin, file)
        seconds = result.summary.get("wall_seconds") or 0
        start = "\x1b[K    " if sys.stdout.isatty() else "    "  # over what the run has said
        print(start + (result.problem or f"{seconds:.1f} s{_standing(result)}"), flush=True)
        return result

    def _run(self, case, folder):
        for stale in (RECORD, "summary.json"):
            if os.path.exists(os.path.join(folder, stale)):
                os.remove(os.path.join(folder, stale))
        scene = os.path.join(self.inputs, case.scene + ".xml")
        command = [self.program, "run", scene, "--out", folder, *case.arguments]
        said = ""
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as run:
            try:
                for line in run.stderr:
                    said = line.strip() or said
                    if sys.stdout.isatty():
                        print("    " + said[:110], end="\x1b[K\r", flush=True)
            except KeyboardInterrupt:  # which the run has heard, too, and ends with complete results
                run.wait()
                raise Interrupted from None
        if run.returncode in (75, 130):
            raise Interrupted
        return f"the run failed: {said}" if run.returncode else ""


def _standing(result):
    checks = result.checks()
    if not checks:
        return ""
    reached = sum(check["verdict"] == "reached" for check in checks)
    return f", {reached} of {len(checks)} checks reached"
