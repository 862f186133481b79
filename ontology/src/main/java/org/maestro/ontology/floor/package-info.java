/**
 * Plane geometry of a floor plan: points, outlines, walls with openings, windows' glass, and the
 * shortest ways between them. Numbers in metres flow in, distances and what is blocked flow out. It
 * knows no home, and nothing of what stands in one.
 */
@NullMarked
package org.maestro.ontology.floor;

import org.jspecify.annotations.NullMarked;
