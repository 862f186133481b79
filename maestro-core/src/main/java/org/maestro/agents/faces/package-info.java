/**
 * The faces at which agents are seen while they speak and listen. What an agent says, hears, feels
 * and answers flows in; calls of those members flow out that are faces where it is heard. Which
 * these are, and what they can do, is said by their descriptions; it knows no kind of room or
 * device, and whether a face is a robot's or is drawn is nothing to it.
 */
@NullMarked
package org.maestro.agents.faces;

import org.jspecify.annotations.NullMarked;
