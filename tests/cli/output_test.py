"""Where the product goes, and what is there when the work fails."""

import json
import os
import re
import shlex
import signal
import subprocess
import unittest
from pathlib import Path

from harness import OVERSTRIKE, SCENE, CommandTest, devices, overstrike

FILES = ("page.txt", "page.lpt", "sheet.hpgl", "sheet.plt", "picture.png", "picture.tif")


class Output(CommandTest):
    def test_every_extension_draws(self):
        for name in FILES:
            size = [] if name.startswith("sheet") else ["--size", "40x30"]
            self.assertEqual(self.assert_done("render", SCENE, "-o", name, *size), b"")
            self.assertGreater((self.folder / name).stat().st_size, 100)
        self.assertEqual(self.names(), sorted(FILES))

    def test_standard_output_has_the_bytes_of_the_file(self):
        self.assert_done("render", SCENE, "-o", "page.txt")
        page = (self.folder / "page.txt").read_bytes()
        self.assertEqual(self.assert_done("render", SCENE, "-d", "line-printer", "-o", "-"), page)
        self.assertEqual(self.assert_done("render", SCENE, "-d", "line-printer"), page)

    def test_standard_input_is_a_scene(self):
        text = Path(SCENE).read_bytes()
        page = self.assert_done("render", SCENE, "-d", "line-printer")
        self.assertEqual(self.assert_done("render", "-", "-d", "line-printer", stdin=text), page)
        self.assertEqual(self.assert_done("render", "-", "-d", "line-printer", "--format", "yaml",
                                          stdin=text), page)

    def test_same_input_same_bytes(self):
        for device in devices():
            words = ("render", SCENE, "-d", device)
            one = self.assert_done(*words, "--threads", "1")
            self.assertEqual(one, self.assert_done(*words, "--threads", "2"), device)
            self.assertEqual(one, self.assert_done(*words, "--threads=7"), device)

    def test_options_change_the_picture(self):
        usual = self.assert_done("render", SCENE, "-d", "line-printer")
        seen = {usual}
        for more in (["--light", "-20,45"], ["--light=160,10"], ["--no-light"], ["--no-ground"],
                     ["--ground", "-1"], ["--density", "0.3,0.6"], ["--azimuth", "-10"],
                     ["--elevation", "-5"], ["--parallel", "8"], ["--fov", "20"],
                     ["--eye", "9,-3,4", "--target", "0,0,1"], ["--size", "80x60"],
                     ["--stream", "asa"], ["--lpi", "6"], ["--strikes", "1"]):
            page = self.assert_done("render", SCENE, "-d", "line-printer", *more)
            same_as_the_scene = more == ["--light", "-20,45"]
            self.assertEqual(page in seen, same_as_the_scene, more)
            seen.add(page)

    def test_a_closed_pipe_is_one_line_and_status_1(self):
        rendering = [["render", SCENE, "-d", device] for device in devices()]
        for words in (*rendering, ["render", "--help"], ["check", SCENE]):
            read_end, write_end = os.pipe()
            os.close(read_end)
            done = subprocess.run([OVERSTRIKE, *words], stdout=write_end, stderr=subprocess.PIPE)
            os.close(write_end)
            self.assertEqual(done.returncode, 1, words)
            self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)
            self.assertIn(b"Broken pipe", done.stderr)

    def test_a_closed_standard_output(self):
        for words in (*(f'render "{SCENE}" -d {device}' for device in devices()), "--help"):
            done = subprocess.run(["/bin/sh", "-c", f'"{OVERSTRIKE}" {words} >&-'],
                                  capture_output=True)
            self.assertEqual(done.returncode, 1, words)
            self.assertIn(b"error:", done.stderr)

    def test_a_closed_standard_error_is_not_written_into_the_picture(self):
        page = self.assert_done("render", SCENE, "-d", "line-printer")
        words = f'render "{SCENE}" -o page.txt -v --timings 2>&-'
        done = subprocess.run(["/bin/sh", "-c", f'"{OVERSTRIKE}" {words}'], cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        self.assertEqual((self.folder / "page.txt").read_bytes(), page)

    def test_a_closed_standard_input(self):
        done = subprocess.run(["/bin/sh", "-c", f'"{OVERSTRIKE}" render - -d line-printer <&-'],
                              capture_output=True)
        self.assertEqual((done.returncode, done.stdout), (1, b""))
        self.assertIn(b"standard input: Bad file descriptor", done.stderr)

    @unittest.skipUnless(Path("/dev/full").exists(), "there is no /dev/full here")
    def test_a_full_disk(self):
        for words in (["render", SCENE, "-d", "line-printer"], ["render", SCENE, "-d", "image"],
                      ["devices"]):
            with open("/dev/full", "wb") as full:
                done = subprocess.run([OVERSTRIKE, *words], stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(b"No space left", done.stderr)

    def test_folders_that_are_not_there(self):
        for name in FILES:
            self.assert_refused("render", SCENE, "-o", f"none/{name}", status=1,
                                says=[f"none/{name}", "No such file or directory"])
        self.assertEqual(self.names(), [])

    def test_an_output_that_is_a_folder(self):
        (self.folder / "page.txt").mkdir()
        self.assert_refused("render", SCENE, "-o", "page.txt", status=1, says="page.txt")
        self.assertEqual(self.names(), ["page.txt"])

    def test_an_old_file_outlives_a_failure(self):
        (self.folder / "page.txt").write_text("old")
        self.assert_refused("render", "none.yaml", "-o", "page.txt", says="none.yaml")
        self.assert_refused("render", SCENE, "-o", "page.txt", "--lpi", "99", says="lpi")
        self.assertEqual((self.folder / "page.txt").read_text(), "old")
        self.assertEqual(self.names(), ["page.txt"])

    def interrupted(self, name, size):
        """The status of a rendering that is interrupted as soon as it has begun to write."""
        words = [OVERSTRIKE, "render", SCENE, "-o", name, "--size", size]
        with subprocess.Popen(words, cwd=self.folder, stderr=subprocess.DEVNULL) as work:
            while not self.names() and work.poll() is None:
                os.sched_yield()
            work.send_signal(signal.SIGINT)
            return work.wait(timeout=60)

    def test_an_interrupt_leaves_nothing(self):
        for name in ("page.txt", "picture.png"):
            self.assertEqual(self.interrupted(name, "30000x30000"), 130)
            self.assertEqual(self.names(), [])

    def test_timings(self):
        code, _, error = overstrike("render", SCENE, "-d", "line-printer", "--timings=json")
        self.assertEqual((code, error.count("\n")), (0, 1), error)
        timings = json.loads(error)
        self.assertEqual(sorted(timings), sorted(["light_ms", "eye_ms", "scan_ms", "output_ms",
                                                  "total_ms", "peak_bytes"]))
        phases = sum(timings[name] for name in ("light_ms", "eye_ms", "scan_ms", "output_ms"))
        self.assertLessEqual(phases, timings["total_ms"])
        self.assertGreater(timings["peak_bytes"], 1_000_000)
        code, _, error = overstrike("render", SCENE, "-d", "line-printer", "--timings")
        self.assertRegex(error, r"^I light .* II eye .* III scan .* output ")

    def test_verbose_names_the_command_that_shows_it(self):
        for name, more in (("page.txt", ["--lpi", "8"]), ("page.txt", ["--lpi", "6"]),
                           ("sheet.hpgl", []), ("Ann's page.txt", []),
                           ("page.png", ["-d", "line-printer"])):
            _, _, error = overstrike("render", SCENE, "-o", name, "-v", *more, folder=self.folder)
            self.assertIn("1 body", error)
            command = shlex.split(re.search(r"to see it: overstrike (.*)", error)[1])
            self.assertEqual(command[2], name)
            eight_lines = name != "sheet.hpgl" and more != ["--lpi", "6"]
            self.assertEqual("--lpi" in command, eight_lines)
            self.assert_done(*command)
            sheet = (self.folder / command[command.index("-o") + 1]).read_bytes()
            self.assertTrue(sheet.startswith(b"\x89PNG"))


class Emulate(CommandTest):
    def test_png_and_pdf(self):
        (self.folder / "a.txt").write_bytes(b"HELLO\rHELLO\r\n")
        (self.folder / "a.hpgl").write_bytes(b"IN;SP1;PU0,0;PD1000,0,1000,1000;PU;SP0;")
        for machine, file in (("line-printer", "a.txt"), ("plotter", "a.hpgl")):
            self.assert_done("emulate", machine, file, "-o", "a.png")
            self.assert_done("emulate", machine, file, "-o", "a.pdf")
            self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG"))
            self.assertTrue((self.folder / "a.pdf").read_bytes().startswith(b"%PDF"))
            (self.folder / "a.png").unlink()
            (self.folder / "a.pdf").unlink()

    def test_standard_input(self):
        self.assert_done("emulate", "line-printer", "-", "-o", "a.png", stdin=b"HELLO\r\n")
        self.assertEqual(self.names(), ["a.png"])

    def test_standard_output_has_the_bytes_of_the_file(self):
        streams = {"line-printer": b"HELLO\rHELLO\r\n",
                   "plotter": b"IN;SP1;PU0,0;PD1000,0,1000,1000;PU;SP0;"}
        for machine, format in (("line-printer", "png"), ("line-printer", "pdf"), ("plotter", "png"),
                                ("plotter", "pdf"), ("plotter", "svg")):
            words = ("emulate", machine, "-", "-o")
            self.assert_done(*words, f"a.{format}", stdin=streams[machine])
            sheet = (self.folder / f"a.{format}").read_bytes()
            (self.folder / f"a.{format}").unlink()
            more = ["--format", format] if format != "png" else []
            self.assertEqual(self.assert_done(*words, "-", *more, stdin=streams[machine]), sheet)
        self.assertEqual(self.names(), [])

    def test_standard_output_leaves_nothing_behind(self):
        os.environ["TMPDIR"] = str(self.folder)
        self.addCleanup(os.environ.pop, "TMPDIR")
        words = ("emulate", "line-printer", "-", "-o", "-")
        self.assert_done(*words, stdin=b"A\r\n")
        self.assert_refused(*words, stdin=b"A\r\n\fB\r\n", says="2 pages are 2 pictures; --format pdf")
        self.assert_refused(*words, "--format", "svg", says="--format: expected one of png, pdf")
        self.assert_refused("emulate", "plotter", "-", "-o", "a.png", "--format", "pdf",
                            says="--format is for standard output")
        self.assertEqual(self.names(), [])

    def test_a_folder_that_is_not_there(self):
        self.assert_refused("emulate", "line-printer", "-", "-o", "none/a.png", stdin=b"A\n",
                            status=1, says="none/a.png")


if __name__ == "__main__":
    unittest.main()
