"""The fixture `rasterproof_check`: check() that keeps what failed, and asks that first next time.

    def test_mine(rasterproof_check):
        rasterproof_check(draw, "vulkan")

Shrunk failures lie in .rasterproof/TEST below the root of the tests.
"""

import pathlib
import re

import pytest


@pytest.fixture
def rasterproof_check(request):
    from . import checking  # the library is loaded where a test asks for it

    name = re.sub(r"[^A-Za-z0-9._-]+", "-", request.node.nodeid).strip("-")
    folder = pathlib.Path(request.config.rootpath) / ".rasterproof" / name

    def check(draw, profile="real", cases=100, **options):
        folder.mkdir(parents=True, exist_ok=True)
        report = checking.check(draw, profile, cases, **({"save": folder} | options))
        if not report:
            pytest.fail(report.text, pytrace=False)
        return report

    return check
