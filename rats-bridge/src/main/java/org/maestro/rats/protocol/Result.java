package org.maestro.rats.protocol;

import java.util.Map;
import java.util.Optional;

/**
 * The final outcome of a call from one member.
 *
 * @param id the call's id
 * @param state the member's state z after the call
 * @param error present unless the outcome is SUCCEEDED
 */
public record Result(
    String id,
    String from,
    Outcome outcome,
    String state,
    Map<String, Object> values,
    Optional<RatsError> error) {}
