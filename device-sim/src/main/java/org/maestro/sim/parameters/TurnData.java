package org.maestro.sim.parameters;

import java.util.ArrayList;
import java.util.List;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Pose;

/** The views of a camera on a robot that looks around: from its mast, turning with the base. */
public record TurnData(
    @Quantity(meaning = "height of the lens on a robot", unit = "m", source = "assumed")
        double height,
    @Quantity(
            meaning = "how far it is tilted down, so that it sees the floor beside its own base",
            unit = "degrees",
            source = "assumed")
        double downDegrees,
    @Quantity(
            meaning = "part of the angle of view that neighbouring views share",
            unit = "1",
            source = "assumed")
        double overlap,
    @Quantity(
            meaning = "time for turning around once",
            unit = "s",
            source = "youBot data sheet: about 90 degrees a second")
        double seconds) {
  static final TurnData YOUBOT = new TurnData(0.6, 35, 0.4, 4);
  private static final double FULL_CIRCLE = 360;

  /** The poses from which it looks, one after the other. */
  public List<Pose> views(Position at, double viewDegrees) {
    int count = (int) Math.ceil(FULL_CIRCLE / (viewDegrees * (1 - overlap)));
    List<Pose> views = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      views.add(new Pose(at.x(), at.y(), height, i * FULL_CIRCLE / count, -downDegrees, 0));
    }
    return views;
  }
}
