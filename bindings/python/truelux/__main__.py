# SPDX-License-Identifier: GPL-3.0-or-later
"""truelux over arrays: python3 -m truelux eval|compare|gradient SCENE.obj ..."""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path

import numpy as np

import truelux

from .arrays import error, faces, receivers, thread_count, triples
from .files import suffix_of, whole_file
from .tables import (VALUES, check_output, quantity_of, read_maps,
                     read_receivers, read_values, write_arrays)

_GRADIENT = ("gradient", "tangential", "normal", "vector", "jacobian", "sphere",
             "flux", "sphere_jacobian")

_DESCRIPTION = """\
The numbers of truelux eval, compare and gradient, over arrays.

RECEIVERS is one of
  .npy   shape (..., 6): points and normals
  .npz   arrays points and normals, (..., 3) each, perhaps on_face (...)
  .csv   columns x,y,z,nx,ny,nz, perhaps on_face, as truelux eval reads them
  .exr   a map of positions, with --normals a map of normals: texels whose normal
         is 0 are none; --on-face is auto unless it is given
and what is written one of
  .npy   E of eval, shape (..., 3)
  .npz   arrays by the names of truelux.Oracle's results
  .csv   one row per receiver, with the columns of truelux eval and gradient;
         of maps px and py, too
  .exr   E of eval, as binary32; A is 1 where there is a receiver
VALUES of compare are another program's, one per receiver: .npy (..., 3), .npz (an
array E), .csv (columns E_r,E_g,E_b) or, over maps, an .exr of their size; form
factors (...), F, F; gradients (..., 3, 3), gradient, grad_r_x .. grad_b_z.
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
    command.add_argument("--quantity", choices=tuple(VALUES),
                         help="without it gradients, if VALUES has arrays or "
                         "columns of theirs, else irradiance")
    command.add_argument("--tolerance", type=float, default=1e-6, metavar="T",
                         help="the largest relative error that passes "
                         "(%(default)s)")
    command.add_argument("--json", metavar="OUT.json",
                         help="the report as JSON, too")
    _add_common(command)
    return parser


def _check_words(arguments) -> None:
    """What can be known to be wrong before the work."""
    if arguments.command == "compare":
        if arguments.json is not None:
            suffix_of(arguments.json, ".json")
        return
    count = 2 if arguments.command == "eval" and arguments.method == "double" \
        else 1
    if arguments.command == "gradient":
        names = arguments.of.split(",")
        for name in names:
            if name not in _GRADIENT:
                raise error(f"--of: '{name}' is none of {', '.join(_GRADIENT)}")
        count = 2 + len(names)
    check_output(arguments.output, count)


def _evaluate(oracle, arguments, points, normals, on_face) -> dict:
    if arguments.command == "eval":
        e, bound = oracle.irradiance(points, normals, on_face=on_face,
                                     bound=True, progress=arguments.progress)
        if arguments.method == "double":
            return {"E": e, "bound": bound}
        return {"E": e}
    names = arguments.of.split(",")
    d = oracle.derivatives(
        points, normals, on_face=on_face,
        sphere=any("sphere" in n or n == "flux" for n in names),
        jacobian=any("jacobian" in n for n in names))
    return {"E": d.irradiance, "status": d.status,
            **{name: getattr(d, name) for name in names}}


def _face_numbers(scene, choice, points, normals, threads) -> np.ndarray:
    """Numbers for what --on-face or a column says, over the leading shape."""
    points, normals, shape = receivers(points, normals)
    if isinstance(choice, np.ndarray) and choice.dtype == object:  # by rows
        numbers = np.zeros(len(choice), dtype=np.int64)
        for cell in dict.fromkeys(choice):
            rows = choice == cell
            numbers[rows] = _face_numbers(scene, cell or None, points[rows],
                                          normals[rows], threads)
        return numbers
    numbers = faces(scene, choice, points, normals, shape, threads)
    return np.broadcast_to(numbers, points.shape[:1]).reshape(shape)


def _receivers(scene, arguments):
    """Points, normals, face numbers; and which texels of maps these are, with
    the maps' origin, or None."""
    covered = origin = None
    is_map = arguments.receivers.lower().endswith(".exr")
    if is_map != (arguments.normals is not None):
        raise error("a map of positions needs --normals" if is_map else
                    "--normals belongs to a map of positions")
    if is_map:
        points, normals, covered, origin = read_maps(arguments.receivers,
                                                     arguments.normals)
        column = "auto"
    else:
        points, normals, column = read_receivers(arguments.receivers)
    points, normals = triples(points, "points"), triples(normals, "normals")
    choice = column if arguments.on_face is None else arguments.on_face
    if isinstance(choice, str) and choice == "none":
        choice = None
    return (points, normals,
            _face_numbers(scene, choice, points, normals,
                          thread_count(arguments.threads)), covered, origin)


def _compare(scene, arguments) -> int:
    points, normals, on_face, covered, origin = _receivers(scene, arguments)
    quantity = arguments.quantity or quantity_of(arguments.values)
    is_rows = arguments.values.lower().endswith(".csv")
    values = read_values(arguments.values, quantity,
                         None if is_rows else covered, origin)
    if is_rows:  # one row per receiver, whatever their shape
        shape = np.broadcast_shapes(points.shape[:-1], normals.shape[:-1])
        if len(values) == np.prod(shape, dtype=int):
            values = values.reshape(shape + values.shape[1:])
    report = truelux.compare(
        scene, points, normals, values, quantity=quantity,
        tolerance=arguments.tolerance, emission=arguments.emission,
        on_face=on_face, threads=arguments.threads, progress=arguments.progress,
        name=Path(arguments.values).name)
    text = str(report)
    if covered is not None:
        rows, texels = np.nonzero(covered)
        text = report.text_with(
            lambda i: f"px {texels[i]}, py {rows[i]}")
    print(text, end="")
    if arguments.json is not None:
        with whole_file(arguments.json) as file:
            file.write(report.to_json().encode())
    return 0 if report.passes else 1


def _run(arguments) -> int:
    _check_words(arguments)
    scene = truelux.Scene.read(arguments.scene, lenient=arguments.lenient,
                               two_sided=arguments.two_sided)
    if arguments.command == "compare":
        return _compare(scene, arguments)
    oracle = truelux.Oracle(scene, method=arguments.method,
                            emission=arguments.emission,
                            threads=arguments.threads)
    points, normals, on_face, covered, _ = _receivers(scene, arguments)
    results = _evaluate(oracle, arguments, points, normals, on_face)
    shape = np.broadcast_shapes(points.shape[:-1], normals.shape[:-1]) + (3,)
    write_arrays(arguments.output,
                 (np.broadcast_to(points, shape),
                  np.broadcast_to(normals, shape), on_face.reshape(-1)),
                 results, covered)
    return 0


def main(words=None) -> int:
    """Exit status: as of _run, or 2 for bad input, 130 after Ctrl-C."""
    arguments = _parser().parse_args(words)
    warnings.showwarning = lambda message, *_, **__: print(message,
                                                           file=sys.stderr)
    try:
        return _run(arguments)
    except (truelux.Error, OSError) as defect:
        print(str(defect).encode("utf-8", "replace").decode(), file=sys.stderr)
        return 2
    except MemoryError:
        print("out of memory", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
