"""certify, as its users meet it: what it says of subjects of every kind, and that all of it agrees.

usage: certify_test.py PROGRAM SOURCES EXAMPLES PLUGINS
"""
import base64
import hashlib
import html
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

PROGRAM, SOURCES, EXAMPLES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:5])
HERE = os.path.dirname(os.path.abspath(__file__))
STATUS = {"holds": 0, "violated": 1, "inconclusive": 4}
# The example plugin behind a pipe: a program that is fast.
PIPED = f"{PROGRAM} pipe answer plugin:{EXAMPLES}/example_plugin.so"
STATEMENTS = ("profile gl-canonical", "coverage facing-counts", "input float32")
SECONDS = re.compile(rb'("seconds":\s*)("[^"]*"|[0-9.e+-]+)|( time=)"[0-9.]+"')


class Certify(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)
        self.out = os.path.join(self.folder, "out")

    def scenes(self, *names):
        path = os.path.join(self.folder, "set.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"rasterproof_scene_set": 1,
                       "scenes": [{"name": name, "path": f"{SOURCES}/scenes/{name}.json"}
                                  for name in names]}, file)  # fmt: skip
        return path

    def run_certify(self, *arguments, program=PROGRAM, out=None, cwd=SOURCES):
        return subprocess.run([program, "certify", *arguments, "--out", out or self.out], cwd=cwd,
                              capture_output=True, timeout=900, check=False)  # fmt: skip

    def certify(self, *arguments, scenes=("ties", "duplicates"), program=PROGRAM):
        done = self.run_certify(*arguments, "--scenes", self.scenes(*scenes), program=program)
        text = done.stdout.decode() + done.stderr.decode()
        self.assertIn(done.returncode, STATUS.values(), text)
        return done

    def read(self, path):
        with open(path, "rb") as file:
            return file.read()

    def certificates(self):
        return [json.loads(self.read(os.path.join(self.out, name, "certificate.json")))
                for name in self.folders()]

    def folders(self):
        """The folders of subjects; that of the scenes' pictures is none."""
        return [name for name in sorted(os.listdir(self.out))
                if os.path.exists(os.path.join(self.out, name, "certificate.json"))]  # fmt: skip

    def pages(self):
        """The page of all subjects, then that of each."""
        paths = ["report.html"] + [f"{folder}/report.html" for folder in self.folders()]
        return {path: self.read(os.path.join(self.out, path)).decode() for path in paths}

    def agreed(self, done, verdict):
        """The one certificate, if status, certificate, summary, JUnit and page say the verdict."""
        text = done.stdout.decode() + done.stderr.decode()
        self.assertEqual(done.returncode, STATUS[verdict], text)
        (certificate,) = self.certificates()
        self.assertEqual(certificate["verdict"], verdict, certificate["reason"])
        self.assertRegex(done.stdout.decode().splitlines()[0], rf" {verdict} +\d+ hold ")
        (folder,) = self.folders()
        junit = xml.etree.ElementTree.parse(os.path.join(self.out, folder, "junit.xml"))
        (suite,) = junit.getroot()
        self.assertEqual(int(suite.get("failures")) != 0, verdict == "violated")
        self.assertEqual(int(suite.get("errors")) != 0, verdict == "inconclusive")
        self.assertEqual(len(junit.findall(".//failure")), int(suite.get("failures")))
        look = "idle" if verdict == "inconclusive" else verdict
        for page in self.pages().values():
            self.assertIn(f'<span class="chip {look}">{verdict}</span>', page)
        return certificate

    def subject_file(self, name, *lines, command=f"{HERE}/paints_all.py"):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join((f"command {command}", *(lines or ("coverage counts",)))) + "\n")
        return path


