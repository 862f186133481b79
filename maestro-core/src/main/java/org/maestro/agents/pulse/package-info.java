/**
 * Heartbeats of containers and agents (Three-layered architecture, 3.3.3; ADE, 3.2; M78, A24, A33,
 * A34): who is alive, suspected or lost, also when a process is frozen, which JADE alone never
 * notices. Signs of life flow from every container to the main container and confirmations back;
 * what is told of them is told to a {@link org.maestro.agents.pulse.Watcher}. They are no messages
 * between agents, and a stepped clock has none. It may not know what the agents are there for.
 */
@NullMarked
package org.maestro.agents.pulse;

import org.jspecify.annotations.NullMarked;
