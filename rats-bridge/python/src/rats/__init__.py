"""Devices for MAESTRO on the RATS bus: what they are and do in a few lines, the bus by itself."""
from .calls import Canceled, Failed, Refused, TimedOut, UnknownPrice
from .description import Thing, kind, word
from .device import Device, Result
from .features import Price
from .reception import Call

__all__ = [
    "Call", "Canceled", "Device", "Failed", "Price", "Refused", "Result", "Thing", "TimedOut",
    "UnknownPrice", "kind", "word",
]
