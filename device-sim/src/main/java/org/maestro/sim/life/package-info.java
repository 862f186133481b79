/**
 * Persons who go about of their own accord: from place to place, into doors and out of them, with
 * things that they take and put down elsewhere. Chance and time flow in; walks and deeds in the
 * world flow out. Nothing that a home knows of itself, and no device, is known here.
 */
@NullMarked
package org.maestro.sim.life;

import org.jspecify.annotations.NullMarked;
