package org.maestro.deployment;

import java.util.Optional;

/**
 * A RATS member that an agent stands for.
 *
 * @param member its id on the bus
 * @param description what the agent is configured with, as Turtle or JSON-LD; empty: the agent goes
 *     by what the member says of itself
 */
public record Charge(String member, Optional<String> description) {}
