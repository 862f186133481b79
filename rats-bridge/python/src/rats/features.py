"""What a device can do: its inputs, its price, and how the description tells both."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping

from .calls import Failed, UnknownPrice
from .description import iri


@dataclass(frozen=True)
class Price:
    """In seconds plus weighted energy, and how long it takes."""

    cost: float
    seconds: float | None = None


@dataclass
class Feature:
    """A function of the device that others may call.

    ``text`` is what the description says of it.
    """

    name: str
    run: Callable[..., Any]
    inputs: dict[str, Any]
    occupies: frozenset[str]
    text: dict[str, Any]
    price: Callable[..., Any] | None = None
    ended_by: str | None = None


def parameters(named: Mapping[str, Any]) -> list[dict[str, Any]]:
    return [
        {"name": name, **given} if isinstance(given, Mapping)
        else {"name": name, "types": [iri(given)]}
        for name, given in named.items()]


def plain(parameters: Mapping[str, Any], wanted: Iterable[str]) -> dict[str, Any]:
    """Inputs as Python has them: things by their names."""
    plain = {}
    for name in wanted:
        value = parameters.get(name)
        if isinstance(value, Mapping) and "ref" in value:
            value = str(value["ref"]).rsplit("#", 1)[-1].rsplit("/", 1)[-1]
        plain[name] = value
    return plain


def cost_of(offered: Feature, one: Any) -> dict[str, Any]:
    if offered.price is None:
        stated = offered.text.get("cost", "1")
        try:
            return {"cost": float(stated), "seconds": float(offered.text.get("seconds", stated))}
        except (TypeError, ValueError):
            return {"reason": "the price is the one that the description states"}
    try:
        price = offered.price(**plain(one, offered.inputs))
        return {"cost": price.cost, "seconds": price.cost if price.seconds is None else price.seconds}
    except (UnknownPrice, Failed) as unknown:
        return {"reason": str(unknown)}
