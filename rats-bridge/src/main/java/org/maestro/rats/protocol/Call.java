package org.maestro.rats.protocol;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;

/**
 * A feature call, c = (Id, r, f, p, t) of the paper's section 3.2.3 (M56).
 *
 * @param member r; empty: every member with the feature (M57)
 * @param boot the member's boot it is meant for; another boot refuses it
 * @param parameters p: JSON values, pointers as {@code {"ref": IRI, property: value}} (M58)
 * @param timeout t, covers queueing and execution (M59)
 * @param from who calls
 * @param task the goal it serves
 */
public record Call(
    String id,
    Optional<String> member,
    Optional<String> boot,
    String feature,
    Map<String, Object> parameters,
    Duration timeout,
    String from,
    Optional<String> task) {}
