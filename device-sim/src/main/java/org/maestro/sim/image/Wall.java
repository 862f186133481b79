package org.maestro.sim.image;

/** A wall from the floor to a height, between two points of the floor; metres. */
public record Wall(double fromX, double fromY, double toX, double toY, double height) {}
