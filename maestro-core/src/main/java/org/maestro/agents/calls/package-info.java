/**
 * What a generic agent's member is asked to do, and at what price: calls over the bus, turned into
 * messages to whoever asked. Orders and questions flow in; progress, reports and prices flow out.
 * It knows nothing of goals.
 */
@NullMarked
package org.maestro.agents.calls;

import org.jspecify.annotations.NullMarked;
