/**
 * The diary of a home, from which the day of each resident is told (ADE, 5; A70): changes of what
 * is known and what is asked for flow in, lines by date flow into files and out again, and a report
 * of one person's day comes of them, also in sentences. It knows no agents and no platform, and
 * decides nothing.
 */
@NullMarked
package org.maestro.diary;

import org.jspecify.annotations.NullMarked;
