package org.maestro.launch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.maestro.language.Language;
import org.maestro.language.grammar.GrammarFaultException;
import org.maestro.ontology.home.Home;
import picocli.CommandLine.Option;

/**
 * The language in which something is said: as asked for, else the person's, the home's, English.
 */
final class SpokenLanguage {
  private static final String FILE_END = ".grammar";

  @Option(
      names = "--language",
      paramLabel = "TAG",
      description =
          "In which language: en, de, one that the home brings, or a grammar's file; that of the"
              + " person or of the home unless stated.")
  private Optional<String> asked = Optional.empty();

  private final Map<String, Language> byTag = new HashMap<>();

  /** The language in which somebody of the home speaks. */
  Language of(Home home, Optional<String> person) {
    return byTag.computeIfAbsent(
        asked.orElseGet(() -> Language.spoken(home, person)), tag -> read(home, tag));
  }

  /** The same, where it is asked for otherwise. */
  static Language of(Home home, Optional<String> asked, Optional<String> person) {
    return read(home, asked.orElseGet(() -> Language.spoken(home, person)));
  }

  private static Language read(Home home, String tag) {
    try {
      if (tag.endsWith(FILE_END)) {
        Path file = Path.of(tag);
        return Language.written(home, Files.readString(file), String.valueOf(file.getFileName()));
      }
      return Language.of(home, tag);
    } catch (IOException e) {
      throw CommandException.badInput(
          "The grammar %s cannot be read; give a file in UTF-8.".formatted(tag));
    } catch (GrammarFaultException | IllegalArgumentException e) {
      throw CommandException.badInput(String.valueOf(e.getMessage()));
    }
  }
}
