package org.maestro.launch;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What of the simulated world can be fitted to something finer. */
@Command(
    name = "calibrate",
    description = "Fit a fast model of the simulated world to a finer one.",
    subcommands = CalibrateCameraCommand.class)
final class CalibrateCommand implements Runnable {
  @Spec private CommandSpec spec;

  @Override
  public void run() {
    throw new ParameterException(
        spec.commandLine(), "Say what to calibrate: calibrate camera HOME.ttl, such as arena");
  }
}
