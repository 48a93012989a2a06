"""Threads: calls run while the interpreter does, and a model may be changed or closed under its users."""

from __future__ import annotations

import ctypes
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

from asperity import Error, Model, Params, _library


def is_seen_half_done(call: Any, model: Model, loads: Any) -> bool:
    """Whether this thread sees the first force of a call in another thread before the last one is there."""
    forces = np.zeros(loads.size)
    places = [array.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for array in (loads, forces)]
    thread = threading.Thread(target=call, args=(model._open().pointer, loads.size, *places, None))
    thread.start()
    seen = False
    while thread.is_alive() and not seen:
        # In this order: all may come between the two looks.
        first, last = forces[0], forces[-1]
        seen = first != 0 and last == 0
    thread.join()
    assert forces[0] != 0 and forces[-1] != 0
    return seen


def test_a_call_does_not_hold_the_interpreter(model: Model) -> None:
    # So many loads that the call lasts some hundredths of a second; however few turns this thread gets, it is seen at last.
    loads = np.full(2_000_000, 2 * model.summary().max_table_load)
    assert any(is_seen_half_done(_library.LIBRARY.asperity_friction_force_at_loads, model, loads) for _ in range(100))

    # The same call by a loader that keeps the interpreter lock, as no thread can see it: this test can tell.
    keeping = ctypes.PyDLL(_library.PATH).asperity_friction_force_at_loads
    keeping.argtypes = _library.LIBRARY.asperity_friction_force_at_loads.argtypes
    assert not any(is_seen_half_done(keeping, model, loads) for _ in range(5))


def test_threads_share_a_model(model: Model) -> None:
    loads = np.geomspace(1e-3, 1e5, 5000)
    alone = model.friction_at_load(loads)
    with ThreadPoolExecutor(4) as pool:
        for together in pool.map(model.friction_at_load, [loads] * 16):
            assert np.array_equal(together, alone)


def test_each_thread_has_its_own_message(model: Model) -> None:
    def refused(load: float) -> str:
        with pytest.raises(Error) as caught:
            for _ in range(200):
                try:
                    model.state_at_load(load)
                except Error as error:
                    assert f"load = {load:g}: below" in str(error)
            model.state_at_load(load)
        return str(caught.value)

    with ThreadPoolExecutor(4) as pool:
        for load, message in zip((-1.0, -2.0, -3.0, -4.0), pool.map(refused, (-1.0, -2.0, -3.0, -4.0))):
            assert message.startswith(f"load = {load:g}: below the pull-off load")


def test_a_model_may_be_changed_and_closed_while_others_use_it(params: Params) -> None:
    laws = [params, params.replace(asperity_count=2)]
    loads = np.geomspace(1e-2, 1e2, 2000)
    expected = []
    for law in laws:
        with Model(law) as alone:
            expected.append(alone.friction_at_load(loads).tobytes())
    shared, stop, seen = Model(params), threading.Event(), set()

    def use() -> None:
        while not stop.is_set():
            try:
                seen.add(shared.friction_at_load(loads).tobytes())
            except Error as error:
                assert "closed" in str(error)

    with ThreadPoolExecutor(3) as pool:
        users = [pool.submit(use) for _ in range(3)]
        for i in range(30):
            shared.set_params(laws[i % 2])
            if i % 5 == 0:
                shared.close()
        stop.set()
        for user in users:
            user.result()
    assert seen <= set(expected)
