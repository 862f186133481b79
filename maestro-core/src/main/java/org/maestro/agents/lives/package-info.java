/**
 * The lives of a platform's agents as events: begun, arrived, doubted, ended. What JADE and the
 * signs of life report flows in; whoever counts on agents hears of it, in one order. It may not
 * know who listens, nor why an agent lives where it does.
 */
@NullMarked
package org.maestro.agents.lives;

import org.jspecify.annotations.NullMarked;
