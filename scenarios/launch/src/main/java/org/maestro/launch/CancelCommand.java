package org.maestro.launch;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Gives a goal up. */
@Command(name = "cancel", description = "Give a goal up; what runs ends by its exit strategy.")
final class CancelCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  @Parameters(paramLabel = "GOAL", description = "A goal's id, such as G1.")
  private String goal;

  @Override
  public Integer call() {
    try (AskedPlatform asked = platform.ask()) {
      asked.answer(questions -> questions.cancel(goal));
      spec.commandLine().getOut().println(goal + " is cancelled.");
      return ExitCode.DONE;
    }
  }
}
