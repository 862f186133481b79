/**
 * Makes JADE agents run on a stepped clock, so that the same seed gives the same run. Messages
 * between agents become events of the clock, and a ticket keeps the clock from moving until the
 * agent that received one is idle again. It may not know what agents say or do; on a paced clock
 * nothing of it is used.
 */
@NullMarked
package org.maestro.agents.stepping;

import org.jspecify.annotations.NullMarked;
