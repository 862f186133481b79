package org.maestro.coordination.held;

import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Standing;

/** What is wished for, and where that stands among the wishes of others. */
public record Wish(String id, GoalRequest request, Standing standing) {}
