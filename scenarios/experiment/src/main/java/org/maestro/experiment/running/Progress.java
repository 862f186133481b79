package org.maestro.experiment.running;

/** Is told how far an experiment is. */
@FunctionalInterface
public interface Progress {

  /**
   * @param done runs that are over, of all
   * @param line what came of the last one
   */
  void passed(int done, int of, String line);
}
