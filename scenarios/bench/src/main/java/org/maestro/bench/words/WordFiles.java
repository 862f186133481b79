package org.maestro.bench.words;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The lists that these benchmarks bring with them. */
final class WordFiles {
  private WordFiles() {}

  static String text(String name) {
    try (InputStream stream = WordFiles.class.getResourceAsStream(name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("The list %s cannot be read.".formatted(name), e);
    }
  }

  /** Its lines but for remarks. */
  static List<String> lines(String name) {
    return text(name).lines().filter(line -> !line.startsWith("#")).toList();
  }
}
