/**
 * The trace of each goal: what became of it in stories, between agents and on the bus, under the
 * one id that runs through all three. Story entries, agents' messages and messages of the bus flow
 * in as they are seen; one document for a goal flows out. It keeps the latest of the latest goals,
 * and knows nothing of who asks.
 */
@NullMarked
package org.maestro.console.trace;

import org.jspecify.annotations.NullMarked;
