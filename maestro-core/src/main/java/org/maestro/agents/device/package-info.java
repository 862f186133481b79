/**
 * The parts of a generic agent: a voice for each of its members, its entry in the yellow pages, who
 * may ask for what, and what its container gives to it. News of members and messages flow in;
 * descriptions, presence and answers to calls for prices flow out.
 */
@NullMarked
package org.maestro.agents.device;

import org.jspecify.annotations.NullMarked;
