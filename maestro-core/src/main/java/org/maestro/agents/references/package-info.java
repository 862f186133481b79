/**
 * References of agents to each other (ADE, 3.1 and 3.2; A25, A27, A33): asked for at the registry,
 * which passes the request on, accepted by the one that is asked for, and from then on a matter of
 * these two alone. What comes in of them and the time flow in; signs of life under the keys that
 * both have exchanged flow out, and to their holders whether those are confirmed. It may not know
 * what the agents are there for, nor who may ask for whom.
 */
@NullMarked
package org.maestro.agents.references;

import org.jspecify.annotations.NullMarked;
