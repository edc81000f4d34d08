"""Runs tk_driver: for times, and under callgrind for the instructions of the method's parts."""
import dataclasses
import pathlib
import re
import subprocess
import tempfile

COHERENCES = ("none", "span", "span+behind", "all")
REGION = "tk_region"
COLUMNS = ("ms", "runs", "leaves", "spans", "crossings", "resorts", "decisions", "flips", "updates")

# The functions of core that a part is the time of; what they call is theirs.
DECIDE = "overstrike::SolidSweep::find_seen("
SETTLE = "overstrike::SolidSweep::settle("
SPAN = "overstrike::SolidSweep::span("
LINE = "overstrike::SolidRows::on_level("
SPAN_OF_LINE = "overstrike::SolidRows::resolve_span("


@dataclasses.dataclass(frozen=True)
class Case:
    scene: str  # a scene file's text
    size: int = 512
    coherence: str = "all"
    boolean: str = "auto"


class Profile:
    """What callgrind counted of one case."""

    def __init__(self, text):
        self.total = int(re.search(r"^(?:totals|summary): (\d+)", text, re.MULTILINE)[1])
        self.calls = {}  # (caller, callee) -> instructions, with all that the callee calls
        names, caller, callee, is_call = {}, None, None, False
        for line in text.splitlines():
            if found := re.match(r"(c?)fn=\((\d+)\)(?: (.*))?", line):
                in_call, number, name = found.groups()
                names.setdefault(number, name)
                if in_call:
                    callee = names[number]
                else:
                    caller = names[number]
            elif line.startswith("calls="):
                is_call = True
            elif is_call:
                self.calls[caller, callee] = self.calls.get((caller, callee), 0) + int(line.split()[-1])
                is_call = False

    def of(self, function, caller=""):
        return sum(cost for (by, name), cost in self.calls.items()
                   if name.startswith(function) and by.startswith(caller) and not by.startswith(function))

    def parts(self):
        """The thesis' four (4.13), and what line after line is kept by."""
        sets, layers, span = self.of(DECIDE), self.of(SETTLE), self.of(SPAN)
        if not sets or not layers or not span:
            raise SystemExit("tk_measure.py has lost track of the functions of SolidSweep")
        lines = self.of(LINE) - self.of(SPAN, SPAN_OF_LINE)
        return {"set operations": sets, "spans": span - sets - layers, "layers": layers, "lines": lines,
                "rest": self.total - span - lines}


def run(command, cases, folder):
    """One dict a case, of COLUMNS."""
    lines = []
    for i, case in enumerate(cases):
        file = folder / f"{i}.yaml"
        file.write_text(case.scene, encoding="utf-8")
        lines.append(f"{file} {case.size} {case.coherence} {case.boolean}\n")
    done = subprocess.run(command, input="".join(lines), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    return [dict(zip(COLUMNS, map(float, line.split()))) for line in done.stdout.splitlines()]


def timed(driver, cases):
    """All in one run, in turns."""
    with tempfile.TemporaryDirectory() as folder:
        return run([driver], cases, pathlib.Path(folder))


def counted(driver, cases):
    """Without times, with "total" and "parts", instructions."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        out = folder / "profile"
        found = run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", f"--toggle-collect={REGION}",
                     f"--dump-after={REGION}", driver, "--once"], cases, folder)
        for i, one in enumerate(found):
            profile = Profile(pathlib.Path(f"{out}.{i + 1}").read_text(encoding="utf-8"))
            one["total"], one["parts"] = profile.total, profile.parts()
        return found
