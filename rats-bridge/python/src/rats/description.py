"""What a device says of itself, as JSON-LD."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

CONTEXT = "https://w3id.org/maestro/context.jsonld"
PREFIX = "own"


@dataclass(frozen=True)
class Thing:
    """A thing that the device brings, such as the tea that it can brew."""

    name: str
    type: str
    label: str | None = None


def word(name: str, *arguments: str, number: bool = False, observable: bool = False,
         functional: bool = False, symmetric: bool = False, unit: str | None = None,
         least: float | None = None, derived_when: str | None = None, valid_for: str | None = None,
         label: str | None = None, same_as: str | None = None) -> dict[str, Any]:
    """A predicate of the device's own, or with ``number`` a fluent.

    ``word("served", "?drink - Drink", "?guest - Person")``. ``functional``: of the last argument
    there is one only, such as the place of a thing. ``symmetric``: it holds both ways round.
    ``least``: no value is below it. ``derived_when``: it holds exactly when that formula does.
    ``valid_for``: how long an observation counts, such as ``PT10S``. ``same_as`` names the word of
    the home or of another maker that means the same: ``domain:in``, or an IRI.
    """
    kinds = ["maestro:Fluent" if number else "maestro:Predicate"]
    kinds += ["maestro:Observable"] if observable else []
    kinds += ["owl:FunctionalProperty"] if functional else []
    kinds += ["owl:SymmetricProperty"] if symmetric else []
    declared: dict[str, Any] = {"id": f"{PREFIX}:{name}", "type": kinds, "arguments": list(arguments)}
    more = {"label": label, "equivalentProperty": same_as, "unit": unit, "least": least,
            "derivedWhen": derived_when, "validFor": valid_for}
    declared.update((key, value) for key, value in more.items() if value is not None)
    return declared


def kind(name: str, under: str = "maestro:Thing", same_as: str | None = None) -> dict[str, Any]:
    """A class of the device's own; ``same_as`` as with words. Put it among a device's ``words``."""
    declared = {"id": f"{PREFIX}:{name}", "type": "owl:Class", "subClassOf": under}
    return {**declared, "equivalentClass": same_as} if same_as else declared


def iri(name: str) -> str:
    """A name with its prefix; a bare one is the device's own."""
    return name if ":" in name else f"{PREFIX}:{name}"


def described(identifier: str, namespace: str, label: str, types: Sequence[str],
              properties: Mapping[str, Any], features: Sequence[Mapping[str, Any]],
              words: Sequence[Mapping[str, Any]], things: Sequence[Thing]) -> dict[str, Any]:
    document: dict[str, Any] = {
        "@context": [CONTEXT, {PREFIX: namespace}], "id": f"{PREFIX}:{identifier}",
        "label": label, "type": [iri(name) for name in types], **properties}
    if features:
        document["offers"] = list(features)
    brought = [dict(declared) for declared in words]
    for thing in things:
        brought.append({"id": f"{PREFIX}:{thing.name}", "type": iri(thing.type),
                        "label": thing.label or thing.name})
    if brought:
        document["brings"] = brought
    return document
