package org.maestro.hal.sight;

import org.maestro.hal.Position;

/**
 * Something in a picture that may be what was wanted.
 *
 * @param foot where it stands if it is that, and stands on the floor
 * @param confidence 0 to 1: how well its size fits
 */
public record Sighting(Position foot, double confidence) {}
