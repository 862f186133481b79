/**
 * MAESTRO's side of the RATS bus: who is there, and calls with exactly one outcome each.
 * Descriptions, states and results flow out to listeners, calls flow in. It knows neither agents
 * nor knowledge.
 */
@NullMarked
package org.maestro.rats.link;

import org.jspecify.annotations.NullMarked;
