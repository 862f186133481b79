package org.maestro.launch;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What can be done with one device of whatever maker. */
@Command(
    name = "device",
    description = "Examine a device of your own on the bus.",
    subcommands = DeviceTestCommand.class)
final class DeviceCommand implements Runnable {
  @Spec private CommandSpec spec;

  @Override
  public void run() {
    throw new ParameterException(
        spec.commandLine(),
        "Say what to do: device test URI ID, such as tcp://127.0.0.1:1883 kettle-1");
  }
}
