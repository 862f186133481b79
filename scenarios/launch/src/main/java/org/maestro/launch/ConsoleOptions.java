package org.maestro.launch;

import java.nio.file.Path;
import java.util.Optional;
import org.maestro.assembly.LocalSite;
import org.maestro.console.Console;
import org.maestro.console.questions.RefusalException;
import picocli.CommandLine.Option;

/** The option that says where a platform serves its console. */
final class ConsoleOptions {
  private static final String OFF = "off";
  private static final int USUAL_PORT = 7070;
  private static final int HIGHEST_PORT = 65_535;

  @Option(
      names = "--console",
      paramLabel = "PORT|off",
      description =
          "Serve the console, a page for people and an API for programs, on loopback there."
              + " Without: on 7070, or on a free port when that is taken.")
  private Optional<String> wanted = Optional.empty();

  /** As without the option. */
  static ConsoleOptions usual() {
    return new ConsoleOptions();
  }

  /**
   * Whether it can be.
   *
   * @param secured whether it is a secured site, which lets in only whom it knows
   */
  void check(boolean secured) {
    if (secured && wanted.isPresent() && !isOff()) {
      throw CommandException.badInput("A secured site has no console yet; leave --console away.");
    }
    wanted.filter(text -> !text.equals(OFF)).ifPresent(ConsoleOptions::port);
  }

  private static int port(String text) {
    try {
      int port = Integer.parseInt(text);
      if (port >= 0 && port <= HIGHEST_PORT) {
        return port;
      }
    } catch (NumberFormatException e) {
      throw notAPort(text);
    }
    throw notAPort(text);
  }

  private static CommandException notAPort(String text) {
    return CommandException.badInput(
        "--console takes a port between 0 and 65535, or off; not \"" + text + "\".");
  }

  private boolean isOff() {
    return wanted.filter(OFF::equals).isPresent();
  }

  /**
   * Starts it, unless there is to be none.
   *
   * @param data where the platform keeps what is to outlive it
   */
  Optional<Console> start(LocalSite site, String name, boolean secured, Optional<Path> data) {
    if (secured || isOff()) {
      return Optional.empty();
    }
    if (wanted.isPresent()) {
      return Optional.of(on(site, name, port(wanted.get()), data));
    }
    try {
      return Optional.of(on(site, name, USUAL_PORT, data));
    } catch (RefusalException e) {
      return Optional.of(on(site, name, 0, data));
    }
  }

  private static Console on(LocalSite site, String name, int port, Optional<Path> data) {
    return Console.start(site.platform(), site.observer(), name, port, data, Version.number());
  }

  /** Where it is, or why there is none. */
  String inWords(Optional<Console> console) {
    return console
        .map(own -> "The console, for a browser: " + own.uri())
        .orElse(
            isOff() ? "It has no console (--console off)." : "A secured site has no console yet.");
  }
}
