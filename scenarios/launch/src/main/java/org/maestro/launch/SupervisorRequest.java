package org.maestro.launch;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.questions.Questions;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** An order to a running platform that answers nothing. */
abstract class SupervisorRequest implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  abstract CompletableFuture<Void> order(Questions questions);

  /** What is said when it is done, a sentence. */
  abstract String done();

  @Override
  public Integer call() {
    try (AskedPlatform asked = platform.ask()) {
      asked.answer(this::order);
      spec.commandLine().getOut().println(done());
      return ExitCode.DONE;
    }
  }
}
