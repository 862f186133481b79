package org.maestro.launch;

import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** States a goal in MAESTRO-SL, or follows one that was stated before. */
@Command(name = "goal", description = "Ask a running platform for a goal and follow it live.")
final class GoalCommand extends StatedGoal {
  @Parameters(
      paramLabel = "GOAL",
      description = "In MAESTRO-SL, such as \"(nextTo Cup Bob)\"; with --follow, an id such as G1.")
  private String goal;

  @Option(
      names = "--follow",
      description = "Follow a goal that was stated before, also before a restart.")
  private boolean stated;

  @Override
  String goal() {
    return goal;
  }

  @Override
  boolean wasStated() {
    return stated;
  }
}
