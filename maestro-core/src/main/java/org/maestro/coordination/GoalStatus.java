package org.maestro.coordination;

/** A line of the list of goals. */
public record GoalStatus(
    String id, String goal, String requester, GoalState state, String detail) {}
