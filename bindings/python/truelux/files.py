# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that appear whole or not at all."""

from __future__ import annotations

import contextlib
import os
import secrets
from typing import BinaryIO, Iterator

from .arrays import error


def suffix_of(path, *known: str) -> str:
    """The ending of a name, small; an error if it is none of these, or if there
    is no such folder."""
    try:
        name = os.fsdecode(path)
    except TypeError:
        raise error(f"path: expected a path, found {type(path).__name__}") \
            from None
    suffix = os.path.splitext(name)[1].lower()
    if suffix not in known:
        raise error(f"{name}: expected a name that ends with "
                    f"{' or '.join(known)}")
    folder = os.path.dirname(os.path.abspath(name))
    if "\0" in name or not os.path.isdir(folder):
        raise error(f"{name}: there is no folder {folder}")
    return suffix


@contextlib.contextmanager
def whole_file(path) -> Iterator[BinaryIO]:
    """A file to write to that gets its name when the block ends well."""
    path = os.fsdecode(path)
    folder = os.path.dirname(os.path.abspath(path))
    temporary = os.path.join(
        folder, f".{os.path.basename(path)}.{os.getpid()}.{secrets.token_hex(4)}")
    handle = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666)
    try:
        with os.fdopen(handle, "wb") as file:
            yield file
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
