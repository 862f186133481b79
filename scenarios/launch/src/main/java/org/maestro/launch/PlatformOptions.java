package org.maestro.launch;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.maestro.console.client.HttpQuestions;
import org.maestro.console.questions.Questions;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.guard.Guard;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.Credentials;
import picocli.CommandLine.Option;

/** The options by which a command finds its running platform. */
final class PlatformOptions {
  @Option(
      names = "--platform",
      paramLabel = "NAME",
      description = "The platform of this user with that name; without: the only one.")
  private Optional<String> platform;

  @Option(
      names = "--main",
      paramLabel = "HOST:PORT",
      description = "The platform whose JADE main container listens there.")
  private Optional<String> main;

  @Option(
      names = "--security",
      paramLabel = "DIR",
      description =
          "The files of the secured site; a platform of this user on this machine tells where they are.")
  private Optional<Path> security;

  @Option(
      names = "--user",
      paramLabel = "ID",
      description =
          "As which user of the secured site to ask; unless it is said console, or, where nobody signs in by that name, its first administrator.")
  private Optional<String> user;

  /** Whether there is a platform to talk to. */
  boolean isThere() {
    return main.isPresent() || !RuntimeDirectory.ofUser().running().isEmpty();
  }

  /** Whether the platform that was found there still runs. */
  boolean isStillAt(Endpoint endpoint) {
    return main.isPresent()
        ? endpoint.answers()
        : RuntimeDirectory.ofUser().running().stream()
            .anyMatch(running -> running.port() == endpoint.port());
  }

  Endpoint endpoint() {
    return main.map(Endpoint::parse)
        .orElseGet(
            () -> {
              RuntimeDirectory.Running running = found();
              return new Endpoint(running.host(), running.port());
            });
  }

  private RuntimeDirectory.Running found() {
    List<RuntimeDirectory.Running> running = RuntimeDirectory.ofUser().running();
    List<String> names = running.stream().map(RuntimeDirectory.Running::name).toList();
    if (running.isEmpty()) {
      throw CommandException.outside("No platform runs; start one with ./maestro run bob");
    }
    if (platform.isPresent()) {
      return running.stream()
          .filter(one -> one.name().equals(platform.get()))
          .findFirst()
          .orElseThrow(
              () ->
                  CommandException.badInput(
                      "No platform named %s runs; there are %s."
                          .formatted(platform.get(), String.join(", ", names))));
    }
    if (running.size() > 1) {
      throw CommandException.badInput(
          "Several platforms run (%s); choose one with --platform NAME."
              .formatted(String.join(", ", names)));
    }
    return running.get(0);
  }

  /** Asks it, in the quickest way there is. */
  AskedPlatform ask() {
    return new AskedPlatform(main.isPresent() ? Optional.empty() : console(found()), this::join);
  }

  /** Its console, if it has one and there somebody is known who may ask. */
  private Optional<Questions> console(RuntimeDirectory.Running running) {
    Optional<Path> files = files();
    if (files.isEmpty()) {
      return running.console().map(HttpQuestions::new);
    }
    SiteSecurity site = SiteSecurity.open(files.get());
    Optional<Credentials> person =
        site.console(user()).or(() -> user.isPresent() ? Optional.empty() : site.administrator());
    return person.isEmpty()
        ? Optional.empty()
        : running.console().map(at -> new HttpQuestions(at, person));
  }

  /** Joins it for one question. */
  JoinedContainer join() {
    return join(1);
  }

  /**
   * Joins it, perhaps not for the first time.
   *
   * @param attempt from 1, each another: a container must not have the name of one that is still
   *     ending
   */
  JoinedContainer join(int attempt) {
    Endpoint at = endpoint();
    return JoinedContainer.join(
        Optional.empty(),
        at.host(),
        at.port(),
        "cli-" + ProcessHandle.current().pid() + (attempt == 1 ? "" : "-" + attempt),
        new PacedClock(1),
        files().map(directory -> Guard.open(SiteSecurity.open(directory), user())));
  }

  private String user() {
    return user.orElse(SecurityOptions.CONSOLE);
  }

  private Optional<Path> files() {
    return security.isPresent() || main.isPresent() ? security : found().security().map(Path::of);
  }
}
