package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.maestro.language.Language;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;

/** What is shown as one types (A61). */
class TypedWordsTest {
  private static final Home HOME = Shipped.home("evening");

  /** Its lines, without the spaces of the table. */
  private static List<String> typed(String keys, boolean echoes) throws IOException {
    Situation kitchen =
        new Situation(
            HOME,
            SceneFacts.of(HOME, Optional.of(Shipped.scene("glasses", HOME))),
            Optional.of("Dave"),
            Optional.of("kitchen"),
            Optional.empty(),
            OptionalInt.empty(),
            Discourse.NONE);
    StringWriter shown = new StringWriter();
    new TypedWords(
            new StringReader(keys),
            new PrintWriter(shown),
            echoes,
            Language.of(HOME, "en"),
            kitchen)
        .understand();
    return shown.toString().lines().map(line -> line.strip().replaceAll("\\s{2,}", " | ")).toList();
  }

  @Test
  void eachWordIsUnderstoodWhenItIsWritten() throws IOException {
    assertThat(
            typed("put the glass on the floor in the refrigerator\nno, dump it in the sink", false))
        .containsSubsequence(
            "glass | putting | object: glass-1, glass-2; where: ?",
            "floor | putting | object: glass-1, glass-2; where: floor-k | looks at glass-2; looks at"
                + " floor-k",
            "refrigerator | putting | object: glass-2; where: refrigerator | begins (in glass-2"
                + " refrigerator); looks at refrigerator; nods",
            "means | (initCNP (:goal (in glass-2 refrigerator)))",
            "it | putting | object: glass-2; where: ? | looks at glass-2",
            "means | (initCNP (:goal (in glass-2 sink)))");
  }

  @Test
  void whatIsTakenBackIsUnderstoodAnew() throws IOException {
    assertThat(typed("turn off the kitchen light \b\b\b\b\b\bheater \b\b\b\b\b\b\blight \n", true))
        .containsSubsequence(
            "light | puttingOut | object: kitchen-lamp | begins (= (level kitchen-lamp) 0); looks at"
                + " kitchen-lamp; nods",
            "heater",
            "light | puttingOut | object: kitchen-lamp | begins (= (level kitchen-lamp) 0); looks at"
                + " kitchen-lamp; nods",
            "means | (initCNP (:goal (= (level kitchen-lamp) 0)))");
  }

  @Test
  void nothingTypedIsNothingShown() throws IOException {
    assertThat(typed("\n\n\b\b\u0004never read", false)).isEmpty();
  }
}
