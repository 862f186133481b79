package org.maestro.experiment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.experiment.setting.Setting;
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
          new BrokenCup(),
          new Exploration(),
          new SetUps(SetUps::shipped));

  private Experiments() {}

  public static List<Experiment> all() {
    return ALL;
  }

  public static Optional<Experiment> named(String name) {
    return ALL.stream().filter(experiment -> experiment.name().equals(name)).findFirst();
  }

  /** The one that compares set-ups, with these in the place of the shipped ones. */
  public static Experiment comparing(Comparison comparison) {
    return new SetUps(() -> comparison);
  }

  /** Whether it can compare others than the shipped set-ups. */
  public static boolean compares(Experiment experiment) {
    return experiment instanceof SetUps;
  }

  /**
   * The settings that an experiment was given.
   *
   * @param notes a sentence about each of what was given that changes nothing in it
   */
  public record Chosen(Settings settings, List<String> notes) {}

  /**
   * Sets what acts in the experiment. The same may be given to all experiments: what acts in others
   * only is checked and said.
   *
   * @param given values by name
   * @throws SettingException when one is unknown or has a value that it may not have
   */
  public static Chosen settings(Experiment experiment, Map<String, String> given) {
    Map<String, String> acting = new LinkedHashMap<>(given);
    List<String> notes = new ArrayList<>();
    given.forEach(
        (name, value) -> {
          Optional<Setting> elsewhere = elsewhere(experiment, name);
          if (elsewhere.isPresent()) {
            acting.remove(name);
            notes.add(
                "%s changes nothing in %s; it acts in %s."
                    .formatted(name, experiment.name(), whereItActs(name)));
            new Settings(List.of(elsewhere.get()), Map.of(name, value));
          }
        });
    return new Chosen(new Settings(experiment.settings(), acting), List.copyOf(notes));
  }

  /** What is called so, unless the experiment offers it itself. */
  private static Optional<Setting> elsewhere(Experiment experiment, String name) {
    if (offers(experiment, name)) {
      return Optional.empty();
    }
    return ALL.stream()
        .flatMap(any -> any.settings().stream())
        .filter(setting -> setting.name().equals(name))
        .findFirst();
  }

  private static String whereItActs(String name) {
    return ALL.stream()
        .filter(any -> offers(any, name))
        .map(Experiment::name)
        .collect(Collectors.joining(", "));
  }

  private static boolean offers(Experiment experiment, String name) {
    return experiment.settings().stream().anyMatch(setting -> setting.name().equals(name));
  }
}
