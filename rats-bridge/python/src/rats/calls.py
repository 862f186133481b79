"""What may become of a call, beside that it succeeds."""
from __future__ import annotations

import json
from typing import Any, Iterable, Mapping


class Failed(Exception):
    """The call was begun and did not succeed. ``message`` is one sentence for people."""

    outcome = "FAILED"
    code = "HARDWARE_FAILURE"
    retriable = False

    def __init__(self, message: str, *, code: str | None = None, hint: str | None = None,
                 refs: Iterable[Mapping[str, Any]] = (), retriable: bool | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.code = code or self.code
        self.hint = hint
        self.refs = [dict(ref) for ref in refs]
        self.retriable = self.retriable if retriable is None else retriable

    def error(self) -> dict[str, Any]:
        error = {"code": self.code, "level": "WARNING", "message": self.message[:8000],
                 "refs": self.refs, "retriable": self.retriable}
        return {**error, "hint": self.hint} if self.hint else error


class Refused(Failed):
    """The call is not begun. ``refs`` name what it needs, such as
    ``{"fact": "(illuminance zone-b)", "need": ">= 72", "have": 62}``."""

    outcome = "REJECTED"
    code = "PRECONDITION_NOT_MET"


class Canceled(Failed):
    """The caller ended the call, or the device is to become safe."""

    outcome = "CANCELED"
    code = "CANCELED"
    retriable = True


class Ended(Failed):
    """Another feature of the device has ended a continuous one, as it was described: that is no
    failure."""

    outcome = "SUCCEEDED"
    code = ""


class TimedOut(Failed):
    """The time that the caller gave is over."""

    outcome = "TIMED_OUT"
    code = "TIMEOUT"
    retriable = True


class UnknownPrice(Exception):
    """The price of a parameter set is not known; the message says why."""


def malformed(call: Mapping[str, Any]) -> tuple[str, str] | None:
    """The code and the reason why a call cannot be taken."""
    if str(call.get("v", "")).split(".")[0] != "1":
        return "UNSUPPORTED_VERSION", f"The version {call.get('v')} is not understood; 1 is"
    if any("\ud800" <= letter <= "\udfff" for letter in json.dumps(call, ensure_ascii=False)):
        return "MALFORMED", "The call holds half a character"
    for name, kinds in (("f", str), ("p", dict), ("from", str), ("t", (int, float))):
        if not isinstance(call.get(name), kinds) or isinstance(call.get(name), bool):
            return "MALFORMED", f"The field {name} is missing, or is not what it has to be"
    return None if call["t"] >= 1 else ("MALFORMED", "The field t has to be 1 at least")
