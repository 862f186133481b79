package org.maestro.hal.wheels;

import org.maestro.ontology.floor.Point2;

/**
 * Where a base stands and looks; metres.
 *
 * @param heading of its front, from x towards y; radians
 */
public record Stance(Point2 point, double heading) {}
