"""Each rasterizer that keeps within a set is violated under a set that does not allow what it does.

usage: sets_test.py PROGRAM SOURCES
A legal variant that nothing forbids would show nothing by passing.
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])

MESH = "EmbeddedMeshSamplesAreCoveredOnce"
MODEL = "CoverageEqualsTheModel"
JOINT = "OneLegalModelExplainsTheMesh"
MOVED = "IntegerTranslationMovesCoverage"
PIXEL = "SamplesLieInTheirPixel"
NONE = "NonFiniteTrianglesCoverNothing"
CENTROID = "CentroidsLieWhereStated"
MUST = "SquaresThatMustBeAreCovered"
MAY = "SquaresOutsideTheMayRegionStayFree"
# As d3d11-canonical, and infinities must cover nothing.
NO_INFINITIES = {"name": "no-infinities", "subpixel_bits": 8, "infinite_vertex": "nothing"}
# Sound twins of a mutant: no set forbids them.
TWINS = {"vulkan-kept-by-all", "vulkan-fragments-snapped", "vulkan-fragments-given",
         "vulkan-fragments-unstated", "gl-fragments-unstated", "vulkan-refuses-non-finite",
         "gl-refuses-non-finite", "vulkan-far", "d3d11-values", "d3d11-values-4x", "gl-values",
         "gl-values-4x", "vulkan-values", "vulkan-values-snapped", "webgpu-values"}  # fmt: skip
# variant: the set that forbids it, the property that finds it, and in how many cases at most
FORBIDDEN = {
    "vulkan-4-bits": ("d3d11", JOINT, 60),
    "vulkan-4-bits-floor": ("d3d11", JOINT, 60),
    "vulkan-5-bits-truncate": ("d3d11", JOINT, 60),
    "vulkan-8-bits-ceiling": ("d3d11", JOINT, 60),
    "vulkan-owner-by-edge": ("d3d11", JOINT, 60),
    "vulkan-owner-by-sample": ("gl", MOVED, 60),
    "vulkan-owner-by-tile": ("gl", MOVED, 60),
    "vulkan-flat-drawn": ("d3d11", JOINT, 60),
    "vulkan-infinite-clamped": (NO_INFINITIES, NONE, 60),
    "vulkan-nan-drawn": ("d3d11", NONE, 60),
    "vulkan-clipped-moves": ("vulkan-canonical", MODEL, 60),
    "vulkan-farthest-counts": ("d3d11", JOINT, 60),
    "vulkan-farthest-mask": ("d3d11", JOINT, 60),
    "vulkan-farthest-ids": ("d3d11", JOINT, 60),
    "gl-4-bits-floor": ("d3d11", JOINT, 60),
    "gl-owner-by-direction": ("d3d11", JOINT, 60),
    "gl-bottom-right": ("d3d11", JOINT, 60),
    "d3d11-nearest-away": ("d3d11-canonical", MODEL, 1000),
    "d3d11-rounds-above-0.4": ("d3d11-canonical", MODEL, 60),
    "d3d11-farthest": ("d3d11-canonical", MODEL, 60),
    "d3d11-infinite-clamped": (NO_INFINITIES, NONE, 60),
    "gl-bits-by-viewport": ("gl-canonical", MODEL, 200),
    "vulkan-bits-by-viewport": ("vulkan-canonical", MODEL, 200),
    "vulkan-rounds-by-axis": ("d3d11", JOINT, 60),
    "webgpu-inclusive": ("vulkan", JOINT, 60),
    "webgpu-exclusive": ("vulkan", JOINT, 60),
    "webgpu-owner-by-indices": ("vulkan", JOINT, 60),
    "webgpu-whole-pixels": ("vulkan", JOINT, 60),
    "vulkan-17-bits": ("d3d11", JOINT, 100),
    "vulkan-23-bits": ("d3d11", JOINT, 100),
    "vulkan-facing-4-bits": ("vulkan-canonical", MODEL, 200),
    "gl-far-rounds-down": ("d3d11", JOINT, 60),
    "vulkan-far-clips": ("vulkan-canonical", MODEL, 200),
    "vulkan-facing-of-input": ("vulkan-canonical", MODEL, 200),
    "vulkan-facing-clipped": ("vulkan-canonical", MODEL, 200),
    "vulkan-facing-exchanged": ("vulkan-canonical", MODEL, 200),
    "vulkan-clips-to-target": ("vulkan-canonical", MODEL, 200),
    "vulkan-clips-64-beyond": ("vulkan-canonical", MODEL, 200),
    "gl-clips-to-target": ("gl-canonical", MODEL, 200),
    "gl-clips-64-beyond": ("gl-canonical", MODEL, 200),
    "d3d11-facing-clipped": ("d3d11-canonical", MODEL, 200),
    "d3d11-facing-exchanged": ("d3d11-canonical", MODEL, 200),
    "d3d11-clamps-to-range": ("d3d11-canonical", MODEL, 200),
    "d3d11-snap-by-turns": ("d3d11-canonical", MODEL, 200),
    "d3d11-snap-by-call": ("d3d11-canonical", MODEL, 200),
    "d3d11-clips-to-target": ("d3d11-canonical", MODEL, 200),
    "d3d11-clips-64-beyond": ("d3d11-canonical", MODEL, 200),
    "webgpu-facing-exchanged": ("vulkan-canonical", MODEL, 200),
    "webgpu-grid-by-call": ("vulkan-canonical", MODEL, 200),
    "webgpu-owner-by-number": ("vulkan-canonical", MODEL, 200),
    "free-farthest": ("vulkan-canonical", MODEL, 60),
    "free-towards": ("vulkan-canonical", MODEL, 60),
    "free-anyhow": ("d3d11", JOINT, 60),
    "free-crosswise": ("d3d11", JOINT, 60),
    "free-away": ("d3d11", JOINT, 60),
    "free-onto-samples": ("vulkan-canonical", MODEL, 60),
    "free-ties": ("d3d11", JOINT, 60),
    "free-whole-pixels": ("vulkan", JOINT, 60),
    "private-farthest": ("vulkan", JOINT, 60),
    "private-pixels": ("vulkan", JOINT, 60),
    "private-of-stated": ("d3d11", JOINT, 60),
    "private-closed": ("vulkan", JOINT, 60),
    "samples-standard-8": ("d3d11-4x", JOINT, 60),
    "samples-mirrored-under-gl": ("vulkan-standard-4x", JOINT, 60),
    "samples-in-corners": ("vulkan-standard-4x", JOINT, 60),
    "samples-vary-under-gl": ("d3d11-4x", JOINT, 60),
    "samples-centre-under-vulkan": ("vulkan-standard-4x", JOINT, 60),
    "samples-on-far-borders": ("vulkan-standard-4x", JOINT, 60),
    "samples-vary-under-vulkan": ("vulkan-standard-4x", JOINT, 60),
    "samples-outside-under-gl": ("vulkan-4x", PIXEL, 60),
    "vulkan-centroid-nearest": ("d3d11-4x", CENTROID, 60),
    "vulkan-centroid-corner": ("d3d11-8x", CENTROID, 60),
    "gl-centroid-first-covered": ("d3d11-4x", CENTROID, 60),
    "gl-centroid-mean": ("d3d11-8x", CENTROID, 60),
    "webgpu-centroid-middle": ("d3d11-4x", CENTROID, 60),
    "squares-voxel": ("pdf-fill", MAY, 100),
    "squares-voxel-mask": ("pdf-fill", MAY, 100),
    "squares-pdf-inside": ("gdal-all-touched", MAY, 100),
    "squares-pdf-boundary": ("gdal-all-touched", MAY, 100),
    "squares-gdal-inside": ("voxel", MUST, 100),
    "squares-gdal-least": ("d3d12-conservative-2", MUST, 100),
    "squares-gdal-most": ("d3d12-conservative-2", MAY, 100),
    "squares-tier-1-least": ("d3d12-conservative-2", MUST, 100),
    "squares-tier-1-most": ("d3d12-conservative-2", MAY, 100),
    "squares-tier-2-least": ("voxel", MUST, 100),
    "squares-tier-2-minimum": ("voxel", MAY, 100),
    "squares-tier-2-most": ("voxel", MAY, 100),
    "squares-tier-3-most": ("voxel", MAY, 100),
    "squares-inner-most": ("d3d12-conservative-3", MUST, 100),
    "squares-inner-least": ("d3d12-conservative-3", MUST, 100),
    "squares-overestimate-least": ("d3d12-conservative-1", MUST, 100),
    "squares-overestimate-grown": ("d3d12-conservative-1", MAY, 100),
    "squares-overestimate-box": ("d3d12-conservative-1", MAY, 100),
    "squares-underestimate-most": ("d3d12-inner", MAY, 100),
    "squares-underestimate-less": ("d3d12-inner", MUST, 100),
}


def run(*arguments):
    if arguments[:1] == ("check",):  # explaining takes longer than finding: causes_test.py has it
        arguments += ("--no-cause",)
    result = subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            cwd=SOURCES, timeout=900, text=True)  # fmt: skip
    return result.returncode, result.stdout, result.stderr


class SetsTest(unittest.TestCase):
    def test_every_variant_of_a_set_is_in_the_table(self):
        named = {
            word.removeprefix("legal:")
            for word in run("list", "mutants")[1].split()
            if word.startswith("legal:")
        }
        self.assertLessEqual(FORBIDDEN.keys(), named)
        of_sets = ("vulkan-", "gl-", "d3d11-", "webgpu-", "squares-")
        self.assertEqual({name for name in named if name.startswith(of_sets)} - FORBIDDEN.keys(),
                         TWINS)  # fmt: skip

    def test_each_is_violated_where_it_is_forbidden(self):
        with tempfile.TemporaryDirectory() as folder:
            for variant, (profile, found_by, cases) in FORBIDDEN.items():
                if not isinstance(profile, str):
                    file = os.path.join(folder, "profile.json")
                    with open(file, "w") as out:
                        json.dump(profile, out)
                    profile = file
                status, text, error = run("check", "--subject", "legal:" + variant, "--profile",
                                          profile, "--property", found_by, "--cases",
                                          str(cases))  # fmt: skip
                with self.subTest(variant):
                    self.assertEqual(status, 1, text + error)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
