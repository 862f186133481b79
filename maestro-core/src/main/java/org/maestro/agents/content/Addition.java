package org.maestro.agents.content;

import java.util.Optional;
import java.util.Set;

/**
 * A request to add devices, made by {@code add}.
 *
 * @param description of one device or several, as Turtle or JSON-LD
 * @param source how faults call the description, such as a file's name
 * @param as the name of one agent for all of them; empty: an agent for each
 * @param container empty: the usual one
 */
public record Addition(
    String description,
    String source,
    Optional<String> as,
    Optional<String> container,
    Set<String> needs) {}
