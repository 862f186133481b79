package org.maestro.launch;

import org.maestro.console.questions.Questions;
import picocli.CommandLine.Command;

/** Brings all devices to a stand. */
@Command(name = "stop", description = "Every device into a safe state, now; the platform stays.")
final class StopCommand extends SupervisorRequest {
  StopCommand() {
    super(Questions::stop, "Every device was told to go into a safe state.");
  }
}
