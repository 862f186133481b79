/**
 * What all agents have in common: mail in MAESTRO-SL, conversations that end, work handed over from
 * other threads, time. Messages and work flow in; each is done on the agent's own thread, one after
 * the other. It knows no kind of agent.
 */
@NullMarked
package org.maestro.agents.runtime;

import org.jspecify.annotations.NullMarked;
