/**
 * Goals taken up after a coordinator's end: who is waited for, which calls may be asked for again,
 * what was learnt before. A recovery and the members that come back flow in; orders in their former
 * words flow out. It knows nothing of how a goal is planned.
 */
@NullMarked
package org.maestro.coordination.recovery;

import org.jspecify.annotations.NullMarked;
