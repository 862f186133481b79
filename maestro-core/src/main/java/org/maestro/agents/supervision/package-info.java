/**
 * How the supervisor has agents and containers changed, and tells of them. Requests flow in; orders
 * to containers and hosts, tables and one sentence for each end flow out. It does nothing to a
 * container itself.
 */
@NullMarked
package org.maestro.agents.supervision;

import org.jspecify.annotations.NullMarked;
