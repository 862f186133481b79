package org.maestro.launch;

import java.nio.file.*;
import java.util.*;
import org.junit.jupiter.api.Test;
import org.maestro.language.Language;
import org.maestro.language.wording.GoalWords;

class TryTest {
  @Test
  void t() throws Exception {
    var home = Shipped.home("bob");
    var w = new GoalWords(home, Language.of(home, "de").grammar(), Optional.of("Bob"));
    for (String l : Files.readAllLines(Path.of("/tmp/w/ger/try.txt")))
      System.out.println("EN " + l + "\n   " + w.report(l));
  }
}
