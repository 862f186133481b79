/**
 * What an agent of a room has beside that of a group: it hears what is said there, with the words
 * of its own topics, and passes on to the agents of other rooms what it does not understand. What
 * people say flows in, from the room's members that listen, from whoever else hears it or from
 * another room; what is to be done about it flows to the central agent, or, while there is none, to
 * the room's own manager of goals, and what is answered to the members that speak. It knows no kind
 * of room or device, but the routines by which members listen and speak.
 */
@NullMarked
package org.maestro.agents.rooms;

import org.jspecify.annotations.NullMarked;
