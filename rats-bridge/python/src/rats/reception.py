"""Calls that are heard: who is meant, what is done once, in which order, until when."""
from __future__ import annotations

import json
import logging
import threading
import time
from collections import OrderedDict, deque
from dataclasses import dataclass, field
from typing import Any, Callable, Mapping

import paho.mqtt.client as mqtt

from .calls import Canceled, Ended, Failed, Refused, TimedOut, malformed
from .features import Feature, cost_of, plain

LOG = logging.getLogger("rats")
REMEMBERED_SECONDS = 600.0
MOST_REMEMBERED = 4096
MOST_WAITING = 64
MOST_BYTES = 256 * 1024


class Call:
    """A call under way. Its feature may tell progress, and should look whether it is to end."""

    def __init__(self, message: Mapping[str, Any], deadline: float,
                 tell: Callable[[str, Mapping[str, Any]], None]) -> None:
        self.id: str = message["id"]
        self.sender: str = message["from"]
        self.feature: str = message["f"]
        self.parameters: dict[str, Any] = message["p"]
        self.task: str | None = message.get("task")
        self.deadline = deadline
        self._tell = tell
        self._limit: Callable[[], None] = lambda: None
        self._ended = threading.Event()
        self._end: type[Failed] = Canceled
        self._why = "The call was canceled before it was done"

    @property
    def key(self) -> tuple[str, str]:
        """Callers choose their ids themselves."""
        return self.sender, self.id

    def progress(self, fraction: float, **values: Any) -> None:
        """Says how far it is, 0 to 1; who waits goes on waiting."""
        self._tell(self.sender, {
            "id": self.id, "kind": "RUNNING", "fraction": fraction, "values": values})

    def established(self, **values: Any) -> None:
        """Says that the effect of a continuous feature is there, with what it tells first; its time
        is not over any more before it is ended."""
        self._limit()
        self._tell(self.sender, {
            "id": self.id, "kind": "ESTABLISHED", "fraction": 1, "values": values})

    @property
    def is_to_end(self) -> bool:
        return self._ended.is_set()

    def check(self) -> None:
        """Raises Canceled, Ended or TimedOut when the call is to end."""
        if self._ended.is_set():
            raise self._end(self._why)

    def sleep(self, seconds: float) -> None:
        """Waits, and raises Canceled, Ended or TimedOut as soon as the call is to end."""
        self._ended.wait(seconds)
        self.check()

    def _finish(self, how: type[Failed]) -> None:
        if not self._ended.is_set():
            self._end = how
            if how is TimedOut:
                self._why = "The time of the call was over before it was done; time_limit gives more"
            self._ended.set()


@dataclass
class _Known:
    body: tuple[Any, ...]
    answer: dict[str, Any] | None = None
    until: float = float("inf")


@dataclass
class _Waiting:
    call: Call
    feature: Feature
    timer: threading.Timer = field(repr=False, default=None)  # type: ignore[assignment]


