package org.maestro.launch;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.maestro.assembly.LocalSite;
import org.maestro.console.Console;
import org.maestro.console.Serving;
import org.maestro.console.questions.RefusalException;
import org.maestro.dialogue.Paraphraser;
import org.maestro.rats.security.SiteSecurity;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The option that says where a platform serves its console. */
final class ConsoleOptions {
  private static final String OFF = "off";
  private static final int USUAL_PORT = 7070;

  /** Nobody waits longer to hear that he is not understood. */
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  @Option(
      names = "--console",
      paramLabel = "[HOST:]PORT|off",
      description =
          "Serve the console, a page for people and an API for programs, there; HOST is loopback"
              + " unless it is said, and another one is for secured sites. Without: on 7070, or on"
              + " a free port when that is taken.")
  private Optional<String> wanted = Optional.empty();

  @Mixin private OpinionOptions opinion = new OpinionOptions();

  /** As without the option. */
  static ConsoleOptions usual() {
    return new ConsoleOptions();
  }

  /**
   * Whether it can be.
   *
   * @param secured whether it is a secured site, where persons sign in
   */
  void check(boolean secured) {
    opinion.check();
    if (wanted.isEmpty() || isOff()) {
      return;
    }
    Endpoint at = at(wanted.get());
    if (!secured && !isLoopback(at.host())) {
      throw CommandException.badInput(
          "An open site serves its console on this machine alone, as it asks nobody for a password: leave %s away, or secure the site (./maestro secure, --security)."
              .formatted(at.host()));
    }
  }

  private static Endpoint at(String text) {
    try {
      return Endpoint.listening(text, Serving.LOOPBACK);
    } catch (CommandException e) {
      throw CommandException.badInput(
          "--console takes a port between 0 and 65535, HOST:PORT, or off; not \"" + text + "\".");
    }
  }

  private static boolean isLoopback(String host) {
    try {
      return InetAddress.getByName(host).isLoopbackAddress();
    } catch (UnknownHostException e) {
      throw CommandException.badInput(
          "\"%s\" is no address of this machine; write --console PORT, or HOST:PORT."
              .formatted(host));
    }
  }

  private boolean isOff() {
    return wanted.filter(OFF::equals).isPresent();
  }

  /**
   * Starts it, unless there is to be none.
   *
   * @param data where the platform keeps what is to outlive it
   */
  Optional<Console> start(
      LocalSite site, String name, Optional<SiteSecurity> security, Optional<Path> data) {
    if (isOff() || security.filter(ConsoleOptions::isOfBefore).isPresent()) {
      return Optional.empty();
    }
    if (wanted.isPresent()) {
      return Optional.of(on(site, name, at(wanted.get()), security, data));
    }
    try {
      return Optional.of(
          on(site, name, new Endpoint(Serving.LOOPBACK, USUAL_PORT), security, data));
    } catch (RefusalException e) {
      return Optional.of(on(site, name, new Endpoint(Serving.LOOPBACK, 0), security, data));
    }
  }

  /** Whether its files know nobody who may look at the bus, or sign in. */
  private static boolean isOfBefore(SiteSecurity security) {
    return !security.users().observers().contains(LocalSite.OBSERVER)
        || security.persons().isEmpty();
  }

  private Console on(
      LocalSite site,
      String name,
      Endpoint at,
      Optional<SiteSecurity> security,
      Optional<Path> data) {
    Console console =
        Console.start(
            site.platform(),
            site.observer(),
            name,
            new Serving(
                at.host(),
                at.port(),
                security,
                opinion.paraphraser(PATIENCE).orElse(Paraphraser.NOBODY)),
            data,
            site.isSimulated() ? Optional.of(SimulatedTruth.of(site)) : Optional.empty(),
            Version.number());
    if (site.isSimulated()) {
      site.simulated().facesAreShownBy(console::isFaceShown);
    }
    return console;
  }

  /** Where it is, or why there is none. */
  String inWords(Optional<Console> console) {
    return console
        .map(
            own ->
                "The console, for a browser: "
                    + own.uri()
                    + opinion
                        .server()
                        .map(server -> "\nWhat is not understood there is told " + server + ".")
                        .orElse(""))
        .orElse(
            isOff()
                ? "It has no console (--console off)."
                : "It has no console: the site's files were made before there was one; ./maestro"
                    + " secure DIR adds what it needs.");
  }
}
