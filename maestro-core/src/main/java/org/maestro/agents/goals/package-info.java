/**
 * Coordination as an agent has it: one that bids, orders and hears over the agent's messages, and
 * goals that an agent has of its own accord. Goals, news of members and knowledge flow in; states
 * of goals, and petitions for what an agent cannot do itself, flow out.
 */
@NullMarked
package org.maestro.agents.goals;

import org.jspecify.annotations.NullMarked;
