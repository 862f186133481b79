package org.maestro.hal;

import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;

/**
 * A named area of the floor on a device's map.
 *
 * @param reference where the light is measured that stands for the whole area
 */
public record Area(String name, Polygon outline, Point2 reference) {}
