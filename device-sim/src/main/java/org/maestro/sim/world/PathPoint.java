package org.maestro.sim.world;

import java.time.Duration;
import org.maestro.ontology.floor.Point2;

/** A robot's place on its path at a moment of simulated time. */
public record PathPoint(Duration at, Point2 point) {}
