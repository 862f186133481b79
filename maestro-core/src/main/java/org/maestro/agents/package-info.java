/**
 * The JADE shells around the heart (paper section 3.3.2): the Central Coordination Agent, the
 * generic agent that stands for a RATS member, the knowledge agent, and the desk through which
 * people ask. ACL messages in MAESTRO-SL flow in and out; calls on the heart and on the link carry
 * them on. No decision is made here that a unit test of the heart could not make.
 */
@NullMarked
package org.maestro.agents;

import org.jspecify.annotations.NullMarked;
