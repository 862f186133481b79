package org.maestro.coordination;

/** What is wished for, and where that stands among the wishes of others. */
record Wish(String id, GoalRequest request, Standing standing) {}
