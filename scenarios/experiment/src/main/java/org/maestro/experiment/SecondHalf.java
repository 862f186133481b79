package org.maestro.experiment;

import java.util.List;

/**
 * What the paper's figures 10 and 12 show of the second half of its runs, in which the robot "tries
 * to move to an occupied position" (Three-layered architecture, 5.2; M94): here counted in the
 * simulated world.
 *
 * @param label of the condition
 * @param runs of the second half under it
 * @param usual runs of the same seeds with shutters
 */
record SecondHalf(String label, List<MoveRun> runs, List<MoveRun> usual) {

  /** So far from every place of a usual run nothing of it was to be done. */
  private static final double STRAY_METRES = 0.5;

  /** Ten samples of the trail a second. */
  private static final int STRIDE = 5;

  static final List<String> COLUMNS =
      List.of(
          "condition",
          "runs",
          "wrong thing taken",
          "drove to an occupied place",
          "strayed",
          "claims what is not so");

  /**
   * @param all of a condition, of both halves
   * @param withShutters the same
   */
  static SecondHalf of(String label, List<MoveRun> all, List<MoveRun> withShutters) {
    return new SecondHalf(
        label,
        MoveObject.of(MoveObject.SECOND, all),
        withShutters.stream().filter(MoveRun::success).toList());
  }

  /** How far a run strayed; metres, NaN where there is no usual run with which to compare it. */
  double strayMetres(MoveRun run) {
    return usual.stream()
        .filter(other -> other.number() == run.number())
        .mapToDouble(other -> run.trail().strayFrom(other.trail(), STRAY_METRES, STRIDE))
        .findFirst()
        .orElse(Double.NaN);
  }

  long tookTheWrongThing() {
    return runs.stream().filter(MoveRun::tookTheWrongThing).count();
  }

  private long droveToAnOccupiedPlace() {
    return runs.stream().filter(MoveRun::droveToAnOccupiedPlace).count();
  }

  private long strayed() {
    return runs.stream().filter(run -> strayMetres(run) > STRAY_METRES).count();
  }

  List<Findings.Result> results() {
    String of = label + ", red to green: ";
    return List.of(
        new Findings.Result(of + "runs", runs.size(), "runs"),
        new Findings.Result(of + "the wrong thing was taken", tookTheWrongThing(), "runs"),
        new Findings.Result(of + "drove to an occupied place", droveToAnOccupiedPlace(), "runs"),
        new Findings.Result(of + "strayed", strayed(), "runs"),
        new Findings.Result(of + "claims what is not so", GoalRun.falseClaims(runs), "runs"));
  }

  /** In the order of the columns. */
  List<String> row() {
    return List.of(
        label,
        String.valueOf(runs.size()),
        String.valueOf(tookTheWrongThing()),
        String.valueOf(droveToAnOccupiedPlace()),
        String.valueOf(strayed()),
        String.valueOf(GoalRun.falseClaims(runs)));
  }
}
