package org.maestro.experiment;

import org.maestro.experiment.setting.Settings;

/**
 * The runs, seed and settings with which an experiment is to be carried out.
 *
 * @param runs one or more
 * @param seed of all chance; each run has a seed of its own that follows from it
 * @param paced also repeat runs on the paced clock over the real broker
 */
public record Request(int runs, long seed, Settings settings, boolean paced) {
  private static final long RUNS_OF_A_SEED = 100_000;

  /** The seed of a run, counted from 1; no two runs of any two small seeds share one. */
  public long seedOf(int run) {
    return seed * RUNS_OF_A_SEED + run;
  }

  /** The command that repeats it, as far as it does not stand for usual values. */
  String command(String experiment) {
    StringBuilder command =
        new StringBuilder(
            "./maestro experiment %s --runs %d --seed %d".formatted(experiment, runs, seed));
    settings
        .known()
        .forEach(
            setting -> {
              if (!settings.value(setting).equals(setting.usual())) {
                command.append(" --set ").append(setting.name()).append('=');
                command.append(settings.value(setting));
              }
            });
    return command.append(paced ? " --paced" : "").toString();
  }
}