class Outside(Certify):
    def test_a_plugin_that_keeps_its_profile(self):
        done = self.certify("--plugin", f"{EXAMPLES}/example_plugin.so", "--cases", "8")
        certificate = self.agreed(done, "holds")
        self.assertEqual([scene["wrong"] for scene in certificate["measured"] if scene["judged"]],
                         [0, 0])  # fmt: skip

    def test_a_program_on_a_pipe(self):
        path = self.subject_file("piped.subject", *STATEMENTS, command=PIPED)
        done = self.certify("--subject", path, "--cases", "8")
        certificate = self.agreed(done, "holds")
        self.assertEqual(certificate["subject"]["name"], path)

    def test_a_type_of_ones_own_that_violates(self):
        done = self.certify("--cases", "8", program=f"{EXAMPLES}/example_own_type")
        certificate = self.agreed(done, "violated")
        failed = [p for p in certificate["tested"] if p["outcome"] == "violated"]
        self.assertTrue(failed)
        for result in failed:
            case = os.path.join(self.out, "Naive", result["property"] + ".json")
            self.assertIn(case, result["counterexample"]["replay"])
            self.assertTrue(os.path.exists(case))

    def test_every_replay_of_a_certificate_runs_as_it_is_printed(self):
        self.certify("--plugin", f"{PLUGINS}/shown_SCISSOR.so", "--cases", "30")
        (certificate,) = self.certificates()
        replays = [p["counterexample"]["replay"] for p in certificate["tested"]
                   if p["outcome"] == "violated"]  # fmt: skip
        self.assertTrue(replays)
        for replay in replays:
            self.assertTrue(replay.startswith("rasterproof "), replay)
            line = f"'{PROGRAM}' {replay.removeprefix('rasterproof ')}"
            done = subprocess.run(line, shell=True, cwd=SOURCES, capture_output=True, timeout=900,
                                  check=False)  # fmt: skip
            self.assertEqual(done.returncode, 1, line + done.stderr.decode())

    def test_one_that_crashes_is_violated_on_the_scene_too(self):
        done = self.certify("--plugin", f"{PLUGINS}/buggy_CRASH.so", "--cases", "2")
        certificate = self.agreed(done, "violated")
        (on_ties,) = [p for p in certificate["tested"] if p["property"].endswith(" on ties")]
        self.assertIn("killed by signal 11", on_ties["message"])

    def test_a_refused_scene_is_not_applicable_and_reported(self):
        path = self.subject_file("refuses.subject", *STATEMENTS,
                                 command=f"{HERE}/refuses.py 40 {PIPED}")  # fmt: skip
        done = self.certify("--subject", path, "--cases", "8")
        (certificate,) = self.certificates()
        self.assertNotEqual(certificate["verdict"], "violated", done.stdout.decode())
        refused = [p for p in certificate["tested"] if p["cases_refused"]]
        self.assertTrue(refused)
        for result in refused:
            said = f"{result['cases_refused']} refused"
            self.assertIn(said, done.stdout.decode())
            self.assertIn(said, list(self.pages().values())[1])
        said = {entry["statement"]: entry["by"] for entry in certificate["not_applicable"]}
        self.assertIn("the subject refused it: ", said["scene ties"])
        self.assertIn("48 triangles are too many", said["scene ties"])
        self.assertNotIn("scene duplicates", said)
        self.assertIn(b"scene ties: the subject refused it", done.stdout)
        self.assertIn("48 triangles are too many", list(self.pages().values())[1])

    def test_one_that_refuses_everything_is_inconclusive(self):
        done = self.certify("--plugin", f"{PLUGINS}/buggy_REFUSES.so", "--cases", "2")
        certificate = self.agreed(done, "inconclusive")
        self.assertEqual([scene["applicable"] for scene in certificate["measured"]
                          if scene["profile"] == "real"], [False, False])  # fmt: skip

    def own_scenes(self):
        (certificate,) = self.certificates()
        return {scene["scene"]: scene for scene in certificate["measured"]
                if scene["profile"] == certificate["subject"]["profile"]}  # fmt: skip

    def test_a_large_scene_is_judged_as_a_subject_without_counts_shows_it(self):
        for kind in ("MASK", "PRIMITIVE_IDS"):
            with self.subTest(kind=kind):
                shutil.rmtree(self.out, ignore_errors=True)
                self.certify("--plugin", f"{PLUGINS}/shown_{kind}.so", "--cases", "1",
                             scenes=("map", "duplicates"))  # fmt: skip
                scenes = self.own_scenes()
                self.assertEqual({name: scene["as_shown"] for name, scene in scenes.items()},
                                 {"map": True, "duplicates": False})
                for scene in scenes.values():
                    self.assertTrue(scene["judged"], scene)
                    self.assertEqual(scene["wrong"], 0, scene)

    def test_one_wrong_sample_of_a_large_scene_is_found_whatever_is_shown(self):
        for kind in ("MASK", "PRIMITIVE_IDS"):
            with self.subTest(kind=kind):
                shutil.rmtree(self.out, ignore_errors=True)
                done = self.certify("--plugin", f"{PLUGINS}/shown_ONE_SAMPLE_{kind}.so",
                                    "--cases", "1", scenes=("map",))  # fmt: skip
                self.agreed(done, "violated")
                self.assertEqual(self.own_scenes()["map"]["wrong"], 1)

    def test_of_several_subjects_the_worst_one_tells(self):
        refuses = ("--plugin", f"{PLUGINS}/buggy_REFUSES.so", "--cases", "2")
        done = self.certify(*refuses, "--subject", "spans-exact")
        self.assertEqual(done.returncode, 4, done.stdout.decode())
        done = self.certify(*refuses, "--subject", "spans-exact", "--subject", "textbook")
        self.assertEqual(done.returncode, 1, done.stdout.decode())


