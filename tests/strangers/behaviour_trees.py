"""Our behaviour trees run again by py_trees: the root's answer, every call of every leaf in its order, and what runs."""

import collections
import copy
import json
import sys
import types
from importlib.metadata import version

import py_trees
from py_trees.common import ParallelPolicy, Status

LETTERS = {Status.INVALID: "i", Status.RUNNING: "r", Status.SUCCESS: "s", Status.FAILURE: "f"}
OUTCOMES = {"r": Status.RUNNING, "s": Status.SUCCESS, "f": Status.FAILURE}


class World:
    """What the leaves of a tree are told, and what they write down."""

    def __init__(self):
        self.outcomes = ""
        self.calls = []

    def holds(self, node):
        self.calls.append(f"?{node}")
        return self.outcomes[node] == "+"


class Action(py_trees.behaviour.Behaviour):
    def __init__(self, world, node):
        super().__init__(name=str(node))
        self.world, self.node, self.begins = world, node, False

    def initialise(self):
        self.begins = True

    def update(self):
        self.world.calls.append(("+" if self.begins else "=") + str(self.node))
        self.begins = False
        return OUTCOMES[self.world.outcomes[self.node]]

    def terminate(self, new_status):
        # py_trees also clears leaves that have ended; they have nothing to stop.
        if new_status == Status.INVALID and self.status == Status.RUNNING:
            self.world.calls.append(f"-{self.node}")


class Condition(py_trees.behaviour.Behaviour):
    def __init__(self, world, node):
        super().__init__(name=str(node))
        self.world, self.node = world, node

    def update(self):
        return Status.SUCCESS if self.world.holds(self.node) else Status.FAILURE


def grown(nodes, world, at, behaviours):
    """The subtree at a place in our preorder; `behaviours` takes its nodes in the same order."""
    node, name = nodes[at], str(at)
    place = len(behaviours)
    behaviours.append(None)
    children, child = [], at + 1
    while child < at + node["size"]:
        children.append(grown(nodes, world, child, behaviours))
        child += nodes[child]["size"]
    kind = node["kind"]
    if kind == "do":
        made = Action(world, at)
    elif kind == "when":
        made = Condition(world, at)
    elif kind == "sequence":
        made = py_trees.composites.Sequence(name, memory=not node["reactive"], children=children)
    elif kind == "fallback":
        made = py_trees.composites.Selector(name, memory=not node["reactive"], children=children)
    elif kind == "parallel":
        on_all = node["success_on"] == "all"
        policy = ParallelPolicy.SuccessOnAll(synchronise=True) if on_all else ParallelPolicy.SuccessOnOne()
        made = py_trees.composites.Parallel(name, policy=policy, children=children)
    else:
        (only,) = children
        if kind == "guard":
            made = py_trees.decorators.EternalGuard(name=name, child=only, condition=lambda: world.holds(at))
        elif kind == "retry":
            made = py_trees.decorators.Retry(name=name, child=only, num_failures=node["times"])
        else:
            assert kind == "timeout", kind
            made = py_trees.decorators.Timeout(name=name, child=only, duration=node["after_s"])
    behaviours[place] = made
    return made


def differences(case):
    """Where py_trees does otherwise, as texts."""
    world, behaviours = World(), []
    root = grown(case["nodes"], world, 0, behaviours)
    found = []
    for number, tick in enumerate(case["ticks"]):
        py_trees.decorators.time = types.SimpleNamespace(monotonic=lambda now_s=tick["now_s"]: now_s)
        world.outcomes, world.calls = tick["outcomes"], []
        if tick["is_halted"]:
            root.stop(Status.INVALID)
        root.tick_once()
        theirs = {
            "answer": LETTERS[root.status],
            "calls": " ".join(world.calls),
            # How what does not run has ended is another matter: py_trees clears some of it, we none.
            "statuses": "".join("r" if b.status == Status.RUNNING else "." for b in behaviours),
        }
        ours = {
            "answer": tick["answer"],
            "calls": tick["calls"],
            "statuses": "".join("r" if s == "r" else "." for s in tick["statuses"]),
        }
        found += [f"tick {number}: {k}: py_trees {theirs[k]!r}, ours {ours[k]!r}" for k in ours if ours[k] != theirs[k]]
    return found


def changed_tick(change):
    """A change of one tick, made to the last tick of a case where it changes anything."""

    def of_case(case):
        for tick in reversed(case["ticks"]):
            before = copy.deepcopy(tick)
            change(tick)
            if tick != before:
                return True
        return False

    return of_case


def other_answer(tick):
    tick["answer"] = "s" if tick["answer"] == "f" else "f"


def without_a_halt(tick):
    calls = tick["calls"].split()
    halts = [i for i, call in enumerate(calls) if call[0] == "-"]
    tick["calls"] = " ".join(c for i, c in enumerate(calls) if i not in halts[:1])


def two_calls_exchanged(tick):
    calls = tick["calls"].split()
    if len(calls) > 1:
        calls[-2:] = calls[:-3:-1]
    tick["calls"] = " ".join(calls)


def started_twice(tick):
    tick["calls"] = tick["calls"].replace("=", "+", 1)


def one_runs_no_more(tick):
    tick["statuses"] = tick["statuses"].replace("r", "i", 1)


MUTATIONS = [other_answer, without_a_halt, two_calls_exchanged, started_twice, one_runs_no_more]


def main(path):
    with open(path, encoding="utf-8") as file:
        made_up = json.load(file)
    cases = made_up["cases"]
    kinds, calls = collections.Counter(), collections.Counter()
    wrong = 0
    for number, case in enumerate(cases):
        found = differences(case)
        if found and wrong < 10:
            print(f"tree {number} of seed {made_up['seed']}: {found[0]}")
            print("  " + " ".join(f"{i}:{n['kind']}({n['size']})" for i, n in enumerate(case["nodes"])))
        wrong += bool(found)
        kinds.update(n["kind"] + ("*" if n["reactive"] else "") for n in case["nodes"])
        calls.update(call[0] for tick in case["ticks"] for call in tick["calls"].split())
    assert wrong == 0, f"{wrong} of {len(cases)} trees run otherwise in py_trees"
    assert len(kinds) == 10 and min(kinds.values()) >= len(cases) / 20, kinds
    assert len(calls) == 4 and min(calls.values()) >= len(cases), calls

    for mutation in MUTATIONS:
        for case in cases:
            case = copy.deepcopy(case)
            if changed_tick(mutation)(case):
                assert differences(case), f"{mutation.__name__} was not seen"
                break
        else:
            raise AssertionError(f"no tree for {mutation.__name__}")
    print(
        f"py_trees {version('py_trees')} runs {len(cases)} trees of {sum(kinds.values())} nodes as we do: "
        f"{calls['+']} starts, {calls['=']} continuations, {calls['-']} halts, {calls['?']} conditions; "
        f"{len(MUTATIONS)} planted differences are seen"
    )


main(sys.argv[1])
