package org.maestro.sl;

import java.util.Optional;

/** A quantified variable, {@code ?x - Thing}; without a class it ranges over all individuals. */
public record TypedVariable(String name, Optional<String> className) {}
