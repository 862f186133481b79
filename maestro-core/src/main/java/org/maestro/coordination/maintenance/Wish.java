package org.maestro.coordination.maintenance;

import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.GoalRequest;

/** A requested goal, and its standing among the wishes of others. */
public record Wish(String id, GoalRequest request, GoalPriority standing) {}
