"""Arguments of Python as the scene in JSON that the library reads."""
from __future__ import annotations

import json
import math
import os
import pathlib
from typing import Any, Mapping, Union

import numpy as np

from ._errors import InputError

Source = Union[Mapping[str, Any], str, "os.PathLike[str]"]


def plain(key: str, value: Any) -> Any:
    """`value` as lists and numbers of Python; a number that is not finite is refused."""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {name: plain(str(name), entry) for name, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(key, entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        raise InputError.of(key, "must be finite", value)
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    raise InputError.of(key, "must be numbers, lists of numbers or arrays", repr(value))


def scene_of(arguments: Mapping[str, Any]) -> dict[str, Any]:
    """A scene from the arguments of System(): what is None is left out, and ratios given as a matrix get the matrix's key."""
    scene = {key: plain(key, value) for key, value in arguments.items() if value is not None}
    for ratios, matrix in (("mass_ratios", "mass_matrix"), ("stiffness_ratios", "stiffness_matrix")):
        value = scene.get(ratios)
        if isinstance(value, list) and value and isinstance(value[0], list):
            scene[matrix] = scene.pop(ratios)
    return scene


def read(source: Source) -> tuple[dict[str, Any], str]:
    """A scene from a mapping, the text of a JSON object, or a path to a file; the scene and its text."""
    if isinstance(source, Mapping):
        scene = plain("scene", source)
        return scene, json.dumps(scene)
    text = source if isinstance(source, str) and source.lstrip().startswith("{") else None
    if text is None:
        path = pathlib.Path(source)
        try:
            text = path.read_text(encoding="utf-8")
        except OSError as reason:
            raise InputError(f"{path} cannot be read ({reason.strerror})") from reason
    try:
        return json.loads(text), text
    except ValueError:
        return {}, text  # the library says what is wrong with it
