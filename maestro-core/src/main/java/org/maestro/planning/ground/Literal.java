package org.maestro.planning.ground;

/** An atom that has to hold, or that must not. */
public record Literal(Atom atom, boolean positive) {}
