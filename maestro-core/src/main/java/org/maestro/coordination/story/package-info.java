/**
 * The life of a goal in sentences: what was asked for, weighed, begun, learnt, and why it ended so.
 * Decisions, reports and ends flow in; entries of the story, plans as data and the goal's outcome
 * flow out. It tells what others decided, and decides nothing.
 */
@NullMarked
package org.maestro.coordination.story;

import org.jspecify.annotations.NullMarked;
