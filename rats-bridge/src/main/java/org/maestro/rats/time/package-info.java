/**
 * Time for everything that waits: one {@link org.maestro.rats.time.Clock} with two kinds. Delays
 * and actions flow in, and the actions run when their simulated time has come. It stands in the
 * lowest module because members, link and coordination share it; it may not know any of them.
 */
@NullMarked
package org.maestro.rats.time;

import org.jspecify.annotations.NullMarked;
