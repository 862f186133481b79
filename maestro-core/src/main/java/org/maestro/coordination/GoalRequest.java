package org.maestro.coordination;

import org.maestro.sl.Formula;

/**
 * A wish.
 *
 * @param requester who asks: an agent's name
 */
public record GoalRequest(Formula goal, String requester) {}
