/**
 * On which host an agent runs (ADE, 3.2; A35-A38): what hosts provide, what agents need, and who is
 * chosen; and how often a host that dies again and again is started again. Plain values without
 * threads and containers: what is needed and what is there flow in, a choice flows out.
 */
@NullMarked
package org.maestro.platform.hosts;

import org.jspecify.annotations.NullMarked;
