package org.maestro.hal.sight;

/**
 * Pixels of a picture that hang together.
 *
 * @param pixels how many they are
 * @param column mean of theirs, from the left; the middle of the first one is 0
 * @param row mean of theirs, from above
 */
record Blob(int pixels, double column, double row) {}
