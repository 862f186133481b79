package org.maestro.coordination.maintenance;

import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.GoalRequest;

/** What is wished for, and where that stands among the wishes of others. */
public record Wish(String id, GoalRequest request, GoalPriority standing) {}
