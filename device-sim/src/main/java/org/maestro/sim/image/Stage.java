package org.maestro.sim.image;

import java.util.List;

/** The subject of a picture: a floor in its light, walls and solids. Immutable. */
public record Stage(LitFloor floor, List<Wall> walls, List<Solid> solids) {
  public Stage {
    walls = List.copyOf(walls);
    solids = List.copyOf(solids);
  }
}
