# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package for pip; docs/python.md.

TRUELUX_BUILD=FOLDER takes the module that CMake has built in FOLDER instead of
building all anew.
"""

import os
import re
from pathlib import Path

ROOT = Path(__file__).parent
VERSION = re.search(r'TRUELUX_VERSION_STRING "([^"]+)"',
                    (ROOT / "include/truelux/version.h").read_text())[1]

ARGUMENTS = {
    "name": "truelux",
    "version": VERSION,
    "description": "Exact irradiance from uniformly emitting polygons that "
                   "hide each other",
    "license": "GPL-3.0-or-later",
    "packages": ["truelux"],
    "package_dir": {"truelux": "bindings/python/truelux"},
    "package_data": {"truelux": ["py.typed", "*.pyi", "_truelux*.so"]},
    "python_requires": ">=3.9",
    "install_requires": ["numpy"],
    "zip_safe": False,
}


def setup_from(folder: Path) -> None:
    """With the module of a build folder."""
    from setuptools import Distribution, setup
    from setuptools.command.build_py import build_py

    module, = (folder / "python/truelux").glob("_truelux*.so")

    class WithModule(build_py):
        def run(self):
            super().run()
            self.copy_file(module,
                           os.path.join(self.build_lib, "truelux", module.name))

    class OfThisPlatform(Distribution):
        def has_ext_modules(self):
            return True

    setup(cmdclass={"build_py": WithModule}, distclass=OfThisPlatform,
          **ARGUMENTS)


def setup_anew() -> None:
    """By CMake, the module alone."""
    from skbuild import setup

    setup(cmake_args=["-DCMAKE_BUILD_TYPE=Release", "-DTRUELUX_BUILD_PYTHON=ON",
                      "-DTRUELUX_BUILD_PROGRAM=OFF",
                      "-DTRUELUX_BUILD_TESTS=OFF",
                      "-DTRUELUX_BUILD_EXAMPLES=OFF",
                      "-DTRUELUX_PYTHON_DIR=bindings/python"],
          cmake_install_target="install_python", **ARGUMENTS)


if os.environ.get("TRUELUX_BUILD"):
    setup_from(Path(os.environ["TRUELUX_BUILD"]))
else:
    setup_anew()
