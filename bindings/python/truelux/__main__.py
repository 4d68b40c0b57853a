# SPDX-License-Identifier: GPL-3.0-or-later
"""truelux over arrays: python3 -m truelux eval|gradient SCENE.obj RECEIVERS."""

from __future__ import annotations

import argparse
import sys
import warnings

import numpy as np

import truelux

from .tables import read_maps, read_receivers, write_arrays

_GRADIENT = ("gradient", "tangential", "normal", "vector", "jacobian", "sphere",
             "flux", "sphere_jacobian")

_DESCRIPTION = """\
The numbers of truelux eval and truelux gradient, over arrays.

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
"""


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
        command.add_argument("--normals", metavar="NORMALS.exr",
                             help="beside positions as EXR")
        command.add_argument("--on-face", metavar="N|NAME|auto|none",
                             help="as of truelux eval")
        command.add_argument("--method", default="certified",
                             choices=("certified", "double"))
        command.add_argument("--emission", default="exitance",
                             choices=("exitance", "radiance"))
        command.add_argument("--two-sided", action="store_true")
        command.add_argument("--lenient", action="store_true")
        command.add_argument("--threads", type=int)
        command.add_argument("--progress", action="store_true")
        if name == "gradient":
            command.add_argument("--of", default="gradient", metavar="NAMES",
                                 help=", ".join(_GRADIENT))
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


def _run(arguments) -> None:
    scene = truelux.Scene.read(arguments.scene, lenient=arguments.lenient,
                               two_sided=arguments.two_sided)
    oracle = truelux.Oracle(scene, method=arguments.method,
                            emission=arguments.emission,
                            threads=arguments.threads)
    covered = None
    if arguments.receivers.lower().endswith(".exr"):
        if arguments.normals is None:
            raise truelux.Error("a map of positions needs --normals")
        points, normals, covered = read_maps(arguments.receivers,
                                             arguments.normals)
        column = "auto"
    else:
        points, normals, column = read_receivers(arguments.receivers)
    on_face = _on_face(arguments.on_face, column)
    write_arrays(arguments.output,
                 _evaluate(oracle, arguments, points, normals, on_face), covered)


def main(words=None) -> int:
    """Exit status: 0, or 2 for bad input, 130 after Ctrl-C."""
    arguments = _parser().parse_args(words)
    warnings.showwarning = lambda message, *_, **__: print(message,
                                                           file=sys.stderr)
    try:
        _run(arguments)
    except (truelux.Error, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
