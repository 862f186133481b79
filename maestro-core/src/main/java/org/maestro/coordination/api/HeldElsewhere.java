package org.maestro.coordination.api;

/**
 * Who has what a step needs: another manager of goals, whose goals have the member's parts for
 * themselves (ADE, 6; A94).
 *
 * @param manager its name, such as that of a room's agent
 * @param goalId the goal for which it has used them the last time
 */
public record HeldElsewhere(String manager, String goalId) {}
