package org.maestro.launch;

import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.maestro.console.questions.Questions;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** An order to a running platform that names nothing. */
abstract class SupervisorRequest implements Callable<Integer> {
  @Spec private CommandSpec spec;
  @Mixin private PlatformOptions platform;

  private final Function<Questions, CompletableFuture<Void>> order;
  private final String done;

  /**
   * @param done what is said then, a sentence
   */
  SupervisorRequest(Function<Questions, CompletableFuture<Void>> order, String done) {
    this.order = order;
    this.done = done;
  }

  @Override
  public Integer call() {
    try (AskedPlatform asked = platform.ask()) {
      asked.answer(order);
      spec.commandLine().getOut().println(done);
      return ExitCode.DONE;
    }
  }
}
