package org.maestro.experiment;

import java.util.List;
import java.util.Optional;

/** All experiments. */
public final class Experiments {
  private static final List<Experiment> ALL =
      List.of(
          new MoveObject(),
          new Illumination(),
          new OverExposure(),
          new JoinLeave(),
          new BrokenCup());

  private Experiments() {}

  public static List<Experiment> all() {
    return ALL;
  }

  public static Optional<Experiment> named(String name) {
    return ALL.stream().filter(experiment -> experiment.name().equals(name)).findFirst();
  }
}
