package org.maestro.experiment;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.SettingException;
import org.maestro.experiment.setting.Settings;

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

  /**
   * What is set for an experiment.
   *
   * @param given values by name
   * @throws SettingException when one is unknown, changes nothing in this experiment, or has a
   *     value that it may not have
   */
  public static Settings settings(Experiment experiment, Map<String, String> given) {
    given.keySet().stream()
        .filter(name -> !offers(experiment, name))
        .filter(name -> Physics.isNumber(name) || ALL.stream().anyMatch(any -> offers(any, name)))
        .findFirst()
        .ifPresent(
            name -> {
              throw new SettingException(
                  "%s changes nothing in %s; it acts in %s."
                      .formatted(name, experiment.name(), whereItActs(name)));
            });
    return new Settings(experiment.settings(), given);
  }

  private static String whereItActs(String name) {
    List<String> names =
        ALL.stream().filter(any -> offers(any, name)).map(Experiment::name).toList();
    return names.isEmpty()
        ? "none of the experiments"
        : names.stream().collect(Collectors.joining(", "));
  }

  private static boolean offers(Experiment experiment, String name) {
    return experiment.settings().stream().anyMatch(setting -> setting.name().equals(name));
  }
}
