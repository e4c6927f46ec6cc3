"""A case that is printed as code holds the case, bit by bit, in every language.

usage: case_code_test.py PROGRAM COMPILER
"""
import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM, COMPILER = (os.path.abspath(path) for path in sys.argv[1:3])
LANGUAGES = ("cpp", "python", "typescript", "readmemh")


def scene(vertices, precision="float32", **more):
    return json.dumps({"rasterproof_scene": 1, "width": 5, "height": 3,
                       "precision": precision, "vertices": vertices,
                       "triangles": [[0, 1, 2], [2, 1, 0]], **more})  # fmt: skip


def printed(given, language, *arguments):
    ran = subprocess.run([PROGRAM, "replay", given, "--as", language, *arguments],
                         capture_output=True, text=True, check=False)  # fmt: skip
    assert ran.returncode in (0, 1, 4), ran.stderr
    return ran.stdout


def read_cpp(code, width):
    kind = re.search(r"constexpr (\S+) kVertices", code)[1]
    program = (
        "#include <cmath>\n#include <cstdint>\n#include <cstdio>\n" + code +
        "int main() { for (auto& v : kVertices) for (auto x : v) "
        + ('std::printf("%lld\\n", static_cast<long long>(x));' if "int" in kind
           else 'std::printf("%a\\n", static_cast<double>(x));')
        + ' std::printf("%d %d %d\\n", kWidth, kHeight, kTriangles[1][0]); }'
    )  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        source, binary = os.path.join(folder, "a.cc"), os.path.join(folder, "a")
        with open(source, "w", encoding="utf-8") as file:
            file.write(program)
        subprocess.run([COMPILER, "-std=c++17", source, "-o", binary], check=True)
        *numbers, rest = subprocess.run([binary], capture_output=True, text=True,
                                        check=True).stdout.splitlines()  # fmt: skip
    read = int if "int" in kind else float.fromhex
    return [read(n) for n in numbers], [int(n) for n in rest.split()]


def read_python(code, width):
    names = {}
    exec(code, names)
    return ([x for v in names["vertices"] for x in v],
            [names["width"], names["height"], names["triangles"][1][0]])  # fmt: skip


def read_typescript(code, width):
    found = {name: json.loads(re.sub(r",(\s*\])", r"\1", value), parse_int=float)
             for name, value in
             re.findall(r"const (\w+)[^=]* = (.*?);\n", code, re.DOTALL)}  # fmt: skip
    return ([x for v in found["vertices"] for x in v],
            [found["width"], found["height"], found["triangles"][1][0]])  # fmt: skip


def read_readmemh(code, width):
    words = [w for line in code.splitlines() if not line.startswith("//") for w in line.split()]
    coordinates = words[4:4 + 3 * width]

    def number(word):
        if "as integers" in code:
            return struct.unpack(">i" if len(word) == 8 else ">q", bytes.fromhex(word))[0]
        return struct.unpack(">f" if len(word) == 8 else ">d", bytes.fromhex(word))[0]

    return ([number(w) for w in coordinates],
            [int(words[0], 16), int(words[1], 16), int(words[4 + 3 * width + 3], 16)])  # fmt: skip


READERS = dict(zip(LANGUAGES, (read_cpp, read_python, read_typescript, read_readmemh)))


class CaseCode(unittest.TestCase):
    def assert_holds(self, given, expected, *arguments, width=2):
        for language in LANGUAGES:
            with self.subTest(language):
                code = printed(given, language, *arguments)
                numbers, rest = READERS[language](code, width)
                same = [math.copysign(1, a) == math.copysign(1, b) and a == b
                        for a, b in zip(numbers, expected, strict=True)]  # fmt: skip
                self.assertTrue(all(same), code)
                self.assertEqual(rest, [5, 3, 2], code)

    def test_float32_and_float64_coordinates_are_the_same_bits(self):
        exact = [0.1, -0.0, 1e-40, 3.3333333, 2.5, 1e30]
        near = [struct.unpack("f", struct.pack("f", x))[0] for x in exact]
        self.assert_holds(scene([near[0:2], near[2:4], near[4:6]]), near, "--subject", "f32-direct")
        self.assert_holds(scene([exact[0:2], exact[2:4], exact[4:6]], "float64"), exact,
                          "--subject", "f64-direct")  # fmt: skip

    def test_clip_space_has_four_coordinates(self):
        vertices = [[0.5, 1, 0, 1], [2, 2.25, 0.5, 2], [-1, 3, 0.25, -4]]
        self.assert_holds(scene(vertices, "float64"), sum(vertices, []),
                          "--subject", "hom-f64", width=4)  # fmt: skip

    def test_fixed_point_input_has_its_own_units(self):
        self.assert_holds(scene([[0, -1.5], [2047.9375, 0.0625], [3, 4]]),
                          [0, -24, 32767, 1, 48, 64],
                          "--subject", "mutant:width-values-32")  # fmt: skip

    def test_what_is_no_number_is_written_as_the_language_does(self):
        given = scene([["nan", 1], ["-inf", 2], ["inf", 3]])
        words = {"cpp": ("{NAN, 0x1p+0F}", "{-INFINITY, ", "{INFINITY, "),
                 "python": ('(float("nan"), 1.0)', '(-float("inf"), ', '(float("inf"), '),
                 "typescript": ("[NaN, 1]", "[-Infinity, ", "[Infinity, "),
                 "readmemh": ("7fc00000 3f800000", "ff800000 ", "7f800000 ")}  # fmt: skip
        for language, expected in words.items():
            code = printed(given, language, "--subject", "f32-direct")
            for word in expected:
                self.assertIn(word, code)

    def test_pictures_and_unknown_languages_are_refused(self):
        for arguments in (("--as", "rust"), ("--as", "cpp", "--svg", "a.svg")):
            ran = subprocess.run([PROGRAM, "explain", "--subject", "f32-direct", *arguments,
                                  scene([[0, 0], [1, 0], [0, 1]])],
                                 capture_output=True, text=True, check=False)  # fmt: skip
            self.assertEqual(ran.returncode, 2, ran.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
