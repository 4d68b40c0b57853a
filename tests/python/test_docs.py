# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference made of the docstrings, opened in Chromium without a window."""

import html
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import truelux

PAGE = Path(os.environ.get("TRUELUX_DOCS", "")) / "index.html"
BROWSER = next(filter(None, map(shutil.which, (
    "chromium", "chromium-browser", "google-chrome"))), None)

if not PAGE.is_file():
    pytest.skip("Sphinx is not installed: there is no page", allow_module_level=True)
if BROWSER is None:
    pytest.skip("no Chromium found, the page was not opened",
                allow_module_level=True)


def browse(folder, *options):
    return subprocess.run(
        ["timeout", "50", BROWSER, "--headless", "--no-sandbox",
         "--disable-gpu", "--disable-dev-shm-usage",
         f"--user-data-dir={folder}/profile", *options, PAGE.as_uri()],
        capture_output=True, check=True).stdout.decode()


def test_everything_public_has_its_place(tmp_path):
    dom = browse(tmp_path, "--dump-dom")
    for name in truelux.__all__:
        assert f'id="truelux.{name}"' in dom, name
    text = html.unescape(re.sub("<[^>]*>", "", dom))
    for words in ("irradiance(points, normals, *, on_face=None",
                  "truelux.compare(scene, points, normals, values",
                  "truelux.render(oracle, *, surface=None",
                  "A pinhole camera", "W/m^2"):
        assert words in text, words
    # Nothing is fetched from elsewhere.
    assert not re.findall(r'(?:src|href)="https?://[^"]*\.(?:js|css)', dom)


def test_there_is_something_to_see(tmp_path):
    picture = tmp_path / "page.png"
    browse(tmp_path, f"--screenshot={picture}", "--window-size=1000,1400")
    assert picture.stat().st_size > 20_000
