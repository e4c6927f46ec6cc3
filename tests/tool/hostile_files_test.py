"""Files that are built to crash the command, to exhaust it, to stop it or to speak to the terminal.

usage: hostile_files_test.py PROGRAM
"""
import concurrent.futures
import json
import os
import resource
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PROGRAM = os.path.abspath(sys.argv[1])
CONTROLS = "\x1b[31m\x07\u009b1m"  # a colour, a bell, and the sequence begun by one character
CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
OFF = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"
PLY = ("ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
       "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n")
TRIANGLE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
MOST_SECONDS = 10
MOST_KIBIBYTES = 1 << 20


def png(width, height):
    def chunk(kind, data):
        checked = kind + data
        return struct.pack(">I", len(data)) + checked + struct.pack(">I", zlib.crc32(checked))
    return (b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", b"\x78\x9c") + chunk(b"IEND", b""))


def gltf(nodes, indices=(0, 1, 2), buffer="triangle.bin"):
    """One triangle in the last node; indices and then positions lie in the buffer."""
    count = len(indices)
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": nodes + [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": count, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 2 * count, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 0, "byteLength": 2 * count}],
        "buffers": [{"byteLength": 36 + 2 * count, "uri": buffer}]})


def scene(name="plain"):
    return json.dumps({"rasterproof_scene": 1, "name": name, "width": 4, "height": 4,
                       "vertices": [[0, 0], [4, 0], [0, 4]], "triangles": [[0, 1, 2]]})


class HostileFilesTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def run_bounded(self, *arguments):
        """Runs the command and holds what it took, its children included, to the bounds."""
        def seconds():
            used = resource.getrusage(resource.RUSAGE_CHILDREN)
            return used.ru_utime + used.ru_stime
        before = seconds()
        result = subprocess.run([PROGRAM, *arguments], stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                cwd=self.folder.name, timeout=900)
        self.assertLess(seconds() - before, MOST_SECONDS, arguments)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, MOST_KIBIBYTES,
                        arguments)
        return result

    def refused(self, place, *arguments):
        result = self.run_bounded(*arguments)
        message = result.stderr.decode()
        self.assertEqual(result.returncode, 2, (arguments, message))
        self.assertRegex(message, r"^rasterproof: .*; .*\n$")
        self.assertIn(os.path.basename(place), message)
        self.assertNotIn("std::", message)
        return message

    def test_meshes_are_refused_in_bounds(self):
        self.write("triangle.bin", struct.pack("<3H", 0, 1, 2) + TRIANGLE)
        chain = [{"children": [k + 1]} for k in range(200000)]
        dag = [{"children": [k + 1, k + 1]} for k in range(40)]
        short_glb = b"glTF" + struct.pack("<III", 2, 22, 0xFFFFFFF0) + b"JSON{}"
        long_list = PLY.format("binary_little_endian", 3, 1).replace("uchar", "uint").encode()
        for name, content in [
                ("deep.gltf", gltf(chain)), ("dag.gltf", gltf(dag)),
                ("arrays.gltf", "[" * 1000000), ("short.glb", short_glb),
                ("faces.ply", PLY.format("ascii", 3, 4000000000)
                 + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                ("faces_b.ply", PLY.format("binary_little_endian", 3, 4000000000).encode()
                 + TRIANGLE + struct.pack("<B3i", 3, 0, 1, 2)),
                ("list.ply", long_list + TRIANGLE + struct.pack("<I3i", 0xFFFFFFF0, 0, 1, 2)),
                ("many.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"),
                ("cycle.gltf", gltf([{"children": [0]}]))]:
            path = self.write(name, content)
            self.refused(path, "coverage", path, "--width", "64", "--height", "64")

    def test_a_vertex_that_is_not_there_is_named(self):
        self.write("triangle.bin", struct.pack("<6H", 0, 1, 2, 0, 1, 9) + TRIANGLE)
        self.write("alone.bin", struct.pack("<3H", 0, 1, 9) + TRIANGLE)
        ply = PLY.format("ascii", 3, 1) + "0 0 0\n1 0 0\n0 1 0\n"
        for name, content in [
                ("beyond.off", OFF + "3 0 1 3\n"), ("sign.off", OFF + "3 0 1 -1\n"),
                ("wraps.off", OFF + "3 0 1 4294967298\n"),
                ("beyond.obj", CORNERS + "f 1 2 3\nf 1 2 4\n"),
                ("sign.obj", CORNERS + "f 1 2 -4\n"),
                ("beyond.ply", ply + "3 0 1 3\n"), ("sign.ply", ply + "3 0 1 -1\n"),
                ("beyond.gltf", gltf([], (0, 1, 2, 0, 1, 9))),
                ("alone.gltf", gltf([], (0, 1, 9), "alone.bin"))]:
            path = self.write(name, content)
            message = self.refused(path, "coverage", path, "--png", self.path("picture.png"))
            self.assertRegex(message, "names? (a )?(missing )?vertex", name)
            self.assertFalse(os.path.exists(self.path("picture.png")))

    def test_parts_of_an_obj_by_the_hundred_thousand_are_read(self):
        for name, line in [("groups.obj", "g g{0}\n"), ("objects.obj", "o o{0}\n"),
                           ("materials.obj", "g {1}{0}\nusemtl {1}{0}\n")]:
            parts = (line.format(k, "m" * 200) + "f 1 2 3\n" for k in range(100000))
            path = self.write(name, CORNERS + "".join(parts))
            result = self.run_bounded("coverage", path, "--width", "8", "--height", "8")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn(b"100000", result.stdout)

    def test_pipes_without_a_writer_and_devices_are_refused(self):
        os.mkfifo(self.path("pipe"))
        plain = self.write("plain.json", scene())
        for ending in ("json", "obj", "png"):
            os.symlink(self.path("pipe"), self.path("pipe." + ending))
            os.symlink("/dev/zero", self.path("zero." + ending))
        calls = []
        for kind in ("pipe", "zero"):
            scene_file, mesh, picture = (self.path(f"{kind}.{e}") for e in ("json", "obj", "png"))
            calls += [(path, verb, path) for path in (scene_file, mesh)
                      for verb in ("coverage", "plan")]  # fmt: skip
            calls += [(kind, "legal", plain, picture, "--profile", "vulkan"),
                      (kind, "check", "--subject", "textbook", "--profile", scene_file),
                      (kind, "certify", "--subject", "textbook", "--cases", "1", "--scenes",
                       scene_file, "--out", self.path("out"))]  # fmt: skip
        # Each waits for a writer, for seconds.
        with concurrent.futures.ThreadPoolExecutor(len(calls)) as pool:
            list(pool.map(lambda call: self.refused(*call), calls))

    def test_files_that_a_mesh_names_are_opened_only_if_they_are_files(self):
        os.mkfifo(self.path("pipe"))
        for buffer in ("pipe", "/dev/zero"):
            path = self.write("names.gltf", gltf([], buffer=buffer))
            self.refused(path, "coverage", path)
            path = self.write("names.obj", f"mtllib {buffer}\n" + CORNERS + "f 1 2 3\n")
            self.assertEqual(self.run_bounded("coverage", path).returncode, 0)

    def test_json_nested_without_end_and_a_picture_of_gigabytes_are_refused(self):
        plain = self.write("plain.json", scene())
        for name, content in [("arrays.json", "[" * 1000000), ("objects.json", '{"a":' * 1000000)]:
            path = self.write(name, content)
            self.refused(path, "coverage", path)
            self.refused(path, "check", "--subject", "textbook", "--profile", path)
            self.refused(path, "certify", "--subject", "textbook", "--cases", "1", "--scenes", path,
                         "--out", self.path("out"))
        picture = self.write("large.png", png(65000, 65000))
        self.assertEqual(os.path.getsize(picture), 59)
        message = self.refused(picture, "legal", plain, picture, "--profile", "vulkan")
        self.assertIn("65000 x 65000", message)

    def test_no_name_speaks_to_the_terminal(self):
        named = self.write("named.json", scene("evil" + CONTROLS))
        clip = json.loads(scene("evil" + CONTROLS))
        clip["vertices"] = [vertex + [0, 1] for vertex in clip["vertices"]]
        clip = self.write("clip.json", json.dumps(clip))
        profile = self.write("profile.json", json.dumps(
            {"name": "evil" + CONTROLS, "subpixel_bits": 4, "snap_rule": "nearest-even"}))
        scenes = self.write("scenes.json", json.dumps({"rasterproof_scene_set": 1, "scenes": [
            {"name": "evil" + CONTROLS, "kind": "hard", "path": "named.json"}]}))
        self.assertEqual(self.run_bounded("plan", named).returncode, 0)
        for arguments in [
                ("plan", named, "--profile", profile), ("coverage", named, "--profile", profile),
                ("explain", named, "--subject", "textbook", "--pixel", "3,0"),
                ("explain", clip, "--subject", "textbook", "--pixel", "3,0"),
                ("replay", named, "--subject", "textbook"),
                ("replay", named, "--subject", "textbook", "--shrink", self.path("small.json")),
                ("coverage", named, "--against", "textbook", "--profile", profile),
                ("legal", named, "--subject", "textbook", "--profile", profile),
                ("legal", named, "--decided", "--profile", profile),
                ("check", named, "--subject", "textbook", "--profile", profile),
                ("check", "--subject", "textbook", "--profile", profile, "--cases", "2",
                 "--no-cause"),
                ("certify", "--subject", "textbook", "--cases", "1", "--scenes", scenes, "--out",
                 self.path("out"))]:
            result = self.run_bounded(*arguments)
            self.assertNotEqual(result.returncode, 3, result.stderr)
            printed = (result.stdout + result.stderr).decode()
            self.assertNotRegex(printed, "[\x00-\x09\x0b-\x1f\x7f-\x9f]", arguments)

    def test_a_profile_from_a_pipe_with_a_writer_is_read_once_for_all_workers(self):
        profile = self.write("profile.json", json.dumps(
            {"name": "mine", "subpixel_bits": 8, "snap_rule": "nearest-even"}))
        result = subprocess.run(
            ["bash", "-c",
             '"$0" check --subject i64-snap8 --cases 5 --jobs 2 --profile <(cat "$1")',
             PROGRAM, profile], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=900)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
