"""What `import asperity.mujoco` and `asperity.mujoco_warp` say where their host is missing. With it, `hosts/mujoco/run.sh` and
`hosts/mujoco_warp/run.sh` test the modules."""

from __future__ import annotations

import importlib
import sys

import pytest


@pytest.mark.parametrize(("module", "host", "package"), [
    ("asperity.mujoco", "mujoco", "mujoco"), ("asperity.mujoco_warp", "mujoco_warp", "mujoco-warp"),
])  # fmt: skip
def test_without_the_host_the_message_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, module: str, host: str, package: str
) -> None:
    monkeypatch.setitem(sys.modules, host, None)
    monkeypatch.delitem(sys.modules, module, raising=False)
    with pytest.raises(ImportError, match=f"pip install {package}$"):
        importlib.import_module(module)
