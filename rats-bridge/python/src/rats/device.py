"""A device on the bus: it joins, is called, answers, and tells what is so."""
from __future__ import annotations

import json
import logging
import threading
import uuid
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping

import paho.mqtt.client as mqtt
from paho.mqtt.packettypes import PacketTypes
from paho.mqtt.properties import Properties
from paho.mqtt.subscribeoptions import SubscribeOptions

from .description import Thing, described, iri, kind
from .features import Feature, parameters
from .reception import Call, Reception

LOG = logging.getLogger("rats")
VERSION = "1.3"


@dataclass(frozen=True)
class Result:
    """What another member answered."""

    outcome: str
    values: dict[str, Any]
    error: dict[str, Any] | None = None

    @property
    def succeeded(self) -> bool:
        return self.outcome == "SUCCEEDED"


class Device:
    """A device, before and while it is on the bus.

    Features run in threads of their own; those that occupy the same thing wait for each other. All
    methods may be called from any thread.
    """

    def __init__(self, identifier: str, *, namespace: str, label: str | None = None,
                 type: str | Iterable[str] = "maestro:Device",  # noqa: A002
                 words: Iterable[Mapping[str, Any]] = (), classes: Mapping[str, str] | None = None,
                 things: Iterable[Thing] = (), properties: Mapping[str, Any] | None = None,
                 reports: Mapping[str, str] | None = None,
                 description: Mapping[str, Any] | None = None) -> None:
        """``classes`` are the device's own, each with the one that it is under. ``reports`` are
        facts by name, ``{"warm": "(warm ?self)"}``, that its values tell whenever they are so.
        ``description`` takes the place of all that is described by the rest: it is the whole
        document."""
        self.id = identifier
        self.boot = uuid.uuid4().hex
        self.verdict: dict[str, Any] | None = None
        self._label = label or identifier
        self._namespace = namespace
        self._types = [type] if isinstance(type, str) else list(type)
        self._words = [*(kind(name, under) for name, under in (classes or {}).items()), *words]
        self._things = list(things)
        self._properties = dict(properties or {})
        if reports:
            self._properties["reports"] = [
                {"name": name, "fact": fact} for name, fact in reports.items()]
        self._whole = description
        self._values: list[str] = []
        self._asked: dict[str, tuple[threading.Event, list[dict[str, Any]], str]] = {}
        self._lock = threading.RLock()
        self._client: mqtt.Client | None = None
        self._root = ""
        self._left = threading.Event()
        self._leaves = False
        self._next_call = 0
        self._reception = Reception(
            identifier, self.boot, self._send, self._tell_state, self._announce, self._lock)

    # --- What it is and does

    def feature(self, name: str, *, inputs: Mapping[str, Any] | None = None, cost: Any = "1",
                seconds: Any = None, effect: str | None = None, precondition: str | None = None,
                learns: str | None = None, outputs: Mapping[str, str] | None = None,
                binds: Mapping[str, str] | None = None, occupies: Iterable[str] = (),
                sentence: str | None = None, time_limit: float | None = None,
                done_when: str | None = None, effect_after: float | None = None,
                grace: float | None = None, meanwhile: str | None = None,
                chance: float | None = None, tries: int | None = None,
                continuous: bool = False, ended_by: str | None = None,
                type: str | None = None  # noqa: A002
                ) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
        """Makes a function a feature. It is called with the call and the inputs by name: names of
        things, numbers, texts. What it returns, a dict, are the outputs.

        ``inputs`` are classes or datatypes by name, such as ``{"drink": "Drink", "level":
        "xsd:decimal"}``; ``type`` names a feature of the vocabulary, such as ``domain:adjustLight``,
        of which then only what differs has to be said. ``cost`` is a number or an expression in
        MAESTRO-SL; where the function has a ``price`` it is asked for. ``done_when`` is a condition
        of which the device tells when the effect is there, where that is later than the answer;
        ``time_limit`` is in seconds, and so is ``grace``, for a safe end and the answer beyond it.
        ``meanwhile`` has to hold until the answer; ``chance`` is how often it works, ``tries`` how
        often in all it may be tried. A ``continuous`` feature goes on until it is called off or the
        feature ``ended_by`` is called for the same things; it says ``call.established()`` when its
        effect is there.
        """
        wanted = dict(inputs or {})

        def added(run: Callable[..., Any]) -> Callable[..., Any]:
            text: dict[str, Any] = {"type": type} if type else {
                "id": iri(name), "type": "maestro:Task"}
            text.update({key: value for key, value in {
                "sentence": sentence, "precondition": precondition, "effect": effect,
                "learns": learns, "timeLimit": time_limit, "doneWhen": done_when,
                "effectAfter": effect_after, "grace": grace, "meanwhile": meanwhile,
                "chance": chance, "tries": tries, "continuous": continuous,
                "endedBy": iri(ended_by) if ended_by else None,
                "seconds": None if seconds is None else str(seconds),
                "input": parameters(wanted), "output": parameters(outputs or {}),
                "binds": parameters(binds or {})}.items() if value})
            if not type or cost != "1":
                text["cost"] = str(cost)
            if occupies or not type:
                text["occupies"] = list(occupies)
            local = (type or name).split(":")[-1].split("#")[-1]
            self._reception.features[local] = Feature(
                local, run, wanted, frozenset(occupies), text,
                ended_by=ended_by.split(":")[-1] if ended_by else None)
            return run

        return added

    def price(self, name: str, at_least: float = 0.0
              ) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
        """Makes a function the price of a feature: it gets the inputs and returns a ``Price``, or
        raises ``UnknownPrice``. It has 50 ms."""

        def added(asked: Callable[..., Any]) -> Callable[..., Any]:
            offered = self._reception.features[name]
            offered.price = asked
            offered.text["cost"] = {"id": "maestro:asked"}
            offered.text["costAtLeast"] = str(at_least)
            return asked

        return added

    def on_safe(self, action: Callable[[], None]) -> Callable[[], None]:
        """Makes a function one that brings the device into a safe state."""
        self._reception.safe_actions.append(action)
        return action

    def description(self) -> dict[str, Any]:
        """As it is told on the bus."""
        return dict(self._whole) if self._whole else described(
            self.id, self._namespace, self._label, self._types, self._properties,
            [offered.text for offered in self._reception.features.values()], self._words, self._things)

    # --- What is so

    @property
    def values(self) -> list[str]:
        with self._lock:
            return list(self._values)

    def tell(self, *facts: str, instead_of: Iterable[str] = ()) -> None:
        """Says facts of itself, beside those said before; ``instead_of`` are said no more."""
        gone = set(instead_of)
        with self._lock:
            self._values = [fact for fact in self._values if fact not in gone]
            self._values += [fact for fact in facts if fact not in self._values]
            self._tell_state()

    def untell(self, *facts: str) -> None:
        """Says facts no more."""
        self.tell(instead_of=facts)

    def tell_number(self, fluent: str, value: float) -> None:
        """Says a number, ``tell_number("(filled kettle-1)", 0.5)``, instead of what it was."""
        with self._lock:
            before = [fact for fact in self._values if fact.startswith(f"(= {fluent} ")]
            self.tell(f"(= {fluent} {float(value)!r})", instead_of=before)

    # --- On the bus

    def run(self, host: str, port: int = 1883, site: str = "maestro",
            folder: str | Path | None = None) -> None:
        """Joins and stays until ``stop`` is called, or the process ends."""
        self.start(host, port, site, folder)
        try:
            self._left.wait()
        except KeyboardInterrupt:
            self.stop()

    def start(self, host: str, port: int = 1883, site: str = "maestro",
              folder: str | Path | None = None) -> None:
        """Joins, and goes on in threads; ``folder`` is its own of a secured site, users/ID."""
        self._root = f"rats/1/{site}/"
        client = mqtt.Client(
            mqtt.CallbackAPIVersion.VERSION2, self.id, protocol=mqtt.MQTTv5)
        client.will_set(self._own("status"), self._message({
            "id": self.id, "status": "lost", "boot": self.boot}), 1, True)
        if folder is not None:
            own = Path(folder)
            client.username_pw_set(self.id, (own / "password").read_text().strip())
            client.tls_set(ca_certs=str(own / "ca.pem"))
        client.on_connect = self._connected
        client.on_message = self._heard
        client.on_disconnect = self._disconnected
        self._client = client
        client.connect_async(host, port, keepalive=15)
        client.loop_start()

    def stop(self) -> None:
        """Leaves for good: what is retained of it is cleared."""
        client = self._client
        if client is not None and not self._leaves:
            self._leaves = True
            self._reception.make_safe()
            if client.is_connected():
                for part in ("description", "state", "status"):
                    client.publish(self._own(part), b"", 1, True).wait_for_publish(2)
            client.disconnect()
            client.loop_stop()
        self._left.set()

    def _connected(self, client: mqtt.Client, *_: Any) -> None:
        options = SubscribeOptions(1, retainAsPublished=True, retainHandling=2)
        client.subscribe([
            (self._root + "call/#", options),
            (self._root + f"result/{self.id}/#", options),
            (self._own("status"), SubscribeOptions(1, retainAsPublished=True)),
            (self._own("description"), SubscribeOptions(1, noLocal=True, retainHandling=2)),
            (self._root + f"controller/+/verdict/{self.id}", SubscribeOptions(1))])
        self._announce()

    def _disconnected(self, client: mqtt.Client, _: Any, __: Any, reason: Any, ___: Any) -> None:
        if str(reason) == "Session taken over":
            LOG.error("There is another %s; this one leaves. Give it an id of its own.", self.id)
            self._leaves = True
            self._left.set()
            threading.Thread(target=client.loop_stop).start()

    def _announce(self) -> None:
        self._describe()
        self._tell_state()
        self._send("member/" + self.id + "/status", {
            "id": self.id, "status": "ready", "boot": self.boot}, retain=True)

    def _describe(self) -> None:
        self._publish(self._own("description"), json.dumps(self.description()).encode(), True)

    def _tell_state(self) -> None:
        with self._lock:
            if self._client is not None:
                self._send("member/" + self.id + "/state", {
                    "id": self.id, "boot": self.boot, "values": self._values,
                    **self._reception.state()}, retain=True)

    # --- What is heard

    def _heard(self, _: mqtt.Client, __: Any, message: mqtt.MQTTMessage) -> None:
        try:
            topic = message.topic[len(self._root):]
            if topic.startswith("call"):
                self._reception.heard(topic, message)
            elif topic.startswith("result/"):
                self._answered(topic.rsplit("/", 1)[-1], json.loads(message.payload))
            elif topic.startswith("controller/"):
                self._judged(message.payload)
            elif topic.endswith("/description"):
                self._described_by_another()
            else:
                self._said_of_me(message.payload)
        except Exception as fault:  # noqa: BLE001 - rubbish of others must not end it
            LOG.warning("%s heard what it cannot read on %s: %s", self.id, message.topic, fault)

    def _said_of_me(self, payload: bytes) -> None:
        """A will that came late, of this life or another, or another's word, must not stay the last."""
        status = json.loads(payload) if payload else {"status": "lost"}
        if status.get("status") in ("lost", "disconnected") and not self._leaves:
            self._announce()

    def _described_by_another(self) -> None:
        """Who reads that would take the device for what it is not."""
        if not self._leaves:
            self._describe()

    def _judged(self, payload: bytes) -> None:
        self.verdict = json.loads(payload) if payload else None
        if self.verdict and not self.verdict.get("accepted", True):
            for fault in self.verdict.get("faults", []):
                LOG.error("The description is refused: %s %s %s; %s", fault["subject"],
                          fault["property"], fault["problem"], fault["cure"])

    # --- Calls of its own

    def call(self, member: str, feature: str, timeout: float = 10.0, **parameters: Any) -> Result:
        """Calls another member and waits; not from ``price`` functions."""
        with self._lock:
            self._next_call += 1
            identifier = f"{self.id}-{self.boot[:6]}-{self._next_call}"
            done, answers = threading.Event(), []
            self._asked[identifier] = done, answers, member
        self._send("call/" + self.id, {
            "id": identifier, "r": member, "f": feature, "p": parameters,
            "t": max(1, int(timeout * 1000)), "from": self.id}, expiry=timeout)
        done.wait(timeout)
        del self._asked[identifier]
        if not answers:
            return Result("TIMED_OUT", {}, {"code": "TIMEOUT", "message": f"{member} does not answer"})
        return Result(answers[0]["outcome"], answers[0].get("values", {}), answers[0].get("error"))

    def _answered(self, speaker: str, result: Mapping[str, Any]) -> None:
        asked = self._asked.get(result["id"])
        if asked is not None and asked[2] == speaker:
            asked[1].append(dict(result))
            asked[0].set()

    # --- Messages

    def _own(self, part: str) -> str:
        return f"{self._root}member/{self.id}/{part}"

    @staticmethod
    def _message(fields: Mapping[str, Any]) -> bytes:
        return json.dumps({"v": VERSION, **fields}).encode()

    def _send(self, topic: str, fields: Mapping[str, Any], retain: bool = False,
              expiry: float | None = None) -> None:
        self._publish(self._root + topic, self._message(fields), retain, expiry)

    def _publish(self, topic: str, payload: bytes, retain: bool, expiry: float | None = None) -> None:
        properties = None
        if expiry is not None:
            properties = Properties(PacketTypes.PUBLISH)
            properties.MessageExpiryInterval = max(1, int(expiry))
        if self._client is not None:
            self._client.publish(topic, payload, 1, retain, properties)
