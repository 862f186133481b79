/**
 * The persons of a home, followed through all of its rooms (ADE, 1 and 5; A2, A74, A84). Facts of
 * the collective knowledge flow in that are cues by the home's description; where each person
 * probably is and is heading flows back, with its confidence. It knows no agents, and no word of a
 * domain.
 */
@NullMarked
package org.maestro.persons;

import org.jspecify.annotations.NullMarked;
