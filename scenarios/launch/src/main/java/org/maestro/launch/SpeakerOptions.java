package org.maestro.launch;

import java.util.Optional;
import java.util.function.Consumer;
import picocli.CommandLine.Option;

/** Who speaks with a running platform, where, and in which language. */
final class SpeakerOptions {
  @Option(names = "--as", required = true, paramLabel = "PERSON", description = "Who speaks.")
  private String person;

  @Option(names = "--in", required = true, paramLabel = "ROOM", description = "In which room.")
  private String room;

  @Option(
      names = "--language",
      paramLabel = "TAG",
      description = "In which language: en or de; that of the person or of the home unless stated.")
  private Optional<String> language = Optional.empty();

  String person() {
    return person;
  }

  String room() {
    return room;
  }

  /**
   * The speaker's conversation with the platform.
   *
   * @param lines takes what is told
   */
  Conversing conversing(AskedPlatform asked, Consumer<String> lines) {
    return new Conversing(asked, person, room, language, lines);
  }
}
