/**
 * Bad links: what a member says or hears is lost, comes late, or comes twice. It stands between a
 * member and its transport, so that it works over any bus, and knows nothing of the world.
 */
@NullMarked
package org.maestro.sim.link;

import org.jspecify.annotations.NullMarked;
