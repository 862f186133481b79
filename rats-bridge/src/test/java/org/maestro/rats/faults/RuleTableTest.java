package org.maestro.rats.faults;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The table of rules names tests that there are. */
class RuleTableTest {

  private static final Pattern NAMED = Pattern.compile("`(\\w+)#(\\w+)`");

  @Test
  void namesTestsThatThereAre() throws IOException {
    List<String> missing = new ArrayList<>();
    String table = Files.readString(Path.of("..", "docs", "bus-rules.md"));
    for (MatchResult named : NAMED.matcher(table).results().toList()) {
      if (!hasTest(named.group(1), named.group(2))) {
        missing.add(named.group());
      }
    }
    assertThat(missing).isEmpty();
    assertThat(NAMED.matcher(table).results()).hasSizeGreaterThan(40);
  }

  private static boolean hasTest(String type, String method) throws IOException {
    try (Stream<Path> files = Files.walk(Path.of("src", "test", "java"))) {
      for (Path file : files.filter(file -> file.endsWith(type + ".java")).toList()) {
        if (Files.readString(file).contains("void " + method + "(")) {
          return true;
        }
      }
      return false;
    }
  }
}
