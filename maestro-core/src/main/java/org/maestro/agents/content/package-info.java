/**
 * The wording of messages: names of agents, and how goals, orders, beliefs, bids and starts are
 * said in MAESTRO-SL. Content flows in and out; what cannot be read is told in one sentence. It
 * sends nothing.
 */
@NullMarked
package org.maestro.agents.content;

import org.jspecify.annotations.NullMarked;