class Reception:
    """Takes the calls of one device, and gives each its one answer. Any thread."""

    def __init__(self, identifier: str, boot: str, send: Callable[[str, Mapping[str, Any]], None],
                 changed: Callable[[], None], describe: Callable[[], None],
                 lock: threading.RLock) -> None:
        """``send`` publishes on a topic below the site's, ``changed`` tells the state, and
        ``describe`` all that is retained; both take the ``lock``, which is the device's."""
        self.id = identifier
        self.boot = boot
        self.features: dict[str, Feature] = {}
        self.safe_actions: list[Callable[[], None]] = []
        self.waiting: list[_Waiting] = []
        self.running: dict[tuple[str, str], _Waiting] = {}
        self.recent: deque[dict[str, str]] = deque(maxlen=16)
        self._send = send
        self._changed = changed
        self._describe = describe
        self._known: OrderedDict[tuple[str, str], _Known] = OrderedDict()
        self._clocks: OrderedDict[str, float] = OrderedDict()
        self._becomes_safe = 0
        self._lock = lock
        self._idle = threading.Condition(self._lock)

    @property
    def z(self) -> str:
        """The abstract state."""
        return "busy" if self.running else "standby"

    def state(self) -> dict[str, Any]:
        """What its state says of calls."""
        with self._lock:
            return {"z": self.z, "running": [call for _, call in self.running],
                    "queue": [waiting.call.id for waiting in self.waiting],
                    "disabled": [], "recent": list(self.recent)}

    def _progress(self, to: str, fields: Mapping[str, Any]) -> None:
        self._send(f"progress/{to}/{self.id}", {"from": self.id, **fields})

    def heard(self, topic: str, message: mqtt.MQTTMessage) -> None:
        if message.retain or len(message.payload) > MOST_BYTES:
            return
        call = {"p": {}, **json.loads(message.payload)}
        caller = topic[len("call/"):] or call.get("from")
        if call.get("r", "") not in (self.id, "") or not isinstance(call.get("id"), str):
            return
        fault = malformed(call)
        if fault and call.get("r") == self.id:
            self._refuse(call["id"], caller, Refused(fault[1], code=fault[0]))
        if fault or caller != call["from"]:
            return
        own = call["f"] in self.features or call["f"].startswith("$")
        if call.get("r") or own:
            self._take(call, self._left_for(call, message))

    def _left_for(self, call: Mapping[str, Any], message: mqtt.MQTTMessage) -> float:
        """Seconds that are left of a call's time when it arrives."""
        left = call["t"] / 1000
        expiry = getattr(message.properties, "MessageExpiryInterval", None)
        if expiry is not None:
            left = min(left, expiry + 1)
        sent = call.get("sent")
        if isinstance(sent, dict) and isinstance(sent.get("ms"), (int, float)):
            behind = time.monotonic() - sent["ms"] / 1000
            quickest = min(behind, self._clocks.get(str(sent.get("clock")), behind))
            self._clocks[str(sent.get("clock"))] = quickest
            if len(self._clocks) > MOST_WAITING:
                self._clocks.popitem(last=False)
            left = min(left, call["t"] / 1000 - (behind - quickest))
        return left

    def _take(self, call: dict[str, Any], left: float) -> None:
        key = call["from"], call["id"]
        body = call.get("r"), call["f"], json.dumps(call["p"], sort_keys=True)
        if call.get("boot", self.boot) != self.boot:
            return self._refuse(call["id"], call["from"], Refused(
                "The call was meant for another life of " + self.id, code="RESTARTED",
                retriable=True))
        with self._lock:
            known = self._known.get(key)
            if known is not None and known.body != body:
                return self._refuse(call["id"], call["from"], Refused(
                    "Another call of that id came before; each call needs its own",
                    code="DUPLICATE_ID"))
            if known is not None:
                if known.answer is not None:
                    self._send(f"result/{call['from']}/{self.id}", known.answer)
                return None
            self._forget()
            self._known[key] = _Known(body)
        made = Call(call, time.monotonic() + left, self._progress)
        try:
            if made.feature.startswith("$"):
                return self._reserved(made)
            if left <= 0:
                raise Refused("The call arrived after its time had passed", code="EXPIRED",
                              retriable=True)
            self._queue(made, left)
        except Refused as refusal:
            self._end(made, refusal)
        except Exception as fault:  # noqa: BLE001 - whatever a price or an exit raises
            LOG.exception("%s: %s failed", self.id, made.feature)
            self._end(made, Failed(f"{type(fault).__name__}: {fault}", code="INTERNAL"))
        return None

    def _queue(self, call: Call, left: float) -> None:
        offered = self.features.get(call.feature)
        if offered is None:
            raise Refused(f"{self.id} has no feature {call.feature}", code="UNKNOWN_FEATURE")
        missing = sorted(set(offered.inputs) - set(call.parameters))
        if missing:
            raise Refused(f"{call.feature} needs the parameters {', '.join(missing)}",
                          code="INVALID_PARAMETERS")
        with self._lock:
            if self._becomes_safe:
                raise Refused(f"{self.id} was told to be safe; try when it is", code="DISABLED",
                              retriable=True)
            if len(self.waiting) >= MOST_WAITING:
                raise Refused(f"The queue of {self.id} is full; try later", code="QUEUE_FULL",
                              retriable=True)
            waiting = _Waiting(call, offered)
            waiting.timer = threading.Timer(left, self._over, (call, TimedOut))
            waiting.timer.daemon = True
            call._limit = waiting.timer.cancel
            waiting.timer.start()
            self.waiting.append(waiting)
            self._begin_what_can()
            self._changed()

    def _begin_what_can(self) -> None:
        taken = {part for running in self.running.values() for part in running.feature.occupies}
        for waiting in list(self.waiting):
            if not waiting.feature.occupies & taken:
                self.waiting.remove(waiting)
                self.running[waiting.call.key] = waiting
                self._end_what_it_ends(waiting)
                threading.Thread(target=self._perform, args=(waiting,), daemon=True).start()
            taken |= waiting.feature.occupies

    def _end_what_it_ends(self, ending: _Waiting) -> None:
        """Calls of continuous features that name it as their end, for the same things."""
        for running in self.running.values():
            same = all(
                running.call.parameters.get(name) == ending.call.parameters.get(name)
                for name in ending.feature.inputs)
            if running.feature.ended_by == ending.feature.name and same:
                running.call._finish(Ended)

    def _perform(self, waiting: _Waiting) -> None:
        call, outcome, values = waiting.call, None, {}
        try:
            values = dict(waiting.feature.run(
                call, **plain(call.parameters, waiting.feature.inputs)) or {})
            json.dumps(values, allow_nan=False)  # what cannot be told has failed
        except Ended:
            pass
        except Failed as failure:
            outcome = failure
        except Exception as fault:  # noqa: BLE001 - whatever a feature raises is its failure
            LOG.exception("%s: %s failed", self.id, call.feature)
            outcome = Failed(f"{type(fault).__name__}: {fault}", code="INTERNAL")
        waiting.timer.cancel()
        with self._lock:
            self.running.pop(call.key, None)
            if outcome is None:
                self.recent.append({"id": call.id, "outcome": "SUCCEEDED"})
            self._begin_what_can()
            self._changed()
            self._idle.notify_all()
        self._end(call, outcome, {} if outcome else values)

    def _over(self, call: Call, how: type[Failed]) -> bool:
        """Ends a call that waits or runs; whether there is one."""
        with self._lock:
            for waiting in self.waiting:
                if waiting.call is call:
                    self.waiting.remove(waiting)
                    waiting.timer.cancel()
                    self._changed()
                    self._end(call, how("The call was ended before it was begun"))
                    return True
            running = self.running.get(call.key)
            if running is not None and running.call is call:
                call._finish(how)
                return True
        return False

    def _reserved(self, call: Call) -> None:
        if call.feature in ("$ping", "$describe"):
            if call.feature == "$describe":
                self._describe()
            self._end(call, None, {})
        elif call.feature == "$cancel":
            self._end(call, None, {"found": self._cancel(call)})
        elif call.feature == "$safe":
            threading.Thread(target=self._safely, args=(call,), daemon=True).start()
        elif call.feature == "$cost":
            self._end(call, None, {"costs": self._costs(call)})
        else:
            raise Refused(f"{self.id} has no feature {call.feature}", code="UNKNOWN_FEATURE")

    def _cancel(self, by: Call) -> bool:
        with self._lock:
            calls = [one.call for one in [*self.waiting, *self.running.values()]]
        meant = [call for call in calls if call.id == by.parameters.get("id")]
        meant.sort(key=lambda call: call.sender != by.sender)
        return bool(meant) and self._over(meant[0], Canceled)

    def make_safe(self) -> dict[str, Any]:
        with self._lock:
            self._becomes_safe += 1
            for one in [*self.waiting, *self.running.values()]:
                self._over(one.call, Canceled)
            self._idle.wait_for(lambda: not self.running, 10)
        try:
            for action in self.safe_actions:
                action()
        finally:
            with self._lock:
                self._becomes_safe -= 1
        return {}

    def _safely(self, call: Call) -> None:
        try:
            self._end(call, None, self.make_safe())
        except Exception as fault:  # noqa: BLE001 - whatever an action raises
            LOG.exception("%s could not be made safe", self.id)
            self._end(call, Failed(f"{type(fault).__name__}: {fault}", code="INTERNAL"))

    def _costs(self, call: Call) -> list[dict[str, Any]]:
        offered = self.features.get(str(call.parameters.get("feature")))
        sets = call.parameters.get("sets")
        if offered is None:
            raise Refused(f"{self.id} has no feature {call.parameters.get('feature')}",
                          code="UNKNOWN_FEATURE")
        if not isinstance(sets, list):
            raise Refused("$cost needs sets, a list of parameter sets", code="INVALID_PARAMETERS")
        return [cost_of(offered, one) for one in sets]

    def _end(self, call: Call, failure: Failed | None,
             values: Mapping[str, Any] | None = None) -> None:
        answer = {"id": call.id, "from": self.id, "z": self.z, "values": dict(values or {}),
                  "outcome": failure.outcome if failure else "SUCCEEDED"}
        if failure:
            answer["error"] = failure.error()
        with self._lock:
            known = self._known.get(call.key)
            if known is not None:
                known.answer = answer
                known.until = time.monotonic() + REMEMBERED_SECONDS
        self._send(f"result/{call.sender}/{self.id}", answer)

    def _refuse(self, identifier: str, caller: str, refusal: Refused) -> None:
        """A refusal that does not take the place of the answer to the first call of that id."""
        self._send(f"result/{caller}/{self.id}", {
            "id": identifier, "from": self.id, "z": self.z, "values": {},
            "outcome": refusal.outcome, "error": refusal.error()})

    def _forget(self) -> None:
        now = time.monotonic()
        for key in [key for key, known in self._known.items() if known.until < now]:
            del self._known[key]
        while len(self._known) >= MOST_REMEMBERED:
            oldest = next((key for key, known in self._known.items() if known.answer), None)
            if oldest is None:
                return
            del self._known[oldest]
