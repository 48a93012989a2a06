"""What `import asperity.mujoco` says where MuJoCo is missing. With it, `hosts/mujoco/run.sh` tests the module."""

from __future__ import annotations

import sys

import pytest


def test_without_mujoco_the_message_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    monkeypatch.delitem(sys.modules, "asperity.mujoco", raising=False)
    with pytest.raises(ImportError, match="pip install mujoco"):
        import asperity.mujoco  # noqa: F401
