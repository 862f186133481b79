/**
 * What goes to and fro, as it is shown: the messages of the bus, and those between agents with
 * their conversations. Messages flow in on any thread and stay in small rings; documents flow out
 * when somebody asks. It knows no server, and takes part in nothing.
 */
@NullMarked
package org.maestro.console.traffic;

import org.jspecify.annotations.NullMarked;
