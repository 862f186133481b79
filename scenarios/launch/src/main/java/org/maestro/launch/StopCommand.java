package org.maestro.launch;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.questions.Questions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Brings all devices to a stand, or one. */
@Command(name = "stop", description = "Every device into a safe state, now; the platform stays.")
final class StopCommand extends SupervisorRequest {
  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "MEMBER",
      description = "One device alone, by its name on the bus.")
  private Optional<String> member = Optional.empty();

  @Override
  CompletableFuture<Void> order(Questions questions) {
    return questions.stop(member);
  }

  @Override
  String done() {
    return member
        .map(name -> name + " was told to go into a safe state.")
        .orElse("Every device was told to go into a safe state.");
  }
}
