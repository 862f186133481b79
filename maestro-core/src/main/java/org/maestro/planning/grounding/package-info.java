/**
 * Features bound to the things of a home, backwards from the goal: only steps that change something
 * that matters are made. A task and its facts flow in; a ground problem flows out, and what was
 * made is kept for the next goal. It searches nothing.
 */
@NullMarked
package org.maestro.planning.grounding;

import org.jspecify.annotations.NullMarked;
