package org.maestro.hal;

/**
 * A direction from a face to a thing, against where the face looks straight ahead.
 *
 * @param thing local name of what it looks at
 * @param turn to the face's own left, or, below 0, to its right; degrees, -180 to 180
 * @param rise upwards, or, below 0, downwards; degrees, -90 to 90
 */
public record Gaze(String thing, double turn, double rise) {}
