"""Run independent pieces of work, here or in processes, with results in order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from typing import TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")


def run_all(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    jobs: int,
    lost: Callable[[Task], Result],
    tick: Callable[[Task], None],
) -> list[Result]:
    """Call a function for each task.

    Parameters
    ----------
    function : callable
        From the top level of a module, because processes import it by name.
    tasks : sequence
        Arguments that can be pickled.
    jobs : int
        Processes; 1 calls the function here.
    lost : callable
        Result for a task whose process ended without an answer.
    tick : callable
        Called with each task that is done.

    Returns
    -------
    list
        One result a task, in the order of the tasks.
    """
    found: dict[int, Result] = {}
    if jobs == 1:
        for place, task in enumerate(tasks):
            found[place] = function(task)
            tick(task)
    else:
        with _pool(min(jobs, max(len(tasks), 1))) as pool:
            futures = {pool.submit(function, task): place for place, task in enumerate(tasks)}
            for future in as_completed(futures):
                if isinstance(future.exception(), BrokenProcessPool):
                    continue
                found[futures[future]] = future.result()
                tick(tasks[futures[future]])
    for place, task in enumerate(tasks):
        if place not in found:
            # one process took its neighbours down; alone, only the culprit fails again
            found[place] = _alone(function, task, lost)
            tick(task)
    return [found[place] for place in range(len(tasks))]


def _alone(
    function: Callable[[Task], Result], task: Task, lost: Callable[[Task], Result]
) -> Result:
    try:
        with _pool(1) as pool:
            return pool.submit(function, task).result()
    except BrokenProcessPool:
        return lost(task)


def _pool(jobs: int) -> ProcessPoolExecutor:
    # fresh processes: a copy of this one would hold locks of threads that it does not have
    return ProcessPoolExecutor(jobs, mp_context=get_context("spawn"))