class Verdicts(Certify):
    def test_what_is_legal_by_freedom_holds_with_status_0(self):
        for name in ("shared-edge-samples", "contract-none", "watertight-elsewhere"):
            with self.subTest(name=name):
                shutil.rmtree(self.out, ignore_errors=True)
                done = self.certify("--subject", f"legal:{name}", "--cases", "3",
                                    scenes=("ties", "slivers", "glyphs"))  # fmt: skip
                certificate = self.agreed(done, "holds")
                differ = [scene for scene in certificate["measured"] if scene.get("wrong")]
                self.assertTrue(differ, "a scene on which it differs from the canonical model")
                for scene in differ:
                    self.assertFalse(scene["judged"])
                    self.assertIn("observed, not judged", scene["message"])

    def test_nothing_is_listed_as_not_applicable_but_what_a_result_says(self):
        self.certify("--subject", "spans-exact", "--cases", "1")
        (certificate,) = self.certificates()
        for entry in certificate["not_applicable"]:
            self.assertNotIn("this build has no", entry["by"])
            self.assertRegex(entry["statement"], r"^([A-Z]\w+|scene .*)$")

    def test_twice_gives_the_same_bytes(self):
        scenes = self.scenes("ties", "needles", "subnormal")
        contents = []
        for _ in range(2):
            # The command line is on record: both runs write to one place.
            shutil.rmtree(self.out, ignore_errors=True)
            done = self.run_certify("--all", "--cases", "1", "--scenes", scenes)
            files = {"": SECONDS.sub(b"", done.stdout)}
            for folder, _, names in os.walk(self.out):
                for name in names:
                    path = os.path.join(folder, name)
                    files[os.path.relpath(path, self.out)] = SECONDS.sub(b"", self.read(path))
            contents.append(files)
        self.assertEqual(sorted(contents[0]), sorted(contents[1]))
        for path, content in contents[0].items():
            self.assertEqual(content, contents[1][path], path)
        tiers = json.loads(self.read(f"{self.out}/f32-direct/certificate.json"))["oracle_tiers"]
        shutil.rmtree(self.out)
        self.run_certify("--subject", "f32-direct", "--cases", "1", "--scenes", scenes)
        alone = json.loads(self.read(f"{self.out}/f32-direct/certificate.json"))["oracle_tiers"]
        self.assertEqual(tiers, alone, "who else was certified changes nothing")


