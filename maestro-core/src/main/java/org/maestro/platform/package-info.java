/**
 * Boots and stops MAESTRO on JADE: main container, topical abstraction containers, the agents in
 * them, and joins from other processes. A home, a link to the bus and a clock flow in; a running
 * platform and desks to ask at flow out. It may not know what agents say to each other.
 */
@NullMarked
package org.maestro.platform;

import org.jspecify.annotations.NullMarked;
