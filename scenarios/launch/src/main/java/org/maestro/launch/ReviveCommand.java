package org.maestro.launch;

import picocli.CommandLine.Command;

/** Starts the central coordination agent again after it was ended, as in the JADE GUI. */
@Command(
    name = "revive",
    description = "Start the central coordination agent again after it was ended.")
final class ReviveCommand extends SupervisorRequest {
  ReviveCommand() {
    super("The central coordination agent is there again.");
  }
}
