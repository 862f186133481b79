package org.maestro.launch;

import java.util.concurrent.CompletableFuture;
import org.maestro.console.questions.Questions;
import picocli.CommandLine.Command;

/** Starts the central coordination agent again after it was ended, as in the JADE GUI. */
@Command(
    name = "revive",
    description = "Start the central coordination agent again after it was ended.")
final class ReviveCommand extends SupervisorRequest {
  @Override
  CompletableFuture<Void> order(Questions questions) {
    return questions.revive();
  }

  @Override
  String done() {
    return "The central coordination agent is there again.";
  }
}
