# SPDX-License-Identifier: GPL-3.0-or-later
"""truelux over arrays: python3 -m truelux eval|compare|gradient SCENE.obj ..."""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path

import numpy as np

import truelux

from .files import whole_file
from .tables import read_maps, read_receivers, read_values, write_arrays

_GRADIENT = ("gradient", "tangential", "normal", "vector", "jacobian", "sphere",
             "flux", "sphere_jacobian")

_DESCRIPTION = """\
The numbers of truelux eval, compare and gradient, over arrays.

RECEIVERS is one of
  .npy   shape (..., 6): points and normals
  .npz   arrays points and normals, (..., 3) each, perhaps on_face (...)
  .csv   columns x,y,z,nx,ny,nz, perhaps on_face
  .exr   a map of positions, with --normals a map of normals: texels whose normal
         is 0 are none; --on-face is auto unless it is given
and what is written one of
  .npy   E of eval, shape (..., 3)
  .npz   arrays by the names of truelux.Oracle's results
  .csv   one row per receiver
  .exr   E of eval, as binary32; A is 1 where there is a receiver
VALUES of compare is E of another program, one per receiver: .npy (..., 3), .npz
(an array E), .csv (columns E_r,E_g,E_b) or, over maps, an .exr of their size.
"""


def _add_common(command: argparse.ArgumentParser) -> None:
    command.add_argument("--normals", metavar="NORMALS.exr",
                         help="beside positions as EXR")
    command.add_argument("--on-face", metavar="N|NAME|auto|none",
                         help="as of truelux eval")
    command.add_argument("--emission", default="exitance",
                         choices=("exitance", "radiance"))
    command.add_argument("--two-sided", action="store_true")
    command.add_argument("--lenient", action="store_true")
    command.add_argument("--threads", type=int)
    command.add_argument("--progress", action="store_true")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python3 -m truelux", description=_DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", action="version",
                        version=truelux.__version__)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, text in (("eval", "the irradiance"),
                       ("gradient", "the irradiance and its derivatives")):
        command = commands.add_parser(name, help=text)
        command.add_argument("scene", metavar="SCENE.obj")
        command.add_argument("receivers", metavar="RECEIVERS")
        command.add_argument("-o", "--output", required=True, metavar="OUT")
        command.add_argument("--method", default="certified",
                             choices=("certified", "double"))
        _add_common(command)
        if name == "gradient":
            command.add_argument("--of", default="gradient", metavar="NAMES",
                                 help=", ".join(_GRADIENT))
    command = commands.add_parser(
        "compare", help="another program's irradiances beside the truth",
        description="Prints the report of truelux compare. Exit status: 0 if "
        "every receiver passes, 1 if not.")
    command.add_argument("scene", metavar="SCENE.obj")
    command.add_argument("receivers", metavar="RECEIVERS")
    command.add_argument("values", metavar="VALUES")
    command.add_argument("--tolerance", type=float, default=1e-6, metavar="T",
                         help="the largest relative error that passes "
                         "(%(default)s)")
    command.add_argument("--json", metavar="OUT.json",
                         help="the report as JSON, too")
    _add_common(command)
    return parser


def _on_face(word, column):
    if word is None:
        return column
    if word == "none":
        return None
    return int(word) if word.isdigit() else word


def _evaluate(oracle, arguments, points, normals, on_face) -> dict:
    if arguments.command == "eval":
        e, bound = oracle.irradiance(points, normals, on_face=on_face,
                                     bound=True, progress=arguments.progress)
        if arguments.method == "double":
            return {"E": e, "bound": bound}
        return {"E": e}
    names = arguments.of.split(",")
    for name in names:
        if name not in _GRADIENT:
            raise truelux.Error(f"--of: '{name}' is none of "
                                f"{', '.join(_GRADIENT)}")
    d = oracle.derivatives(
        points, normals, on_face=on_face,
        sphere=any("sphere" in n or n == "flux" for n in names),
        jacobian=any("jacobian" in n for n in names))
    return {"E": d.irradiance, "status": d.status,
            **{name: getattr(d, name) for name in names}}


def _receivers(arguments):
    """Points, normals, faces, and which texels of maps these are, or None."""
    covered = None
    if arguments.receivers.lower().endswith(".exr"):
        if arguments.normals is None:
            raise truelux.Error("a map of positions needs --normals")
        points, normals, covered = read_maps(arguments.receivers,
                                             arguments.normals)
        column = "auto"
    else:
        points, normals, column = read_receivers(arguments.receivers)
    return points, normals, _on_face(arguments.on_face, column), covered


def _compare(scene, arguments) -> int:
    points, normals, on_face, covered = _receivers(arguments)
    report = truelux.compare(
        scene, points, normals, read_values(arguments.values, covered),
        tolerance=arguments.tolerance, emission=arguments.emission,
        on_face=on_face, threads=arguments.threads, progress=arguments.progress,
        name=Path(arguments.values).name)
    print(report, end="")
    if arguments.json is not None:
        with whole_file(arguments.json) as file:
            file.write(report.to_json().encode())
    return 0 if report.passes else 1


def _run(arguments) -> int:
    scene = truelux.Scene.read(arguments.scene, lenient=arguments.lenient,
                               two_sided=arguments.two_sided)
    if arguments.command == "compare":
        return _compare(scene, arguments)
    oracle = truelux.Oracle(scene, method=arguments.method,
                            emission=arguments.emission,
                            threads=arguments.threads)
    points, normals, on_face, covered = _receivers(arguments)
    write_arrays(arguments.output,
                 _evaluate(oracle, arguments, points, normals, on_face), covered)
    return 0


def main(words=None) -> int:
    """Exit status: as of _run, or 2 for bad input, 130 after Ctrl-C."""
    arguments = _parser().parse_args(words)
    warnings.showwarning = lambda message, *_, **__: print(message,
                                                           file=sys.stderr)
    try:
        return _run(arguments)
    except (truelux.Error, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
