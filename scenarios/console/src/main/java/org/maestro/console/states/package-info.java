/**
 * The states of a platform's parts, and what each derives from what it depends on (ADE, status
 * derived from heartbeats; A34): the bus, the journal, containers by their signs of life, agents by
 * their containers, members by their agents and by their presence on the bus. What was observed
 * comes in, standings with their reasons go out as a document.
 */
@NullMarked
package org.maestro.console.states;

import org.jspecify.annotations.NullMarked;
