"""The plugin of MuJoCo, compiled and loaded; `asperity.mujoco` has the names."""

from __future__ import annotations

import ctypes
import functools
import hashlib
import importlib.abc
import importlib.machinery
import os
import shutil
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path
from types import ModuleType
from typing import Any
from xml.sax.saxutils import quoteattr

try:
    import mujoco
except ImportError as error:
    raise ImportError(f"asperity.mujoco needs MuJoCo ({error}): pip install mujoco") from None

from .. import _library
from ..params import Params

__all__ = ["PLUGIN", "instance", "solve"]


def instance(name: str, params: Params) -> str:
    """The element `<instance>` of a model that has these surfaces."""
    text = params._as_text().replace('"', "'")  # MuJoCo saves a double quote in an attribute as it is
    return f'<instance name={quoteattr(name)}><config key="text" value={quoteattr(text)}/></instance>'


def solve(model: mujoco.MjModel, data: mujoco.MjData) -> int:
    """Solves a step, between `mj_step1` and `mj_step2`, until the friction of each pair of geoms is the law at its own
    normal force. Set controls and applied forces before. Returns how often it solved; `RuntimeError` if friction and
    normal force do not settle."""
    passes = int(_solve(model._address, data._address))
    if passes < 0:
        raise RuntimeError(f"friction and normal force do not settle at time {data.time:g}: take shorter steps")
    return passes


def _source(name: str) -> Path:
    """A C source: in the package, or in the checkout whose sources these are."""
    packed = Path(__file__).parents[1] / name
    if packed.exists():
        return packed
    root = Path(__file__).parents[4]
    return next(path for path in (root / "hosts" / "mujoco" / name, root / "include" / name) if path.exists())


def _plugin() -> Path:
    """The compiled plugin, of these sources, this library and this MuJoCo."""
    installed = Path(mujoco.__file__).parent
    engine = next(installed.glob("libmujoco.so.*"), None)
    if engine is None:
        raise ImportError(f"asperity.mujoco is for Linux: there is no libmujoco.so in {installed}")
    sources = [_source(name) for name in ("plugin.c", "microslip.h", "asperity_mujoco.h", "asperity.h", "asperity_loads.h")]
    made_of = [mujoco.__version__, str(engine), _library.PATH, *(path.read_text(encoding="utf-8") for path in sources)]
    digest = hashlib.sha256("\0".join(made_of).encode()).hexdigest()[:16]
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "asperity")
    plugin = cache / f"mujoco-{mujoco.__version__}-{digest}" / "libasperity_mujoco.so"
    if not plugin.exists():
        plugin.parent.mkdir(parents=True, exist_ok=True)
        _compile(sources, engine, plugin)
    return plugin


def _compile(sources: list[Path], engine: Path, plugin: Path) -> None:
    compiler = os.environ.get("CC", "cc")
    if shutil.which(compiler) is None:
        raise ImportError(f"asperity.mujoco compiles its plugin, and there is no {compiler}: apt-get install gcc")
    library = Path(_library.PATH).resolve()
    with tempfile.TemporaryDirectory(dir=plugin.parent) as made:
        for path in sources:
            shutil.copy(path, made)
        command = [compiler, "-std=c11", "-O2", "-shared", "-fPIC", "-fexceptions", "-Wl,--no-undefined", f"-I{made}"]
        command += ["-isystem", str(engine.parent / "include"), f"{made}/plugin.c", "-o", f"{made}/{plugin.name}"]
        command += [f"-L{library.parent}", f"-l:{library.name}", str(engine), "-lm"]
        command += [f"-Wl,-rpath,{library.parent}:{engine.parent}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise ImportError(f"asperity.mujoco: {compiler} does not make the plugin:\n{done.stderr}")
        # Whole or not at all, where several processes import this at a time.
        Path(made, plugin.name).replace(plugin)


PLUGIN = str(_plugin())
mujoco.mj_loadPluginLibrary(PLUGIN)
_solve = ctypes.CDLL(PLUGIN).asperity_mujoco_solve
_solve.argtypes = [ctypes.c_void_p, ctypes.c_void_p]
_has_plugin = ctypes.CDLL(PLUGIN).asperity_mujoco_has_plugin
_has_plugin.argtypes = [ctypes.c_void_p, ctypes.c_int]

# The back ends of MuJoCo that drop engine plugins, and what has the law in them.
_BACK_ENDS = {"mujoco.mjx": "asperity.mjx", "mujoco_warp": "asperity.mujoco_warp"}


def _tell_dropped(back_end: ModuleType) -> None:
    """Makes a back end say which instances it drops, where it is given a model."""
    put_model = back_end.put_model

    @functools.wraps(put_model)
    def telling(*args: Any, **named: Any) -> Any:
        for model in (each for each in (*args, *named.values()) if isinstance(each, mujoco.MjModel)):
            for number in (each for each in range(model.nplugin) if _has_plugin(model._address, each)):
                name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_PLUGIN, number)
                message = (
                    f"{back_end.__name__} drops the plugin asperity.friction, instance {name!r}: its geoms keep the "
                    f"friction of the model. Give them the law with {_BACK_ENDS[back_end.__name__]}.attach"
                )
                warnings.warn(message, stacklevel=2)
        return put_model(*args, **named)

    back_end.put_model = telling  # type: ignore[attr-defined]


class _Watch(importlib.abc.MetaPathFinder):
    """Finds a back end that is imported later, as Python does, and has it say what it drops."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> importlib.machinery.ModuleSpec | None:
        spec = importlib.machinery.PathFinder.find_spec(name, path) if name in _BACK_ENDS else None
        if spec and spec.loader:
            load = spec.loader.exec_module

            def exec_module(module: ModuleType) -> None:
                load(module)
                _tell_dropped(module)

            spec.loader.exec_module = exec_module  # type: ignore[method-assign]
        return spec


for _name in _BACK_ENDS:
    if _name in sys.modules:
        _tell_dropped(sys.modules[_name])
sys.meta_path.insert(0, _Watch())