class IsStated(Certify):
    def proofs(self, *arguments, program=PROGRAM):
        shutil.rmtree(self.out, ignore_errors=True)
        done = self.run_certify(*arguments, "--cases", "1", "--scenes", self.scenes("duplicates"),
                                program=program)  # fmt: skip
        self.assertIn(done.returncode, (0, 1), done.stderr)
        (certificate,) = self.certificates()
        scripts = [re.search(r"reference/proofs/(\w+\.g)", entry["by"])[1]
                   for entry in certificate["proved"]]  # fmt: skip
        return scripts, certificate["subject"]["states_exact"]

    def test_a_name_proves_nothing(self):
        for name in ("f32-direct.subject", "exactly.subject"):
            path = self.subject_file(name)
            self.assertEqual(self.proofs("--subject", os.path.relpath(path, SOURCES)), ([], False))
        link = os.path.join(self.folder, "f32-direct")
        os.symlink(f"{EXAMPLES}/example_plugin.so", link)
        self.assertEqual(self.proofs("--plugin", link), ([], False))
        self.assertEqual(self.proofs("--subject", "mutant:barycentrics-rotated")[0], [])
        self.assertEqual(self.proofs("--subject", "exact"), ([], True))

    def test_a_type_that_properties_to_be_exact_is_not_believed(self):
        self.assertEqual(self.proofs(program=f"{EXAMPLES}/own_exactly"), ([], False))

    def test_a_type_with_the_name_of_a_built_in_subject_is_refused(self):
        done = self.run_certify("--scenes", self.scenes("ties"), program=f"{EXAMPLES}/own_textbook")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn(b"subject 'textbook': a type of your own has the name", done.stderr)

    def test_a_method_has_the_proofs_of_its_own_arithmetic(self):
        barycentrics = ["barycentrics_sum.g", "barycentrics_one_minus.g", "barycentrics_distance.g"]
        for name, scripts in (
            ("textbook", ["edge_direct.g", *barycentrics]),
            ("f32-direct", ["edge_direct.g", *barycentrics]),
            ("f32-kahan", ["edge_kahan.g", *barycentrics]),
            ("f32-incremental", ["edge_direct.g", "increment.g", *barycentrics]),
            ("filtered-exact", ["edge_filter.g", *barycentrics]),
            ("i64-snap8", ["exactness.g"]),
            ("hom-f32", ["homogeneous.g"]),
        ):
            self.assertEqual(self.proofs("--subject", name)[0], scripts, name)

    def installed(self):
        """The command at another place, with nothing beside it."""
        program = os.path.join(self.folder, "bin", "rasterproof")
        os.makedirs(os.path.dirname(program), exist_ok=True)
        shutil.copy(PROGRAM, program)
        return program

    def proved(self, program):
        shutil.rmtree(self.out, ignore_errors=True)
        self.run_certify("--subject", "hom-f32", "--cases", "1", "--scenes",
                         self.scenes("duplicates"), program=program)  # fmt: skip
        (certificate,) = self.certificates()
        (evidence,) = certificate["proved"]
        return evidence["by"]

    def test_proved_names_the_script_and_its_run_or_says_that_there_was_none(self):
        program = self.installed()
        script = f"{SOURCES}/reference/proofs/homogeneous.g"
        sha256 = hashlib.sha256(self.read(script)).hexdigest()
        not_run = f"reference/proofs/homogeneous.g, sha256 {sha256}: not run for this source"
        self.assertEqual(self.proved(program), not_run)

        record = os.path.join(self.folder, "bin", "proofs", "homogeneous.json")
        def prove(path):
            return subprocess.run([f"{SOURCES}/scripts/prove", "gappa", path, record],
                                  capture_output=True, check=False).returncode  # fmt: skip

        self.assertEqual(prove(script), 0)
        self.assertRegex(self.proved(program), rf"homogeneous\.g, sha256 {sha256}: run by this "
                                               r"build's tests, Gappa [\d.]+, \d{4}-\d\d-\d\d$")
        # Another script: what was proved of it is nothing of this program's.
        other = os.path.join(self.folder, "homogeneous.g")
        with open(other, "wb") as file:
            file.write(self.read(script) + b"# changed\n")
        self.assertEqual(prove(other), 0)
        self.assertEqual(self.proved(program), not_run)
        # One that does not hold leaves no record.
        self.assertEqual(prove(script), 0)
        with open(other, "wb") as file:
            file.write(self.read(script).replace(b"83886091b-48", b"83886080b-48"))
        self.assertEqual(prove(other), 1)
        self.assertEqual(self.proved(program), not_run)


