package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Who may not have something done is told so in her own language (ADE, 5; A85). */
class RefusedWordsTest {

  private static String told(String words, String person) {
    return Printed.by(
            "understand", words, "--scene", "evening", "--as", person, "--in", "livingroom")
        .lines()
        .filter(line -> line.startsWith("  tells  "))
        .map(line -> line.substring("  tells  ".length()))
        .findFirst()
        .orElse("");
  }

  @Test
  void howFarSomebodyMayGoAndWhoMayGoOnIsTold() {
    assertThat(told("set the volume of the stereo to 80", "Tom"))
        .isEqualTo(
            "Tom, you may set the volume of the stereo to 60 at most; Dave, Grandma or Rose may set"
                + " it higher.");
    assertThat(told("set the volume of the stereo to 60", "Tom")).isEmpty();
    assertThat(told("set the volume of the stereo to 80", "Dave")).isEmpty();
  }

  @Test
  void whatSomebodyMayNotIsTold() {
    assertThat(told("turn on the oven", "Mia"))
        .isEqualTo("Mia, you may not have the oven on; Dave, Grandma or Rose may.");
    assertThat(told("turn off the oven", "Mia")).isEmpty();
    assertThat(told("unlock the front door", "Tom"))
        .isEqualTo("Tom, you may not have the front door unlocked; Dave, Grandma or Rose may.");
    assertThat(told("I'd like a scotch, please.", "Tom"))
        .isEqualTo("Tom, you may not have that; Dave, Grandma or Rose may.");
    assertThat(told("I'd like a scotch, please.", "Dave")).isEmpty();
  }

  @Test
  void itIsTheSameForWhatIsToBeLaterOrOnlyAPart() {
    for (String words :
        List.of(
            "turn on the television and the oven",
            "when Rose comes home, turn on the oven",
            "turn on the oven in ten minutes",
            "every evening at ten turn on the oven")) {
      assertThat(told(words, "Tom"))
          .as(words)
          .isEqualTo("Tom, you may not have the oven on; Dave, Grandma or Rose may.");
    }
  }

  @Test
  void theDocumentHasTheSentence() throws IOException {
    List<String> arguments =
        new ArrayList<>(List.of("understand", "turn on the oven", "--as", "Tom", "--json"));
    assertThat(
            CommandSchemas.valid("understand", Printed.by(arguments.toArray(String[]::new)))
                .path("refusal")
                .asText())
        .startsWith("Tom, you may not");
  }
}
