package org.maestro.ontology.home;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The home files that ship with the launcher. */
final class ShippedHomes {

  private static final Path FOLDER = Path.of("../scenarios/assembly/src/main/resources/homes");

  private ShippedHomes() {}

  static Path file(String name) {
    return FOLDER.resolve(name);
  }

  static String text(String name) {
    try {
      return Files.readString(file(name));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Home bob() {
    return new HomeLoader().load(file("bob.ttl"));
  }

  static Home arena() {
    return new HomeLoader().load(file("arena.ttl"));
  }
}