class Files(Certify):
    def test_scenes_are_found_and_named_alike_wherever_the_command_is_called(self):
        done = self.run_certify("--subject", "f32-direct", "--cases", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        (certificate,) = self.certificates()
        self.assertIn("slivers", [scene["scene"] for scene in certificate["measured"]])
        pages = re.sub("<[^>]*>", "", "".join(self.pages().values()))
        self.assertNotIn(SOURCES, pages)
        (command,) = set(re.findall("rasterproof (explain scenes/.*)", pages))
        done = subprocess.run([PROGRAM, *shlex.split(command)], cwd=self.folder,
                              capture_output=True, timeout=900, check=False)  # fmt: skip
        self.assertIn(b"samples differ", done.stdout)

    def test_scenes_are_found_where_they_are_installed(self):
        program = os.path.join(self.folder, "bin", "rasterproof")
        os.makedirs(os.path.dirname(program))
        shutil.copy(PROGRAM, program)
        done = self.run_certify("--subject", "hom-exact", "--cases", "1", program=program,
                                cwd=self.folder)  # fmt: skip
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn(b"name one with --scenes FILE", done.stderr)
        share = os.path.join(self.folder, "share", "rasterproof", "scenes")
        os.makedirs(share)
        shutil.copy(f"{SOURCES}/scenes/duplicates.json", share)
        with open(os.path.join(share, "certify.json"), "w", encoding="utf-8") as file:
            file.write('{"rasterproof_scene_set": 1, "scenes": '
                       '[{"name": "d", "path": "duplicates.json"}]}')  # fmt: skip
        done = self.run_certify("--subject", "spans-exact", "--cases", "1", program=program,
                                cwd=self.folder)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_results_stay_inside_the_output_folder(self):
        scenes = self.scenes("duplicates")
        program = os.path.join(self.folder, "p.py")
        shutil.copy(f"{HERE}/paints_all.py", program)
        deep = os.path.join(self.folder, *(["d" * 60] * 6))
        os.makedirs(deep)
        shutil.copy(program, deep)
        folders = 0
        for name in (f"python3 {deep}/p.py",
                     "python3 ../" + os.path.basename(self.folder) + "/p.py",
                     "python3 p.py #/../../..",
                     "python3 p.py # \n\t'\"$(x)*?|<>\\"):  # fmt: skip
            done = self.run_certify("--exec", name, "--cases", "1", "--scenes", scenes,
                                    cwd=self.folder)  # fmt: skip
            self.assertEqual(done.returncode, 1, done.stderr)
            folders += 1
            entries = self.folders()
            self.assertEqual(len(entries), folders, "each has its own folder")
            self.assertEqual(sorted([*entries, "report.html"]), sorted(os.listdir(self.out)))
            for entry in entries:
                self.assertRegex(entry, r"^[A-Za-z0-9][-A-Za-z0-9_.+]{0,99}$")
                self.assertIn("certificate.json", os.listdir(os.path.join(self.out, entry)))
        self.assertEqual(sorted(os.listdir(self.folder)), ["d" * 60, "out", "p.py", "set.json"])

    def test_names_that_look_alike_keep_folders_apart(self):
        a, b = os.path.join(self.folder, "a b.subject"), os.path.join(self.folder, "a_b.subject")
        for path in (a, b):
            self.subject_file(os.path.basename(path))
        self.run_certify("--subject", "a b.subject", "--subject", "a_b.subject", "--cases", "1",
                         "--scenes", self.scenes("duplicates"), cwd=self.folder)  # fmt: skip
        self.assertEqual({c["subject"]["name"] for c in self.certificates()},
                         {"a b.subject", "a_b.subject"})  # fmt: skip


class Pages(Certify):
    def links(self, path, page):
        """Where the links of a page lead, as paths below the output folder."""
        found = re.findall(r'(?:href|src)="([^"#]+)"', page)
        return [os.path.normpath(os.path.join(os.path.dirname(path), link)) for link in found]

    def test_a_survey_is_a_small_page_and_all_that_it_leads_to_is_there(self):
        done = self.run_certify("--all", "--cases", "1")
        self.assertEqual(done.returncode, 0, "fails on what states to be exact alone")
        verdicts = {c["subject"]["name"]: c["verdict"] for c in self.certificates()}
        self.assertEqual(verdicts["textbook"], "violated")
        self.assertEqual(verdicts["spans-exact"], "holds")
        pages = self.pages()
        self.assertEqual(len(pages), 1 + len(self.certificates()))
        self.assertLess(len(pages["report.html"].encode()), 400_000)
        for group in ("States exact coverage", "Naive, there to fail", "Homogeneous"):
            self.assertEqual(pages["report.html"].count(f"<strong>{group}</strong>"), 1)
        led_to = {"report.html"}
        for path, page in pages.items():
            self.assertLess(len(page.encode()), 1_000_000, path)
            for link in self.links(path, page):
                self.assertTrue(os.path.isfile(os.path.join(self.out, link)), f"{path}: {link}")
                led_to.add(link)
        self.assertLessEqual(set(pages), led_to, "every page is led to")
        files = [os.path.relpath(os.path.join(folder, name), self.out)
                 for folder, _, names in os.walk(self.out) for name in names]  # fmt: skip
        pictures = [name for name in files if name.endswith((".svg", ".png"))]
        self.assertTrue(pictures)
        self.assertLessEqual(set(pictures), led_to, "every picture is shown")
        self.assertEqual([name for name in files if name.endswith(".part")], [])

    def test_the_policy_of_a_page_names_its_script(self):
        self.certify("--subject", "spans-exact", "--cases", "1")
        for page in self.pages().values():
            (script,) = re.findall(r"<script>(.*?)</script>", page, re.DOTALL)
            digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
            self.assertEqual(re.findall("script-src 'sha256-([^']*)'", page), [digest])

    def test_commands_of_a_page_run_as_they_are_printed(self):
        name = "a 'b' $(c) <script>.subject"
        self.subject_file(name)
        self.run_certify("--subject", name, "--cases", "1", "--scenes", self.scenes("duplicates"),
                         cwd=self.folder)  # fmt: skip
        (page,) = list(self.pages().values())[1:]
        self.assertEqual(page.count("<script"), 1)
        commands = [html.unescape(re.sub("<[^>]*>", "", code))
                    for code in re.findall(r"<code>(.*?)</code>", page)]  # fmt: skip
        for command in commands:
            self.assertIn(name, shlex.split(command))
        replays = [command for command in commands if " replay " in command]
        self.assertTrue(replays)
        for command in replays:
            line = f"'{PROGRAM}' {command.removeprefix('rasterproof ')}"
            done = subprocess.run(line, shell=True, cwd=self.folder, capture_output=True,
                                  timeout=900, check=False)  # fmt: skip
            self.assertEqual(done.returncode, 1, line + done.stderr.decode())

    def test_a_page_that_can_not_be_written_leaves_no_part_of_it(self):
        self.certify("--subject", "textbook", "--cases", "1")
        before = self.pages()["report.html"]
        os.remove(os.path.join(self.out, "textbook", "report.html"))
        os.mkdir(os.path.join(self.out, "textbook", "report.html"))
        done = self.run_certify("--subject", "textbook", "--cases", "2", "--scenes",
                                self.scenes("ties"))  # fmt: skip
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertEqual(self.read(os.path.join(self.out, "report.html")).decode(), before)
        names = [name for _, _, names in os.walk(self.out) for name in names]
        self.assertEqual([name for name in names if name.endswith(".part")], [])


class Interrupts(Certify):
    def test_an_interrupted_run_writes_what_it_knows_and_says_so(self):
        fifo = os.path.join(self.folder, "asked")
        os.mkfifo(fifo)
        program = os.path.join(self.folder, "hangs.py")
        with open(program, "w", encoding="utf-8") as file:
            # It tells that it was asked, and never answers.
            file.write("import sys, signal\nsys.stdin.readline()\n"
                       f"open({fifo!r}, 'w').close()\nsignal.pause()\n")  # fmt: skip
        arguments = ["--subject", "spans-exact", "--exec", f"{sys.executable} {program}",
                     "--time-limit", "200", "--cases", "1", "--scenes", self.scenes("duplicates"),
                     "--out", self.out]  # fmt: skip
        with subprocess.Popen([PROGRAM, "certify", *arguments], cwd=SOURCES, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as running:  # fmt: skip
            with open(fifo, "rb") as asked:
                asked.read()
            running.send_signal(signal.SIGINT)
            stdout, stderr = running.communicate(timeout=900)
        self.assertEqual(running.returncode, 128 + signal.SIGINT, stderr)
        self.assertIn(b"interrupted: ", stdout)
        self.assertIn("The run was interrupted", self.pages()["report.html"])
        hung = [c for c in self.certificates() if c["subject"]["name"].startswith("exec:")][0]
        self.assertTrue(hung["interrupted"])
        self.assertEqual(hung["verdict"], "inconclusive")
        self.assertIn("interrupted", hung["reason"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[5:])
