package org.maestro.launch;

import java.nio.file.Path;
import java.util.Optional;
import org.maestro.rats.security.SiteSecurity;
import picocli.CommandLine.Option;

/** The files of a secured site, as several commands take them. */
final class SecurityOptions {
  /** The guest as which commands ask unless another is named; every secured site has it. */
  static final String CONSOLE = "console";

  @Option(
      names = "--security",
      paramLabel = "DIR",
      description =
          "The files of a secured site, made by ./maestro secure; without: anybody on the broker is believed.")
  private Optional<Path> directory;

  boolean isAsked() {
    return directory.isPresent();
  }

  Optional<SiteSecurity> files() {
    return directory.map(SiteSecurity::open);
  }
}
